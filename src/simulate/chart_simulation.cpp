// SPDX-License-Identifier: MIT
#include "simulate/chart_simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "run/manual_situation.hpp"
#include "run/project.hpp"
#include "run/reader.hpp"
#include "run/scanner.hpp"
#include "simulate/called.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/dialect.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif {

namespace {

/// Returns the term that a timer observes, in the notation of conditions, if the term is a name such as `X2` or `a`;
/// otherwise an empty string.
std::string watched_text(const Chart& chart, const TimedElement& element) {
    if (element.step.valid()) return step_variable(chart, element.step);
    const Expr& term = chart.exprs[element.watched];
    if (term.op == Op::Step) return step_variable(chart, {static_cast<std::uint32_t>(term.value)});
    if (term.op == Op::Variable) return chart.variables[{static_cast<std::uint32_t>(term.value)}].name;
    return {};
}

std::optional<std::size_t> watched_step(const Chart& chart, const TimedElement& element) {
    if (element.step.valid()) return element.step.index;
    const Expr& term = chart.exprs[element.watched];
    return term.op == Op::Step ? std::optional(static_cast<std::size_t>(term.value)) : std::nullopt;
}

}  // namespace

ChartSimulation::ChartSimulation(const Chart& chart, ExecutionMode mode, Detail detail)
    : chart_(chart), mode_(mode), detail_(detail), elements_(timed_elements(chart)) {
    power_on();
}

void ChartSimulation::power_on() {
    state_ = grafverif::power_on(chart_);
    time_ms_ = 0;
    broken_ = false;
    what_if_row_.reset();
    inputs_.assign(chart_.variables.size(), 0);
    for (const Id<Chart::Variable> id : chart_.variables.ids())
        inputs_[id.index] = std::clamp<std::int64_t>(0, chart_.variables[id].type.low, chart_.variables[id].type.high);
    recorded_run_ = project(chart_, mode_);
    ChartRun::Controller& controller = recorded_run_.controllers[{0}];
    for (std::size_t k = 0; k < elements_.size(); ++k) {
        const TimedElement& element = elements_[k];
        controller.timers.push_back(
            recorded_run_.timers.add({chart_.name, watched_text(chart_, element), watched_step(chart_, element),
                                      element.rise_ms, element.fall_ms, true}));
        if (k < chart_.time_conditions.size()) controller.conditions.emplace_back(k);
    }
    teller_.emplace(recorded_run_, detail_);
    add({});
}

void ChartSimulation::add(ChartRun::Event moment) {
    moment.move = recorded_run_.moments.size();
    moment.after = project(chart_, state_, inputs_, time_ms_);
    recorded_run_.moments.push_back(std::move(moment));
    teller_->catch_up();
}

ChartRun ChartSimulation::with_trace_rows(Detail detail) const {
    ChartRun run = recorded_run_;
    run.rows.clear();
    return with_rows(std::move(run), detail);
}

std::vector<Id<Expr>> ChartSimulation::broken_by(const std::vector<std::int64_t>& inputs) const {
    std::vector<Id<Expr>> broken;
    const std::vector<bool> timed = time_conditions(chart_, state_);
    Reader reader(chart_, state_, inputs, timed, nullptr);
    for (const Chart::Constraint& constraint : chart_.constraints)
        if (reader.value(constraint.condition) == 0) broken.push_back(constraint.condition);
    return broken;
}

std::vector<Setting> ChartSimulation::settings() const {
    std::vector<Setting> list;
    if (broken_) return list;
    const std::size_t broken_now = broken_by(inputs_).size();
    for (const Id<Chart::Variable> id : chart_.variables.ids()) {
        const Chart::Variable& variable = chart_.variables[id];
        if (variable.kind != Chart::VariableKind::Input) continue;
        for (const std::int64_t value : {inputs_[id.index] + 1, inputs_[id.index] - 1}) {
            std::vector<std::int64_t> changed = inputs_;
            changed[id.index] = value;
            if (value < variable.type.low || value > variable.type.high) continue;
            if (broken_by(changed).size() <= broken_now) list.push_back({variable.name, value});
        }
    }
    return list;
}

std::vector<Choice> ChartSimulation::choices() const {
    std::vector<Choice> list;
    for (const Setting& setting : settings()) {
        const auto found = std::ranges::find(chart_.variables, setting.name, &Chart::Variable::name);
        const std::string value = !found->type.boolean ? std::to_string(setting.value)
                                  : setting.value != 0 ? "true"
                                                       : "false";
        const std::string line = setting.name + " = " + value;
        list.push_back({line, line});
    }
    return list;
}

