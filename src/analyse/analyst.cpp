// SPDX-License-Identifier: MIT
// What can happen, and the evidence of all findings.
#include "analyse/analyst.hpp"

#include <algorithm>
#include <utility>

#include "analyse/structure.hpp"

namespace grafverif::analysis {

void Analyst::ask() {
    instability();
    broken_off();
    forcing();
    lost_values();
    branches_together();
    reactivated_steps();
    if (!complete_) return;
    dead_steps();
    dead_transitions();
    immediate_transitions();
    transient_steps();
    silent_outputs();
}

Bdd Analyst::all_active(const std::vector<Step>& steps) const {
    Bdd all = Bdd::constant(true);
    for (const Step step : steps) all &= machine_.active(step.index);
    return all;
}

Bdd Analyst::enabled(Transition transition) const { return all_active(chart_.transitions[transition].from); }

std::string Analyst::steps_text(const std::vector<Step>& steps) const {
    std::string text;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (k > 0) text += k + 1 == steps.size() ? " and " : ", ";
        text += "`" + step_name(steps[k]) + "`";
    }
    return text;
}

Finding Analyst::finding(std::string_view code, std::string subject, std::string message, Span origin) const {
    Finding made;
    made.code = code;
    made.level = std::ranges::find(finding_kinds(), code, &FindingKind::code)->level;
    made.subject = std::move(subject);
    made.message = std::move(message);
    made.origin = origin;
    return made;
}

Evidence& Analyst::show(Finding& finding, const Bdd& goal, const Demand& demand, std::string shows) {
    return show(finding, search_.way(goal), demand, std::move(shows));
}

Evidence& Analyst::show(Finding& finding, const std::optional<Way>& way, const Demand& demand, std::string shows) {
    last_ = {};
    if (!way) return last_;
    last_ = evidence(chart_, equations_, machine_, options_.mode, *way, demand);
    finding.timing = last_.timing;
    if (!last_.failure.empty()) {
        result_.failures.push_back("the evidence of `" + finding.code + "` on `" + finding.subject +
                                   "` does not replay: " + last_.failure);
        return last_;
    }
    finding.evidence_shows = std::move(shows);
    if (last_.timing != Finding::Timing::Unconfirmed) finding.evidence = last_.trace;
    return last_;
}

// -- total instability -------------------------------------------------------------------------------------------------

void Analyst::instability() {
    if (search_.endless().is_false()) return;
    Finding made = finding("total-instability", "", "", chart_.origin);
    const Evidence& shown = show(made, search_.endless(), {.endless = true},
                                 "with the last inputs the situation changes for ever");
    const auto loop = shown.endless.size();
    made.message = "with some inputs the situation never becomes stable";
    if (loop > 0) made.message += "; " + std::to_string(loop) + " situations follow each other for ever";
    made.message += "; let a transition of the loop wait for an input to change";
    for (const Transition id : chart_.transitions.ids())
        if (!(search_.endless() & machine_.fires(id.index)).is_false())
            made.related.push_back({chart_.transitions[id].origin, "`" + name(id) + "` is cleared again and again"});
    keep(std::move(made));
}

// -- races, and values that do not exist or fit --------------------------------------------------------------------------

void Analyst::broken_off() {
    for (const Machine::Break& each : machine_.all_breaks()) broken_off(each);
}

void Analyst::broken_off(const Machine::Break& each) {
    const bool known = each.variable.valid();
    const std::string subject = known ? equations_.variables[each.variable].name : "";
    const Span origin = known ? equations_.variables[each.variable].origin : chart_.origin;
    const auto look = [&](std::string_view code, const Bdd& points, const Bdd& first, const Demand& demand,
                          const std::string& message, const std::string& shows) {
        const Bdd early = first & machine_.possible();
        if (early.is_false() && !seen(points)) return;
        Finding made = finding(code, subject, message, origin);
        std::optional<Way> way;
        if (early.is_false()) way = search_.way(points);
        else way = Way{{{machine_.pick(early)}}, true};
        const Evidence& shown = show(made, way, demand, shows);
        for (const Id<Chart::StoredAction> action : shown.racing)
            made.related.push_back({chart_.stored[action].origin, "this action stores one of the values"});
        if (demand.fault && shown.fault.source.valid()) made.origin = shown.fault;
        keep(std::move(made));
    };
    look("action-race", each.race, each.first_race, {.race = {each.variable.index}},
         "two actions can store different values in `" + subject +
             "` in one evolution; let them exclude each other",
         "both actions run in the last evolution");
    look("out-of-range", each.out_of_range, each.first_out_of_range, {.fault = true},
         "an action can store a value in `" + subject + "` that is outside its range; widen the range or guard the step",
         "the value of the last evolution does not fit");
    look("no-value", each.no_value, each.first_no_value, {.fault = true},
         "a condition or a stored value can divide by zero; guard it by a comparison",
         "the value of the last evolution does not exist");
}

// -- values that are overwritten in their instant -----------------------------------------------------------------------

std::optional<Way> Analyst::way_along(const std::vector<Point>& points) const {
    std::optional<Way> way = search_.way(machine_.only(points.front()));
    if (way) way->instants.back().insert(way->instants.back().end(), points.begin() + 1, points.end());
    return way;
}

void Analyst::lost_values() {
    if (!searching()) return;
    for (const Equations::Stored& stored : equations_.stored) {
        const Equations::Variable& variable = equations_.variables[stored.variable];
        if (variable.role != Equations::Role::Output || !variable.type.boolean) continue;
        lost_value(stored, true);
        lost_value(stored, false);
    }
}

