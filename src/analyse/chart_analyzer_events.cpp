// SPDX-License-Identifier: MIT
// Evaluates the queries whose findings are possible events, such as total instability and races.
#include <algorithm>
#include <utility>

#include "analyse/chart_analyzer.hpp"
#include "analyse/structure.hpp"

namespace grafverif::analysis {

void ChartAnalyzer::expect(std::string_view code, std::size_t index, const Bdd& goal,
                           std::function<bool(const Bdd&)> record) {
    if (Query* const question = questions_.open(code, index))
        events_.push_back({question, goal, false, std::move(record)});
}

// -- total instability ------------------------------------------------------------------------------------------------

void ChartAnalyzer::instability() {
    Query* const question = questions_.open("total-instability", 0);
    if (question == nullptr || is_uncertain(question)) return;
    const Bdd transient = machine_.transient(search_.fresh()), followed = machine_.followed(transient);
    Bdd endless = search_.endless(followed);
    // If there is no instability at points with exact counters, the points at which a counter exceeds its represented
    // values are also considered. An instability at these points may end when the counter reaches the end of its range.
    const bool counting = endless.is_false() && !(followed == transient);
    if (counting) endless = search_.endless(transient);
    if (endless.is_false()) return;
    Finding made = finding("total-instability", "", "", chart_.origin);
    if (!show(made, search_.path_to(endless), {.endless = true}, "with the last inputs, the situation changes forever",
              certain() && !counting))
        return uncertain_.push_back(question);
    const auto loop = last_.endless.size();
    made.message = "with some inputs, the situation never becomes stable";
    if (loop > 0) made.message += "; the situations repeat in a cycle of length " + std::to_string(loop);
    made.message += "; make a transition of the cycle wait for an input change";
    for (const Id<Chart::Transition> id : chart_.transitions.ids())
        if (!(endless & machine_.fires(id.index)).is_false())
            made.related.push_back({chart_.transitions[id].origin, "`" + name(id) + "` is cleared repeatedly"});
    question->decided = keep(std::move(made));
}

// -- races, and values that are undefined or out of range -------------------------------------------------------------

void ChartAnalyzer::expect_breaks() {
    // Queries for which no fault condition exists are also decided at the end of the search: the
    // queries about the stored variables of the cone and, if the cone contains the complete chart,
    // the query about conditions.
    for (const Equations::Stored& stored : equations_.stored)
        if (machine_.covers(stored.variable))
            for (const char* code : {"action-race", "out-of-range", "no-value"})
                expect(code, stored.variable.index, {}, {});
    if (machine_.whole()) expect("no-value", no_variable, {}, {});
    for (const Machine::FaultCondition& each : machine_.all_breaks()) expect_break(each);
}

void ChartAnalyzer::expect_break(const Machine::FaultCondition& each) {
    const std::size_t index = each.variable.valid() ? each.variable.index : no_variable;
    const auto look = [&](std::string_view code, const Bdd& points, const Bdd& first) {
        Query* const question = questions_.open(code, index);
        const Bdd early = first & machine_.possible();
        if (question == nullptr || (points.is_false() && early.is_false())) return;
        if (!early.is_false() && report_fault(code, each, points, early)) question->decided = true;
        else
            expect(code, index, points,
                   [this, code, each, points](const Bdd&) { return report_fault(code, each, points, {}); });
    };
    look("action-race", each.race, each.first_race);
    look("out-of-range", each.out_of_range, each.first_out_of_range);
    look("no-value", each.no_value, each.first_no_value);
    if (each.beyond.is_false()) return;
    if (Query* const question = questions_.open("out-of-range", index))
        expect("out-of-range", index, each.beyond, [question, safe = each.safe](const Bdd&) {
            question->evolutions = safe;
            return false;
        });
}

bool ChartAnalyzer::report_fault(std::string_view code, const Machine::FaultCondition& each, const Bdd& points,
                                 const Bdd& early) {
    const bool known = each.variable.valid();
    const std::string subject = known ? equations_.variables[each.variable].name : "";
    EvolutionRequirement demand{.fault = true};
    std::string message = "a condition or a stored value can divide by zero; guard it with a comparison";
    std::string shows = "the value is undefined in the last evolution";
    if (code == "action-race") {
        demand = {.race = {each.variable.index}};
        message = "two actions can store different values in `" + subject +
                  "` in one evolution; make their conditions exclusive";
        shows = "both actions are executed in the last evolution";
    } else if (code == "out-of-range") {
        message = "an action can store a value in `" + subject +
                  "` that is outside its range; extend the range or guard the action";
        shows = "the value is out of range in the last evolution";
    }
    Finding made = finding(code, subject, message, known ? equations_.variables[each.variable].origin : chart_.origin);
    const std::optional<Path> path = early.is_false() ? search_.path_to(points) : Path{{{machine_.pick(early)}}, true};
    if (!show(made, path, demand, shows, certain())) return false;
    for (const Id<Chart::StoredAction> action : last_.racing)
        made.related.push_back({chart_.stored[action].origin, "this action stores one of the values"});
    if (demand.fault && last_.fault.source.valid()) made.origin = last_.fault;
    return keep(std::move(made));
}

// -- values that are overwritten in their instant ---------------------------------------------------------------------

void ChartAnalyzer::dead_values() {
    if (!searching()) return;
    for (const Equations::Stored& stored : equations_.stored) {
        const Equations::Variable& variable = equations_.variables[stored.variable];
        if (variable.role != Equations::Role::Output || !variable.type.boolean || !machine_.covers(stored.variable))
            continue;
        dead_value(stored, true);
        dead_value(stored, false);
    }
}

/// Searches for a stored value that is overwritten in the same instant. When a new point is examined, all of its
/// successors within its instant have already been found.
void ChartAnalyzer::dead_value(const Equations::Stored& stored, bool value) {
    Query* const question = questions_.open("action-conflict", 2 * stored.variable.index + (value ? 1 : 0));
    if (question == nullptr || is_uncertain(question)) return;
    Bdd stores, overwrites;
    for (const Equations::Write& write : stored.writes) {
        if (!is_constant(equations_.exprs[write.value].op)) continue;
        (is_true(equations_.exprs, write.value) == value ? stores : overwrites) |= machine_.holds(write.trigger);
    }
    std::vector<Bdd> layers{// points whose evolution stores the value, followed by layers of their successors
                            machine_.transient(search_.fresh() & stores)};
    Bdd seen, hit;
    while (!layers.back().is_false() && hit.is_false()) {
        const Bdd next = machine_.transient(machine_.evolved(layers.back()));
        hit = next & overwrites;
        layers.push_back(next & ~seen);
        seen |= next;
    }
    if (hit.is_false()) return;
    std::vector<Point> points{machine_.pick(hit)};
    for (std::size_t k = layers.size() - 1; k-- > 0;)
        points.push_back(
            machine_.pick(machine_.with_inputs_of(machine_.origins(layers[k], points.back()), points.front())));
    std::ranges::reverse(points);
    const Equations::Variable& variable = equations_.variables[stored.variable];
    Finding made = finding("action-conflict", variable.name,
                           "`" + variable.name + "` can be " + (value ? "set and reset" : "reset and set") +
                               " in one instant, so the plant never receives the first value",
                           variable.origin);
    for (const Equations::Write& write : stored.writes)
        made.related.push_back({write.origin, "this action stores a value in the output"});
    if (!show(made, path_along(points), {}, "both values are stored in the last instant", certain()))
        return uncertain_.push_back(question);
    question->decided = keep(std::move(made));
}

// -- situations -------------------------------------------------------------------------------------------------------

void ChartAnalyzer::expect_branches() {
    const auto pairs = branches(chart_);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const auto [first, second] = pairs[k];
        if (!machine_.covers_firing(first.index) || !machine_.covers_firing(second.index)) continue;
        const Bdd both = machine_.fires(first.index) & machine_.fires(second.index);
        expect("branches-together", k, both, [this, first, second](const Bdd& seen) {
            Finding made =
                finding("branches-together", name(first),
                        "`" + name(first) + "` and `" + name(second) +
                            "` leave the same step and can be cleared simultaneously; make their conditions exclusive",
                        chart_.transitions[second].origin);
            made.related.push_back({chart_.transitions[first].origin, "`" + name(first) + "` is here"});
            return show(made, prefer_unbroken(seen), {.fired = {first, second}},
                        "both transitions are cleared in the last instant") &&
                   keep(std::move(made));
        });
    }
}