DelayBounds ChartSimulation::delay_bounds() const {
    std::int64_t unit = 0;
    for (const TimedElement& element : elements_) unit = std::gcd(std::gcd(unit, element.rise_ms), element.fall_ms);
    if (unit == 0) unit = 1000;
    const std::optional<std::int64_t> end = next_end();
    return {unit, !broken_, {}, end ? std::optional(std::max<std::int64_t>(*end / unit, 1)) : std::nullopt};
}

std::vector<std::string> ChartSimulation::violated_constraints() const {
    std::vector<std::string> broken;
    for (const Id<Expr> condition : broken_by(inputs_))
        broken.push_back(expr_text(chart_.exprs, condition, chart_spelling, [&](std::ostream& out, const Expr& leaf) {
            out << chart_.variables[{static_cast<std::uint32_t>(leaf.value)}].name;
        }));
    return broken;
}

/// Returns an act of the controller. If `reads` is true, the act samples the inputs and timer outputs.
ChartRun::Act ChartSimulation::act_of(bool reads) const {
    ChartRun::Act act{.controller = {0}};
    for (const Id<Chart::Variable> id : chart_.variables.ids())
        if (chart_.variables[id].kind == Chart::VariableKind::Input) act.inputs.push_back(inputs_[id.index]);
    act.samples = reads;
    if (reads) act.timers = time_conditions(chart_, state_);
    return act;
}

/// Appends rows for the evolutions of the PLC cycle `made` with their situations, and for the outputs that are written
/// at its end.
void ChartSimulation::add_evolution_rows(const Cycle& made) {
    for (std::size_t k = 0; k < made.fired.size(); ++k) {
        const bool first = !state_.started;
        ChartRun::Act act = act_of(!first);
        act.begins = k == 0;
        act.starts = first;
        act.evolves = !first;
        Evolution evolution = evolve(chart_, state_, inputs_, time_conditions(chart_, state_));
        for (const Id<Chart::Transition> id : evolution.fired) act.fired.push_back({id.index});
        if (!first) act.stable = evolution.stable;
        act.race = false;
        state_ = std::move(evolution.state);
        ChartRun::Event moment;
        moment.acts.push_back(std::move(act));
        add(std::move(moment));
    }
    ChartRun::Act write = act_of(true);
    write.writes = ChartRun::Act::Writes::Yes;
    state_ = made.state;
    ChartRun::Event moment;
    moment.acts.push_back(std::move(write));
    add(std::move(moment));
}

std::string ChartSimulation::cycle() {
    const Cycle made = grafverif::cycle(chart_, state_, inputs_, mode_);
    std::string problem = problem_in(chart_, made);
    broken_ = !problem.empty();
    if (!broken_) add_evolution_rows(made);
    return problem;
}

/// Executes PLC cycles until a cycle changes nothing. If each cycle is one evolution, Brent's cycle detection finds
/// infinite sequences.
std::string ChartSimulation::follow() {
    State kept = state_;
    std::vector<std::vector<bool>> since_kept;
    std::size_t evolutions = 0;
    for (std::size_t power = 1; !broken_;) {
        const State before = state_;
        if (std::string problem = cycle(); !problem.empty()) return problem;
        if (state_ == before) return {};
        since_kept.push_back(state_.situation);
        Cycle unstable{.state = {}};
        if (state_ == kept) unstable.endless = since_kept;
        unstable.gave_up = ++evolutions > evolution_limit;
        broken_ = unstable.gave_up || state_ == kept;
        if (broken_) return problem_in(chart_, unstable);
        if (since_kept.size() < power) continue;
        kept = state_;
        since_kept.clear();
        power *= 2;
    }
    return {};
}

std::string ChartSimulation::settle() {
    std::string problem = follow();
    teller_->flush();
    return problem;
}

/// Returns the time until the next delay of a timer elapses, or nothing if no delay is running.
std::optional<std::int64_t> ChartSimulation::next_end() const {
    std::optional<std::int64_t> soonest;
    const auto offer = [&](std::int64_t left) {
        if (left > 0) soonest = std::min(soonest.value_or(left), left);
    };
    for (std::size_t k = 0; k < elements_.size(); ++k) {
        const Timing& timing = state_.timing[k];
        if (timing.risen >= 0) offer(elements_[k].rise_ms - timing.risen);
        if (timing.fallen >= 0) offer(elements_[k].fall_ms - timing.fallen);
    }
    return soonest;
}

void ChartSimulation::pass(std::int64_t milliseconds) {
    const std::vector<bool> before = time_conditions(chart_, state_);
    state_ = pass_time(std::move(state_), milliseconds);
    time_ms_ += milliseconds;
    add({.kind = ChartRun::Kind::Delay});
    const std::vector<bool> after = time_conditions(chart_, state_);
    for (std::uint32_t k = 0; k < elements_.size(); ++k)
        if (before[k] != after[k]) add({.kind = ChartRun::Kind::Timer, .timer = {k}, .timer_holds = after[k]});
}

