// SPDX-License-Identifier: MIT
// InputAbstractionCheck: refinement of an abstraction after a spurious run.
#include <algorithm>
#include <tuple>

#include "check/inputs/input_check.hpp"
#include "ir/patterns.hpp"

namespace grafverif {

/// Adds the verdict to the task of its next search, which uses `levels`. If `levels` are equal to the levels of `task`,
/// rounded clock bounds may have caused the spurious run, so the next search uses the exact bounds. If the bounds are
/// already exact, or the maximum number of searches is reached, a coarse search is followed by a search in which only
/// autonomous instances are abstracted; other searches are not continued. The next searches of `reachable` properties
/// are combined if they agree in `coarse` and `rounded`.
void InputAbstractionCheck::refine(std::size_t verdict, const Task& task, End end, const Levels& levels,
                                   std::vector<Task>& tasks) const {
    const Property& property = observed_.properties[result_.verdicts[verdict].about];
    Task next{levels, {verdict}, task.rounds + 1, task.coarse, Kind::SingleStates, task.rounded, task.searches + 1};
    const bool is_repeated = levels == task.levels;
    const bool ends = next.rounds == (task.coarse ? limits_.coarse_rounds : limits_.rounds);
    if (end == End::RoundedRun && (is_repeated || (ends && !task.coarse))) {
        next.rounds = is_repeated ? task.rounds : 0;
        next.rounded = false;
    } else if (is_repeated || ends) {
        if (!task.coarse) return;
        next = {first_levels(property, false), {verdict}, 0, false, Kind::SingleStates, task.rounded, next.searches};
    }
    const auto joins = [&](const Task& other) {
        if (other.coarse != next.coarse || other.rounded != next.rounded) return false;
        const Pattern first = observed_.properties[result_.verdicts[other.verdicts.front()].about].pattern;
        const bool both_look = !is_about_all_states(property.pattern) && !is_about_all_states(first);
        return other.levels == next.levels || both_look;
    };
    const auto joined = std::ranges::find_if(tasks, joins);
    if (joined == tasks.end()) return tasks.push_back(std::move(next));
    joined->verdicts.push_back(verdict);
    joined->searches = std::max(joined->searches, next.searches);
    for (std::size_t i = 0; i < next.levels.size(); ++i)
        joined->levels[i] = std::max(joined->levels[i], next.levels[i]);
    if (!ablations_.ignore_readers) store_what_is_read(instances_, joined->levels);
}

/// Searches the complete loop for a run along the abstract run. The first search uses a longer time unit, and the panel
/// moves only as in the abstract run; further searches drop these restrictions.
ConcreteRun InputAbstractionCheck::followed(std::size_t k, const AbstractRun& abstract, bool coarse) const {
    const std::size_t states =
        coarse ? std::clamp<std::size_t>(4 * round_, limits_.followed_coarse, limits_.followed) : limits_.followed;
    ConcreteRun found;
    for (const Network* const network : {&stricter_, &complete_}) {
        const PanelMoves moves = network == &complete_ ? PanelMoves::Any : PanelMoves::OfAbstractRun;
        found = follow(*network, single(k), abstract, moves,
                       {.states = states, .deadline = deadline_, .stop = options_.stop});
        if (found.run) found.run = in_units(*network, std::move(*found.run));
        if (found.run) break;
    }
    return found;
}

/// Returns a run of the complete loop along the abstract run. If no such run is found, stores in `raised` the levels
/// for the next search.
std::optional<Run> InputAbstractionCheck::real_run(std::size_t k, const AbstractRun& abstract, const Task& task,
                                                   Levels& raised) {
    // A guided search is more expensive than a search of a coarse abstraction.
    if (task.coarse && raise_impossible(abstract, true, raised)) return {};
    ConcreteRun found = followed(k, abstract, task.coarse);
    if (found.run) return std::move(found.run);
    if ((!task.coarse && raise_impossible(abstract, true, raised)) || raise_impossible(abstract, false, raised))
        return {};
    for (const std::size_t i : found.blamed)
        if (raised[i] != InputLevel::Complete) raised[i] = next_level(instances_[i], raised[i]);
    if (!ablations_.ignore_readers) store_what_is_read(instances_, raised);
    return {};
}

/// Raises the levels of one group of processes that cannot perform the abstract run. One call raises only one group,
/// because usually only few groups must be raised. The group that cannot perform the shortest suffix of the run has
/// priority, because the last moves usually decide whether the run violates the property; for example, a tank must be
/// empty after 8 s. Among groups with equal suffixes, small groups have priority, then groups whose level is not
/// Chosen, then the group with the earliest impossible position. Returns false if there is no such group.
bool InputAbstractionCheck::raise_impossible(const AbstractRun& abstract, bool waits, Levels& raised) const {
    const std::vector<std::vector<std::size_t>> groups = joint_groups(instances_, abstract.levels);
    const std::vector<std::optional<SpuriousMoves>> found =
        impossible(complete_, abstract, groups, waits, {.deadline = deadline_, .stop = options_.stop});
    if (stopped()) return false;
    const auto rank = [&](std::size_t group) {
        return std::tuple(abstract.path.size() - found[group]->since, groups[group].size(),
                          abstract.levels[groups[group].front()] == InputLevel::Chosen, found[group]->at);
    };
    std::optional<std::size_t> best;
    for (std::size_t group = 0; group < groups.size(); ++group)
        if (found[group] && (!best || rank(group) < rank(*best))) best = group;
    if (!best) return false;
    for (std::size_t m = 0; m < groups[*best].size(); ++m) raised[groups[*best][m]] = found[*best]->levels[m];
    if (!ablations_.ignore_readers) store_what_is_read(instances_, raised);
    return true;
}

}  // namespace grafverif
