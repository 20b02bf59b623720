// SPDX-License-Identifier: MIT
// InputAbstractionCheck: refinement of an abstraction after a spurious run.
#include <algorithm>
#include <chrono>
#include <tuple>

#include "check/inputs/input_check.hpp"
#include "ir/patterns.hpp"

namespace grafverif {

/// Adds the verdict to the task of its next search, which uses `levels`. If `levels` are equal to the levels of `task`,
/// rounded clock bounds may have caused the spurious run, so the next search uses the exact bounds. If the bounds are
/// already exact, or the maximum number of searches is reached, a coarse search is followed by a search in which only
/// autonomous instances are abstracted; other searches are not continued. The next searches of `reachable` properties
/// are combined if they agree in `coarse` and `rounded`. An alternative is continued only with exact bounds;
/// add_alternatives has added its refinements.
void InputAbstractionCheck::refine(std::size_t verdict, const Task& task, End end, const Levels& levels,
                                   std::vector<Task>& tasks) {
    const Property& property = observed_.properties[result_.verdicts[verdict].about];
    Task next{levels, {verdict}, task.rounds + 1, task.coarse, Kind::SingleStates, task.rounded, task.searches + 1};
    const bool is_repeated = levels == task.levels;
    if (task.alternative) {
        if (end == End::RoundedRun && is_repeated) alternatives_[verdict].add_again({levels, false, *task.alternative});
        return;
    }
    const bool ends = next.rounds == (task.coarse ? limits_.coarse_rounds : limits_.rounds);
    if (end == End::RoundedRun && (is_repeated || (ends && !task.coarse))) {
        next.rounds = is_repeated ? task.rounds : 0;
        next.rounded = false;
    } else if (is_repeated || ends) {
        if (!task.coarse) return;
        next = {first_levels(property, false), {verdict}, 0, false, Kind::SingleStates, task.rounded, next.searches};
    }
    if (const auto found = alternatives_.find(verdict); found != alternatives_.end() && next.coarse)
        found->second.exclude(next.levels);
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
ConcreteRun InputAbstractionCheck::followed(std::size_t k, const AbstractRun& abstract, const Task& task) const {
    std::size_t states = limits_.followed;
    if (task.coarse) states = std::clamp<std::size_t>(4 * round_, limits_.followed_coarse, limits_.followed);
    if (task.alternative) states = std::min(limits_.followed_coarse, limits_.followed);
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

/// Returns a run of the complete loop along the abstract run. If no such run is found, stores in `raised` the levels of
/// possible next searches; the first of them is the preferred one. `raised` is not empty if no run is found. The
/// preferred searches look for runs of the complete loop; alternatives look for a run only if every process can perform
/// the abstract run without additional delays.
std::optional<Run> InputAbstractionCheck::real_run(std::size_t k, const AbstractRun& abstract, const Task& task,
                                                   std::vector<Levels>& raised) {
    // A guided search is more expensive than a search of a coarse abstraction.
    if (task.coarse) raised = raised_if_impossible(abstract, true);
    if (task.alternative)
        for (Levels& levels : raised_if_impossible(abstract, false))
            if (std::ranges::find(raised, levels) == raised.end()) raised.push_back(std::move(levels));
    if (!raised.empty()) return {};
    ConcreteRun found = followed(k, abstract, task);
    if (found.run) return std::move(found.run);
    if (!task.coarse) raised = raised_if_impossible(abstract, true);
    if (raised.empty() && !task.alternative) raised = raised_if_impossible(abstract, false);
    if (!raised.empty()) return {};
    Levels& levels = raised.emplace_back(abstract.levels);
    for (const std::size_t i : found.blamed)
        if (levels[i] != InputLevel::Complete) levels[i] = next_level(instances_[i], levels[i]);
    if (!ablations_.ignore_readers) store_what_is_read(instances_, levels);
    return {};
}

/// For each group of processes that cannot perform the abstract run, returns levels that exclude the run. Each result
/// raises only one group, because usually only few groups must be raised. The group that cannot perform the shortest
/// suffix of the run comes first, because the last moves usually decide whether the run violates the property; for
/// example, a tank must be empty after 8 s. Among groups with equal suffixes, small groups come first, then groups
/// whose level is not Chosen, then the group with the earliest impossible position.
std::vector<InputAbstractionCheck::Levels> InputAbstractionCheck::raised_if_impossible(const AbstractRun& abstract,
                                                                                       bool waits) const {
    const std::vector<std::vector<std::size_t>> groups = joint_groups(instances_, abstract.levels);
    const std::vector<std::optional<SpuriousMoves>> found =
        impossible(complete_, abstract, groups, waits, {.deadline = deadline_, .stop = options_.stop});
    if (stopped()) return {};
    std::vector<std::size_t> order;
    for (std::size_t group = 0; group < groups.size(); ++group)
        if (found[group]) order.push_back(group);
    std::ranges::stable_sort(order, {}, [&](std::size_t group) {
        return std::tuple(abstract.path.size() - found[group]->since, groups[group].size(),
                          abstract.levels[groups[group].front()] == InputLevel::Chosen, found[group]->at);
    });
    std::vector<Levels> raised;
    for (const std::size_t group : order) {
        Levels& levels = raised.emplace_back(abstract.levels);
        for (std::size_t m = 0; m < groups[group].size(); ++m) levels[groups[group][m]] = found[group]->levels[m];
        if (!ablations_.ignore_readers) store_what_is_read(instances_, levels);
    }
    return raised;
}

/// Adds the levels in `raised`, which refine the task, to the alternatives for property k, except the first of them if
/// it is the preferred refinement. Has no effect for a task that is not coarse, and for a property that a run may prove,
/// because the searches for such properties share an abstraction.
void InputAbstractionCheck::add_alternatives(std::size_t k, const Task& task, const std::vector<Levels>& raised) {
    const Property& property = observed_.properties[result_.verdicts[k].about];
    if (limits_.alternatives == 0 || !task.coarse || !is_about_all_states(property.pattern)) return;
    const auto [entry, is_first] = alternatives_.try_emplace(k);
    Alternatives& alternatives = entry->second;
    alternatives.exclude(task.levels);
    if (is_first) alternatives.add({completed(first_levels(property, true)), task.rounded, 0});
    for (std::size_t i = task.alternative ? 0 : 1; i < raised.size(); ++i)
        alternatives.add({raised[i], task.rounded, i + (task.alternative ? *task.alternative + 1 : 0)});
}

/// Raises the instances that are not Chosen to the level Complete. In the first levels for a property, these include the
/// instances that the property reads; a proof often needs only these instances.
InputAbstractionCheck::Levels InputAbstractionCheck::completed(Levels levels) const {
    for (std::size_t i = 0; i < levels.size(); ++i)
        if (levels[i] != InputLevel::Chosen &&
            loop_.processes[instances_[i].process].kind != Network::ProcessKind::Timer)
            levels[i] = InputLevel::Complete;
    if (!ablations_.ignore_readers) store_what_is_read(instances_, levels);
    return levels;
}

/// True if the round permits alternatives and alternatives have not used their share of the time.
bool InputAbstractionCheck::may_search_alternatives() const {
    if (round_ < limits_.alternatives_from) return false;
    const double share = round_ == limits_.alternatives_from ? limits_.first_share : limits_.later_share;
    return alternative_seconds_ < share * (seconds_ + since(round_begin_));
}

/// Searches alternatives for each property whose preferred search has reached the bound of the round, in the order of
/// their costs.
void InputAbstractionCheck::search_alternatives() {
    const std::uint64_t transitions =
        limits_.transitions_of_alternatives * std::min(round_, most_states_of_alternative);
    for (auto& [k, alternatives] : alternatives_) {
        if (!limited_.contains(k)) continue;
        const std::uint64_t end = result_.transitions + transitions;
        for (std::size_t searches = 0; searches < limits_.alternatives; ++searches) {
            if (!alternatives.has_for_round() || !is_open(k) || stopped() || result_.transitions >= end) break;
            if (!may_search_alternatives()) return;
            transitions_left_ = end - result_.transitions;
            const TimePoint begin = std::chrono::steady_clock::now();
            Alternatives::Alternative next = alternatives.take();
            search({.levels = std::move(next.levels),
                    .verdicts = {k},
                    .coarse = true,
                    .rounded = next.rounded,
                    .alternative = next.cost});
            alternative_seconds_ += since(begin);
        }
    }
}

}  // namespace grafverif