std::string ChartSimulation::make(const Made& command) {
    if (broken_) return "no further event is possible; undo the last command with `back`";
    commands_.push_back(command);
    std::string problem;
    std::visit(overloaded{
                   [&](const std::vector<Setting>& settings) {
                       ChartRun::Event moment{.kind = ChartRun::Kind::Environment};
                       for (const Setting& setting : settings) {
                           const auto found = std::ranges::find(chart_.variables, setting.name, &Chart::Variable::name);
                           const auto index = static_cast<std::uint32_t>(found - chart_.variables.begin());
                           if (std::exchange(inputs_[index], setting.value) != setting.value)
                               moment.changed.push_back({index});
                       }
                       add(std::move(moment));
                       problem = follow();
                   },
                   [&](std::int64_t milliseconds) {
                       while (milliseconds > 0 && problem.empty()) {
                           const std::int64_t step = std::min(milliseconds, next_end().value_or(milliseconds));
                           pass(step);
                           milliseconds -= step;
                           problem = follow();
                       }
                   },
                   [&](const WhatIfRun& trial) {
                       put(trial);
                       problem = follow();
                   },
               },
               command);
    teller_->flush();
    return problem;
}

std::string ChartSimulation::choose(std::size_t choice) { return make(std::vector{settings()[choice]}); }

std::string ChartSimulation::wait(std::int64_t milliseconds) { return make(milliseconds); }

std::string ChartSimulation::wait() {
    const std::optional<std::int64_t> end = next_end();
    return end ? make(*end) : "nothing changes as time passes; write `wait` with a duration";
}

std::string ChartSimulation::refusal(const Setting& setting) const {
    const auto found = std::ranges::find(chart_.variables, setting.name, &Chart::Variable::name);
    if (found == chart_.variables.end() || found->kind != Chart::VariableKind::Input) {
        std::vector<std::string> inputs;
        for (const Chart::Variable& variable : chart_.variables)
            if (variable.kind == Chart::VariableKind::Input) inputs.push_back(variable.name);
        return unknown_name_text("input", setting.name, inputs);
    }
    return range_text(setting.name, found->type, setting.value);
}

std::string ChartSimulation::set(const std::vector<Setting>& settings) {
    for (const Setting& setting : settings)
        if (std::string problem = refusal(setting); !problem.empty()) return problem;
    const auto is_so = [&](const Setting& setting) {
        const auto found = std::ranges::find(chart_.variables, setting.name, &Chart::Variable::name);
        return inputs_[static_cast<std::size_t>(found - chart_.variables.begin())] == setting.value;
    };
    if (std::ranges::all_of(settings, is_so)) return fmt::format("`{}` already has this value", settings.front().name);
    return make(settings);
}

std::string ChartSimulation::act(std::string_view instance, std::string_view) {
    return fmt::format("a chart alone has no plant, so `{}` is not available; set inputs with `NAME = VALUE`",
                       instance);
}

std::string ChartSimulation::force(std::string_view step, bool active) {
    std::string problem;
    const std::optional<WhatIfRun> trial = what_if_of(recorded_run_, step, active, problem);
    if (!trial) return problem;
    const ManualSituation made = by_hand(chart_, state_.situation, {static_cast<std::uint32_t>(trial->step)}, active);
    if (!made.refusal.empty()) return made.refusal;
    if (!with_situation(chart_, state_, made.situation, inputs_))
        return "the change would make a time condition undefined, for example because its operand divides by zero";
    return make(*trial);
}

/// Executes a change of a step's activity that the user has forced. Requires that by_hand accepts the change.
void ChartSimulation::put(const WhatIfRun& trial) {
    ManualSituation made = by_hand(chart_, state_.situation, {static_cast<std::uint32_t>(trial.step)}, trial.active);
    if (auto state = with_situation(chart_, state_, std::move(made.situation), inputs_)) state_ = std::move(*state);
    add({.kind = ChartRun::Kind::Environment, .internal = true});
    const std::size_t row = report_what_if(recorded_run_, *teller_, trial);
    what_if_row_ = what_if_row_.value_or(row);
}

bool ChartSimulation::back() {
    if (commands_.empty()) return false;
    std::vector<Made> shorter = std::move(commands_);
    shorter.pop_back();
    commands_.clear();
    power_on();
    settle();
    for (const Made& command : shorter) make(command);
    return true;
}

}  // namespace grafverif