void Analyst::lost_value(const Equations::Stored& stored, bool value) {
    Bdd stores, overwrites;
    for (const Equations::Write& write : stored.writes) {
        if (!is_constant(equations_.exprs[write.value].op)) continue;
        (is_true(equations_.exprs, write.value) == value ? stores : overwrites) |= machine_.holds(write.trigger);
    }
    const Bdd going_on = search_.reached() & ~machine_.stable() & ~machine_.breaks();
    std::vector<Bdd> layers{going_on & stores};   // evolutions that store it, and those after them
    Bdd seen, hit;
    while (!layers.back().is_false() && hit.is_false()) {
        const Bdd next = machine_.evolved(layers.back()) & going_on;
        hit = next & overwrites;
        layers.push_back(next & ~seen);
        seen |= next;
    }
    if (hit.is_false()) return;
    std::vector<Point> points{machine_.pick(hit)};
    for (std::size_t k = layers.size() - 1; k-- > 0;)
        points.push_back(machine_.pick(machine_.with_inputs_of(machine_.origins(layers[k], points.back()), points.front())));
    std::ranges::reverse(points);
    const Equations::Variable& variable = equations_.variables[stored.variable];
    Finding made = finding("action-conflict", variable.name,
                           "`" + variable.name + "` can be " + (value ? "set and reset" : "reset and set") +
                               " in one instant, so that the first of the two never gets out",
                           variable.origin);
    for (const Equations::Write& write : stored.writes)
        made.related.push_back({write.origin, "an action on it"});
    show(made, way_along(points), {}, "both happen in the last instant");
    keep(std::move(made));
}

// -- situations --------------------------------------------------------------------------------------------------------

void Analyst::branches_together() {
    for (const auto& [first, second] : branches(chart_)) {
        const Bdd both = machine_.fires(first.index) & machine_.fires(second.index);
        if (!seen(both)) continue;
        Finding made = finding("branches-together", name(first),
                               "`" + name(first) + "` and `" + name(second) +
                                   "` leave one step and can be cleared at once; make their conditions exclude each other",
                               chart_.transitions[second].origin);
        made.related.push_back({chart_.transitions[first].origin, "`" + name(first) + "` is here"});
        const Bdd good = both & ~machine_.breaks();
        show(made, seen(good) ? good : both, {.fired = {first, second}}, "both are cleared in the last instant");
        keep(std::move(made));
    }
}

void Analyst::reactivated_steps() {
    std::vector<std::vector<Transition>> activating(chart_.steps.size());
    std::vector<Bdd> on(chart_.steps.size()), off(chart_.steps.size());
    for (const Transition id : chart_.transitions.ids()) {
        const Bdd fires = machine_.fires(id.index);
        for (const Step step : chart_.transitions[id].to) {
            on[step.index] |= fires;
            activating[step.index].push_back(id);
        }
        for (const Step step : chart_.transitions[id].from) off[step.index] |= fires;
    }
    for (const Step step : chart_.steps.ids()) {
        const Bdd again = machine_.active(step.index) & on[step.index] & ~off[step.index];
        if (!seen(again)) continue;
        Finding made = finding("step-reactivated", step_name(step),
                               "`" + step_name(step) + "` can be activated while it is active, so that one of the two "
                               "activations is lost",
                               chart_.steps[step].origin);
        Demand demand;
        for (const Transition id : activating[step.index]) {
            if (!seen(again & machine_.fires(id.index))) continue;
            made.related.push_back({chart_.transitions[id].origin, "`" + name(id) + "` activates it"});
            if (demand.fired.empty()) demand.fired.push_back(id);
        }
        const Bdd goal = again & machine_.fires(demand.fired.front().index);
        const Bdd good = goal & ~machine_.breaks();
        show(made, seen(good) ? good : goal, demand,
             "`" + name(demand.fired.front()) + "` activates `" + step_name(step) + "` once more in the last instant");
        keep(std::move(made));
    }
}

void Analyst::forcing() {
    for (std::size_t k = 0; k < equations_.conflicts.size(); ++k) {
        const Bdd& points = machine_.conflicts()[k];
        if (!seen(points)) continue;
        const Span origin = equations_.conflicts[k].origin;
        const auto order = std::ranges::find_if(chart_.forcing, [&](const Chart::ForcingOrder& other) {
            return other.origin.source == origin.source && other.origin.begin == origin.begin;
        });
        const bool known = order != chart_.forcing.end();
        const std::string partial = known ? chart_.partial_charts[order->forced].name : "";
        Finding made = finding("forced-twice", partial,
                               "this order and another one that is active with it can force `" + partial +
                                   "` into different situations",
                               origin);
        show(made, points, {.fault = true}, "both orders become active");
        keep(std::move(made));
    }
    for (const auto& [order, step] : orders_on_enclosed(chart_)) {
        const Chart::ForcingOrder& forcing = chart_.forcing[order];
        const Bdd both = all_active({forcing.step, step});
        if (!seen(both)) continue;
        const std::string& partial = chart_.partial_charts[forcing.forced].name;
        Finding made = finding("forced-and-enclosed", partial,
                               "`" + partial + "` can be forced by `" + step_name(forcing.step) + "` while `" +
                                   step_name(step) + "`, which encloses it, is active",
                               forcing.origin);
        made.related.push_back({chart_.steps[step].origin, "`" + step_name(step) + "` is here"});
        show(made, both, {.ends = false}, "both steps are active");
        keep(std::move(made));
    }
}

}  // namespace grafverif::analysis
