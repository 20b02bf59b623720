// SPDX-License-Identifier: MIT
// Evaluates queries about events that are impossible after some points, based on absorbing regions ("traps"), which no
// run leaves. The queries are evaluated when all reachable points are known. Therefore, an event is
// impossible after a point if no path leads from this point to the event. The graph of the points
// contains every run of the chart. The graph also contains spurious runs, in which timers expire in
// an order that is impossible for some or all durations. Therefore, a finding is valid for all
// durations of the timers. The analysis does not find regions that are absorbing only because of
// durations.
//
// If a run aborts in an evolution, or if one of its instants never ends, an event might occur in the unknown
// continuation of the run. Therefore, no finding is reported for points from which an aborting evolution or an endless
// instant is reachable.
//
// An element (a step, transition or stored value) is dead in an absorbing region if its event occurs at no point of the
// region. All regions with the same dead elements form one trap. A trap is reported with a path to a point after which
// all of its dead elements are dead. Two elements are reported with separate paths if each of them can be dead while
// the other element is not dead. An element whose event occurs at most once in a run belongs to a start-up or final
// phase; a finding about such an element is only a note.
#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "analyse/chart_analyzer.hpp"

namespace grafverif::analysis {

namespace {

constexpr std::size_t most_regions = 16;
constexpr std::size_t most_named = 8;

/// Returns a list such as `` `X1`, `X2` and `X3` ``. After the eighth name, only the number of further names is given.
std::string listed(const std::vector<std::string>& names) {
    const std::size_t reported = std::min(names.size(), most_named);
    std::string text;
    for (std::size_t k = 0; k < reported; ++k) {
        if (k > 0) text += k + 1 == names.size() ? " and " : ", ";
        text += "`" + names[k] + "`";
    }
    return names.size() > reported ? text + " and " + std::to_string(names.size() - reported) + " more" : text;
}

}  // namespace

std::vector<ChartAnalyzer::Passing> ChartAnalyzer::passing() {
    std::vector<Passing> all;
    const auto add = [&](Passing::Kind kind, std::string_view code, std::size_t index, Span origin, const auto& comes) {
        if (Query* const question = questions_.open(code, index)) all.push_back({kind, question, origin, comes()});
    };
    for (const Step step : chart_.steps.ids())
        if (machine_.covers_step(step.index))
            add(Passing::Kind::Step, "step-never-again", step.index, chart_.steps[step].origin,
                [&] { return machine_.active(step.index); });
    for (const Transition id : chart_.transitions.ids())
        if (machine_.covers_firing(id.index))
            add(Passing::Kind::Transition, "transition-never-again", id.index, chart_.transitions[id].origin,
                [&] { return machine_.unbroken(machine_.fires(id.index)); });
    for (const Equations::Stored& stored : equations_.stored)
        if (machine_.covers(stored.variable) && machine_.matters(stored.variable))
            add(Passing::Kind::Value, "value-sticks", stored.variable.index,
                equations_.variables[stored.variable].origin,
                [&] { return machine_.unbroken(machine_.changes(stored.variable)); });
    return all;
}

void ChartAnalyzer::find_traps() {
    std::vector<Passing> all = passing();
    Query* const region = questions_.open("region-never-left", 0);
    if (all.empty() && region == nullptr) return;
    const TerminalRegions terminal(machine_, options_.mode, search_);
    Bdd unknown = terminal.reached() & ~machine_.unbroken(terminal.reached());
    if (searching()) unknown |= search_.endless(machine_.transient(terminal.reached()));
    const Bdd sound = terminal.reached() & ~terminal.to(unknown);
    const std::vector<Bdd> regions = terminal.regions(sound, most_regions);
    std::erase_if(all, [&](Passing& each) {
        if (has_dead_points(each, terminal, sound, regions)) return false;
        mark_live(*each.question);
        return true;
    });
    report_never_again(all, terminal, regions);
    if (region != nullptr) report_regions(all, terminal, sound, terminal.reached() & ~unknown, regions.size());
}

/// Records that the event of the query can recur. If the machine represents only a cone, the query remains open,
/// because a cone may have runs that the chart does not have. A query that remains open is decided
/// later on the complete chart, or by a proof that every run of the cone is a run of the chart.
void ChartAnalyzer::mark_live(Query& question) const {
    (machine_.whole() ? question.decided : question.seen_in_part) = true;
}

/// True if the event occurs at some point, but is impossible after another reachable point.
bool ChartAnalyzer::has_dead_points(Passing& each, const TerminalRegions& terminal, const Bdd& sound,
                                    const std::vector<Bdd>& regions) const {
    each.comes &= terminal.reached();
    if (each.comes.is_false()) return false;
    for (const Bdd& region : regions) each.dead_in.push_back((region & each.comes).is_false());
    const bool in_all = std::ranges::find(each.dead_in, true) == each.dead_in.end();
    if (in_all && regions.size() < most_regions) return false;
    const Bdd back = terminal.to(each.comes);
    each.dead_points = sound & ~back;
    const Bdd next = terminal.after(each.comes) & back;
    each.again = !(each.kind == Passing::Kind::Step ? next & ~each.comes : next).is_false();
    return !each.dead_points.is_false();
}

/// Reports all traps. A trap consists of all absorbing regions with the same dead elements.
void ChartAnalyzer::report_never_again(const std::vector<Passing>& dead, const TerminalRegions& terminal,
                                       const std::vector<Bdd>& regions) {
    std::map<std::vector<const Passing*>, Bdd> traps;
    std::set<const Passing*> reported;
    for (std::size_t region = 0; region < regions.size(); ++region) {
        std::vector<const Passing*> here;
        for (const Passing& each : dead)
            if (each.dead_in[region]) here.push_back(&each);
        traps[std::move(here)] |= regions[region];
    }
    for (const auto& [here, region] : traps)
        if (std::ranges::any_of(here, &Passing::again))
            report_trap(here, traps.size() > 1 ? terminal.to(region) : terminal.reached(), terminal, reported);
    std::vector<const Passing*> left;
    for (const Passing& each : dead)
        if (!reported.contains(&each)) left.push_back(&each);
    if (std::ranges::any_of(left, &Passing::again)) report_trap(left, terminal.reached(), terminal, reported);
    std::erase_if(left, [&](const Passing* each) { return reported.contains(each); });
    if (!left.empty()) report_once(left, terminal);
}

/// Reports, in groups, the elements that are dead in a trap. The reported points are in `within`, the set of points
/// from which the trap is reachable. All elements of a group are dead after the point that is reported for the group.
void ChartAnalyzer::report_trap(const std::vector<const Passing*>& dead, const Bdd& within,
                                const TerminalRegions& terminal, std::set<const Passing*>& reported) {
    std::vector<const Passing*> left = dead;
    while (true) {
        const auto leader = std::ranges::find_if(left, &Passing::again);
        if (leader == left.end()) return;
        const Bdd first = (*leader)->dead_points & within;
        Bdd goal = first & terminal.ends();
        if (goal.is_false()) {
            uncertain_.push_back((*leader)->question);
            reported.insert(*leader);
            left.erase(leader);
            continue;
        }
        std::set<const Passing*> group;
        for (const bool shown : {false, true}) {
            if (shown) goal = search_.nearest(goal);
            for (const Passing* each : left) {
                const Bdd both = first & each->dead_points;
                const bool nested = both == first || both == (each->dead_points & within);
                // Each of two elements may be dead at a point where the first element of the group is dead, but both
                // need not be dead at the same point.
                if ((!shown && !nested) || (goal & each->dead_points).is_false()) continue;
                goal &= each->dead_points;
                group.insert(each);
            }
        }
        reported.insert(group.begin(), group.end());
        std::vector<const Passing*> of;
        std::ranges::copy_if(left, std::back_inserter(of), [&](const Passing* each) { return group.contains(each); });
        std::erase_if(left, [&](const Passing* each) { return group.contains(each); });
        report_group(of, terminal, goal);
    }
}

void ChartAnalyzer::report_group(const std::vector<const Passing*>& group, const TerminalRegions& terminal,
                                 const Bdd& goal) {
    std::array<std::vector<std::string>, 3> names;
    for (const Passing* each : group) {
        names[static_cast<std::size_t>(each->kind)].push_back(each->question->subject);
    }
    std::string dead_text;
    for (const auto& [which, never] : {std::pair(names[0], "active"), {names[1], "cleared"}, {names[2], "changed"}})
        if (!which.empty())
            dead_text += (dead_text.empty() ? "" : ", ") + listed(which) + (which.size() == 1 ? " is" : " are") +
                         " never " + never + " again";
    Finding made = finding(group.front()->question->code, group.front()->question->subject,
                           "the chart can reach a situation from which " + dead_text + stays_active(group, goal),
                           group.front()->origin);
    keep_trap(std::move(made), group, terminal, goal);
}

/// Returns text such as `; X99 stays active`, which names the steps that are active in `goal` and that no transition
/// deactivates afterwards.
std::string ChartAnalyzer::stays_active(const std::vector<const Passing*>& dead, const Bdd& goal) {
    const auto is_governed = [](const Chart::PartialChart& partial) { return partial.owner.valid(); };
    if (!chart_.forcing.empty() || std::ranges::any_of(chart_.partial_charts, is_governed)) return {};
    const auto never = [&](Transition id) {
        if (!machine_.covers_firing(id.index)) return false;
        return !seen(machine_.fires(id.index)) || std::ranges::any_of(dead, [&](const Passing* each) {
            return each->kind == Passing::Kind::Transition && each->question->index == id.index;
        });
    };
    std::set<Step> left;
    for (const Transition id : chart_.transitions.ids())
        if (!never(id)) left.insert(chart_.transitions[id].from.begin(), chart_.transitions[id].from.end());
    std::vector<std::string> names;
    for (const Step step : chart_.steps.ids()) {
        if (left.contains(step) || !machine_.covers_step(step.index)) continue;
        const Bdd idle = ~machine_.active(step.index);
        if ((goal & idle).is_false() && seen(idle)) names.push_back(step_name(step));
    }
    return names.empty() ? "" : "; " + listed(names) + (names.size() == 1 ? " stays active" : " stay active");
}

void ChartAnalyzer::report_once(const std::vector<const Passing*>& once, const TerminalRegions& terminal) {
    std::vector<std::string> names, values;  // the initialization of a value in the first evolution is not a change
    for (const Passing* each : once)
        (each->kind == Passing::Kind::Value ? values : names).push_back(each->question->subject);
    std::string words;
    if (!names.empty()) words = listed(names) + (names.size() == 1 ? " occurs" : " occur") + " at most once in a run";
    if (!values.empty())
        words += (words.empty() ? "" : " and ") + listed(values) + (values.size() == 1 ? " changes" : " change") +
                 " at most once after the first evolution";
    Finding made = finding("comes-once", once.front()->question->subject, words + ": only in a start-up or final phase",
                           once.front()->origin);
    keep_trap(std::move(made), once, terminal, once.front()->dead_points & terminal.ends());
}

void ChartAnalyzer::keep_trap(Finding made, const std::vector<const Passing*>& of, const TerminalRegions& terminal,
                              const Bdd& goal) {
    for (const Passing* each : of) made.lost.push_back(each->question->subject);
    const bool several = made.code == "comes-once" && of.size() > 1;
    const std::string shows =
        several ? "after this, `" + made.lost.front() + "` never occurs again" : "no path leads back from here";
    const std::optional<Path> path = search_.path_to(goal & terminal.ends());
    const bool shown = path && show(made, path, {.settles = true}, shows, certain());
    for (const Passing* each : of) {
        if (shown) each->question->decided = true;
        else uncertain_.push_back(each->question);
    }
    if (shown) keep(std::move(made));
}

/// Reports absorbing regions without dead elements. If the complete graph has only one absorbing region, it is reported
/// only if some run clears transitions infinitely often without entering the region.
void ChartAnalyzer::report_regions(const std::vector<Passing>& dead, const TerminalRegions& terminal, const Bdd& sound,
                                   const Bdd& known, std::size_t regions) {
    Query& question = *questions_.open("region-never-left", 0);
    Bdd dead_points;
    for (const Passing& each : dead) dead_points |= each.dead_points;
    const std::vector<Bdd> quiet = terminal.regions(sound & ~terminal.to(dead_points), most_regions);
    if (quiet.empty()) return mark_live(question);
    if (regions == 1) {
        Bdd cleared;
        for (const Transition id : chart_.transitions.ids())
            if (machine_.covers_firing(id.index)) cleared |= machine_.fires(id.index);
        if (terminal.recurring(known & ~quiet.front(), cleared).is_false()) return mark_live(question);
    }
    Finding made =
        finding("region-never-left", "", "the chart can reach a set of situations that it never leaves", chart_.origin);
    Bdd all;
    for (const Bdd& region : quiet) all |= region;
    const std::optional<Path> path = search_.path_to(all & terminal.ends());
    if (path && show(made, path, {.settles = true}, "no path leads back from here", certain()))
        question.decided = keep(std::move(made));
    else uncertain_.push_back(&question);
}

}  // namespace grafverif::analysis