void ChartAnalyzer::expect_reactivated_steps() {
    std::vector<Bdd> on(chart_.steps.size()), off(chart_.steps.size());
    for (const Transition id : chart_.transitions.ids()) {
        for (const Step step : chart_.transitions[id].to) on[step.index] |= machine_.fires(id.index);
        for (const Step step : chart_.transitions[id].from) off[step.index] |= machine_.fires(id.index);
    }
    for (const Step step : chart_.steps.ids())
        if (machine_.covers_step(step.index))
            expect("step-reactivated", step.index, machine_.active(step.index) & on[step.index] & ~off[step.index],
                   [this, step](const Bdd& seen) { return report_reactivated(step, seen); });
}

bool ChartAnalyzer::report_reactivated(Step step, const Bdd& seen) {
    Finding made =
        finding("step-reactivated", step_name(step),
                "`" + step_name(step) + "` can be activated while it is active, so one activation has no effect",
                chart_.steps[step].origin);
    EvolutionRequirement demand;
    for (const Transition id : chart_.transitions.ids()) {
        if (std::ranges::find(chart_.transitions[id].to, step) == chart_.transitions[id].to.end()) continue;
        if ((seen & machine_.fires(id.index)).is_false()) continue;
        made.related.push_back({chart_.transitions[id].origin, "`" + name(id) + "` activates the step"});
        if (demand.fired.empty()) demand.fired.push_back(id);
    }
    const Bdd goal = seen & machine_.fires(demand.fired.front().index);
    return show(made, prefer_unbroken(goal), demand,
                "`" + name(demand.fired.front()) + "` activates `" + step_name(step) + "` again in the last instant") &&
           keep(std::move(made));
}

void ChartAnalyzer::expect_forcing() {
    for (std::size_t k = 0; k < equations_.conflicts.size(); ++k) {
        if (!machine_.covers(equations_.conflicts[k].condition)) continue;
        expect("forced-twice", k, machine_.conflicts()[k], [this, k](const Bdd& seen) {
            const std::string partial = conflict_subject(chart_, equations_, equations_.conflicts[k]);
            Finding made = finding("forced-twice", partial,
                                   "this and another forcing order that are active at the same time can force `" +
                                       partial + "` into different situations",
                                   equations_.conflicts[k].origin);
            return show(made, seen, {.fault = true}, "both forcing orders become active") && keep(std::move(made));
        });
    }
    const auto governed = orders_on_enclosed(chart_);
    for (std::size_t k = 0; k < governed.size(); ++k) {
        const auto [order, step] = governed[k];
        const Chart::ForcingOrder& forcing = chart_.forcing[order];
        if (!covers({forcing.step, step})) continue;
        expect("forced-and-enclosed", k, all_active({forcing.step, step}),
               [this, &forcing, step = step](const Bdd& seen) {
                   const std::string& partial = chart_.partial_charts[forcing.forced].name;
                   Finding made = finding("forced-and-enclosed", partial,
                                          "`" + partial + "` can be forced by `" + step_name(forcing.step) +
                                              "` while its enclosing step `" + step_name(step) + "` is active",
                                          forcing.origin);
                   made.related.push_back({chart_.steps[step].origin, "`" + step_name(step) + "` is here"});
                   return show(made, seen, {.ends = false}, "both steps are active") && keep(std::move(made));
               });
    }
}

}  // namespace grafverif::analysis
