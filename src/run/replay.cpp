// SPDX-License-Identifier: MIT
#include "run/replay.hpp"

#include <algorithm>
#include <variant>
#include <vector>

#include "run/interpreter.hpp"
#include "run/program/controller_replay.hpp"
#include "run/scan_replay.hpp"

namespace grafverif {

namespace {

using Values = std::vector<std::int64_t>;

std::string number(std::int64_t value) { return std::to_string(value); }

std::string listed(const std::vector<std::string>& names) {
    std::string text = "{";
    for (const std::string& name : names) text += (text.size() == 1 ? "" : ", ") + name;
    return text + "}";
}

/// Replays one controller of the run on its chart.
class ControllerReplay {
public:
    ControllerReplay(const ChartRun& run, const ChartRun::Controller& controller, const Chart& chart)
        : run_(run),
          controller_(controller),
          chart_(chart),
          elements_(timed_elements(chart)),
          state_(power_on(chart)),
          scans_(run, controller) {
        inputs_.resize(chart.variables.size());
        timed_.resize(elements_.size());
        for (std::size_t k = 0; k < elements_.size(); ++k) timers_.push_back(timer_of(k));
    }

    /// Lets time pass. Returns an error message if the task cycle does not allow this delay, otherwise an empty string.
    std::string pass(std::int64_t milliseconds) {
        state_ = pass_time(std::move(state_), milliseconds);
        return over_ ? "" : scans_.pass(milliseconds);
    }

    /// Returns the differences between the run and the rules, or an empty string if they agree.
    std::string does(const ChartRun::Act& act, const ChartRun::State& before, const ChartRun::State& after) {
        if (over_) return {};
        if (std::string fault = scans_.act(act, before); !fault.empty()) return fault;
        if (act.starts || act.samples) read_inputs(act);
        if (act.samples)
            if (std::string fault = timers_fault(); !fault.empty()) return fault;
        bool writes = act.writes == ChartRun::Act::Writes::Yes;
        std::optional<bool> stable;
        if (act.starts || act.evolves) {
            evolutions_ += act.evolves ? 1 : 0;
            Evolution result = evolve(chart_, state_, inputs_, timed_, ended(act));
            writes = writes || (act.writes == ChartRun::Act::Writes::IfStable && result.stable);
            if (act.evolves) stable = result.stable;
            if (std::string fault = evolution_fault(act, result, after); !fault.empty() || over_) return fault;
        }
        scans_.done(stable, writes);
        if (writes) return outputs_fault(act, after);
        return act.starts ? "" : kept_fault(before, after);
    }

    std::size_t evolutions() const { return evolutions_; }
    /// True if the run has a race, and the interpreter confirms it with a race or a run-time fault. Events after the
    /// race are not compared.
    bool raced() const { return raced_; }
    const std::string& racing() const { return racing_; }
    const std::string& name() const { return controller_.name; }

private:
    /// Returns the index, among the controller's timers, of the timer for the element.
    std::optional<std::size_t> timer_of(std::size_t element) const {
        const TimedElement& wanted = elements_[element];
        if (wanted.watched.valid()) return controller_.conditions[element];
        for (std::size_t k = 0; k < controller_.timers.size(); ++k) {
            const ChartRun::Timer& timer = run_.timers[controller_.timers[k]];
            if (timer.step == wanted.step.index && timer.rise_ms == wanted.rise_ms && timer.fall_ms == 0) return k;
        }
        return {};
    }

    /// Visits the variables of one kind, in the order of the controller's signals of the same kind.
    template <class Visit>
    void each(Chart::VariableKind kind, Visit visit) const {
        std::size_t place = 0;
        for (const Id<Chart::Variable> id : chart_.variables.ids())
            if (chart_.variables[id].kind == kind) visit(id, place++);
    }

    void read_inputs(const ChartRun::Act& act) {
        each(Chart::VariableKind::Input,
             [&](Id<Chart::Variable> id, std::size_t place) { inputs_[id.index] = act.inputs[place]; });
        for (std::size_t k = 0; k < timers_.size(); ++k)
            timed_[k] = act.samples && timers_[k] && act.timers[*timers_[k]];
    }

    /// Returns an error message if a timer has expired too early, or has not expired although its duration has elapsed.
    /// At exactly the end of the duration, both values of the timer output are accepted.
    std::string timers_fault() const {
        for (std::size_t k = 0; k < timers_.size(); ++k) {
            if (!timers_[k] || !run_.timers[controller_.timers[*timers_[k]]].exact) continue;
            const TimedElement& element = elements_[k];
            const Timing& timing = state_.timing[k];
            const bool lasts = timing.risen >= 0 && timing.risen >= element.rise_ms;
            const bool remains = element.fall_ms > 0 && timing.fallen >= 0 && timing.fallen <= element.fall_ms;
            const bool just_over = element.rise_ms > 0 && timing.risen == element.rise_ms;
            const bool may = lasts || remains;
            const bool must = (lasts && !just_over) || (remains && timing.fallen < element.fall_ms);
            if (timed_[k] ? may : !must) continue;
            return "the timer of " + number(element.rise_ms > 0 ? element.rise_ms : element.fall_ms) + " ms of " +
                   watched_name(element) + " is " + (timed_[k] ? "expired" : "not expired") +
                   ", but its age according to the rules is " +
                   number(timing.fallen < 0 ? timing.risen : timing.fallen) + " ms";
        }
        return {};
    }

    std::string watched_name(const TimedElement& element) const {
        if (element.step.valid()) return step_variable(chart_, element.step);
        const Expr& node = chart_.exprs[element.watched];
        if (node.op != Op::Step) return "the watched term";
        return step_variable(chart_, {static_cast<std::uint32_t>(node.value)});
    }

    /// Returns, for each timed element, true if its rise time t1 has elapsed. A timer may expire during a cycle, after
    /// the sampling of inputs and before the evolution.
    std::vector<bool> ended(const ChartRun::Act& act) const {
        if (act.done.empty()) return timed_;
        std::vector<bool> ended;
        for (const std::optional<std::size_t>& timer : timers_) ended.push_back(timer && act.done[*timer]);
        return ended;
    }

    std::string evolution_fault(const ChartRun::Act& act, Evolution& result, const ChartRun::State& after) {
        std::vector<std::string> recorded, computed;
        for (const Id<ChartRun::Transition> id : act.fired) recorded.push_back(run_.transitions[id].name);
        for (const Id<Chart::Transition> id : result.fired) computed.push_back(chart_.transitions[id].name);
        if (act.evolves && recorded != computed)
            return "transitions cleared: " + listed(recorded) + ", but according to the rules " + listed(computed);
        if (act.stable && !result.race && !result.fault && *act.stable != result.stable)
            return std::string("the situation is ") + (*act.stable ? "stable" : "not stable") +
                   ", but according to the rules it is " + (result.stable ? "stable" : "not stable");
        if (std::string fault = race_fault(act, result); !fault.empty() || over_) return fault;
        state_ = std::move(result.state);
        if (std::string fault = situation_fault(after); !fault.empty()) return fault;
        return stored_fault(after);
    }

    /// Compares races and faults. If one evolution has several faults, the order of their detection is unspecified.
    std::string race_fault(const ChartRun::Act& act, const Evolution& result) {
        const bool broken = result.race || result.fault;
        // A model without race flags continues after a race, but the interpreter does not.
        over_ = broken && act.race.value_or(true);
        raced_ = over_ && act.race.has_value();
        if (result.race) racing_ = chart_.variables[result.race->variable].name;
        if (over_ || (!broken && !act.race.value_or(false))) return {};
        if (result.race) return "no race, but according to the rules two actions race for " + racing_;
        return broken ? "no model error, but according to the rules a model error ends the evolution"
                      : "two actions race, but according to the rules there is no race";
    }

    std::string situation_fault(const ChartRun::State& now) const {
        std::vector<std::string> recorded, computed;
        for (const Id<Chart::Step> id : chart_.steps.ids()) {
            const Id<ChartRun::Step> step = controller_.steps[id.index];
            if (std::ranges::binary_search(now.situation, step)) recorded.push_back(run_.steps[step].name.text());
            if (state_.situation[id.index]) computed.push_back(run_.steps[step].name.text());
        }
        if (recorded == computed) return {};
        return "situation " + listed(recorded) + ", but according to the rules " + listed(computed);
    }

    std::string stored_fault(const ChartRun::State& now) const {
        std::string fault;
        const auto compare = [&](const std::vector<Id<ChartRun::Signal>>& signals) {
            return [&](Id<Chart::Variable> id, std::size_t place) {
                if (!signals[place].valid() || !fault.empty()) return;
                const std::int64_t value = now.values[signals[place].index];
                if (value != state_.values[id.index])
                    fault = chart_.variables[id].name + " holds " + number(value) + ", but according to the rules " +
                            number(state_.values[id.index]);
            };
        };
        each(Chart::VariableKind::Internal, compare(controller_.internals));
        each(Chart::VariableKind::Output, compare(controller_.images));
        return fault;
    }

    std::string outputs_fault(const ChartRun::Act& act, const ChartRun::State& now) const {
        const std::optional<Values> outputs = output_values(chart_, state_, inputs_, timed_);
        if (!outputs) return act.race ? "outputs are written, but according to the rules they have no value" : "";
        std::string fault;
        each(Chart::VariableKind::Output, [&](Id<Chart::Variable> id, std::size_t place) {
            if (fault.empty()) fault = output_fault(place, now, (*outputs)[id.index]);
        });
        return fault;
    }

    std::string kept_fault(const ChartRun::State& before, const ChartRun::State& now) const {
        for (std::size_t place = 0; place < controller_.outputs.size(); ++place)
            if (std::string fault = output_fault(place, now, before.values[controller_.outputs[place].index]);
                !fault.empty())
                return fault;
        return {};
    }

    std::string output_fault(std::size_t place, const ChartRun::State& now, std::int64_t expected) const {
        const Id<ChartRun::Signal> signal = controller_.outputs[place];
        const std::int64_t value = now.values[signal.index];
        if (value == expected) return {};
        return "output " + run_.signals[signal].name + " is " + number(value) + ", but according to the rules " +
               number(expected);
    }

    const ChartRun& run_;
    const ChartRun::Controller& controller_;
    const Chart& chart_;
    std::vector<TimedElement> elements_;
    State state_;
    ScanReplay scans_;
    Values inputs_ = {};            ///< sampled value of each variable of the chart
    std::vector<bool> timed_ = {};  ///< sampled value of the time condition of each element
    /// Index of the timer of each timed element; empty if it has no timer.
    std::vector<std::optional<std::size_t>> timers_ = {};
    std::size_t evolutions_ = 0;
    bool over_ = false, raced_ = false;
    std::string racing_ = {};  ///< name of the variable of the race
};

using Replay = std::variant<ControllerReplay, ProgramControllerReplay>;

Replay replay_of(const ChartRun& run, const ChartRun::Controller& controller, const Chart& chart) {
    if (chart.program) return ProgramControllerReplay(run, controller, *chart.program);
    return ControllerReplay(run, controller, chart);
}

/// Replays the run with `replays`, one per controller, up to the first disagreement or race.
std::optional<Disagreement> replay(const ChartRun& run, std::span<const Chart* const> charts,
                                   std::vector<Replay>& replays) {
    replays.reserve(run.controllers.size());
    for (const Id<ChartRun::Controller> id : run.controllers.ids())
        replays.push_back(replay_of(run, run.controllers[id], *charts[id.index]));
    const auto name = [](const Replay& replay) { return std::visit([](const auto& of) { return of.name(); }, replay); };
    const ChartRun::State* before = &run.moments.front().after;
    for (const ChartRun::Event& moment : run.moments) {
        const std::int64_t passed = moment.after.time_ms - before->time_ms;
        if (run.timed && passed > 0)
            for (Replay& replay : replays)
                if (std::string what = std::visit([&](auto& of) { return of.pass(passed); }, replay); !what.empty())
                    return Disagreement{moment.move, "controller " + name(replay), std::move(what)};
        for (const ChartRun::Act& act : moment.acts) {
            Replay& replay = replays[act.controller.index];
            if (std::string what = std::visit([&](auto& of) { return of.does(act, *before, moment.after); }, replay);
                !what.empty()) {
                const auto count = std::visit([](const auto& of) { return of.evolutions(); }, replay);
                return Disagreement{moment.move, "controller " + name(replay) + ", evolution " + std::to_string(count),
                                    std::move(what)};
            }
            if (std::visit([](const auto& of) { return of.raced(); }, replay)) return {};
        }
        before = &moment.after;
    }
    if (run.broken_at) return Disagreement{*run.broken_at, "the network", "the move is not possible in this state"};
    return {};
}

}  // namespace

std::optional<Disagreement> disagreement(const ChartRun& run, std::span<const Chart* const> charts) {
    std::vector<Replay> replays;
    return replay(run, charts, replays);
}

std::optional<ContradictoryActions> clash(const ChartRun& run, std::span<const Chart* const> charts) {
    std::vector<Replay> replays;
    if (replay(run, charts, replays)) return {};
    for (const Replay& one : replays) {
        const auto* const chart = std::get_if<ControllerReplay>(&one);
        const auto* const program = std::get_if<ProgramControllerReplay>(&one);
        if (chart != nullptr && chart->raced()) return ContradictoryActions{chart->name(), chart->racing(), {}};
        if (program != nullptr && program->raced()) return ContradictoryActions{program->name(), "", program->fault()};
    }
    return {};
}

namespace {

std::optional<UntimelyConditions> untimely(const ChartRun& run, const ChartRun::Act& act,
                                           const ChartRun::State& before) {
    const ChartRun::Controller& controller = run.controllers[act.controller];
    for (std::size_t over = 0; over < act.timers.size(); ++over)
        for (std::size_t not_over = 0; not_over < act.timers.size(); ++not_over) {
            const ChartRun::Timer& longer = run.timers[controller.timers[over]];
            const ChartRun::Timer& shorter = run.timers[controller.timers[not_over]];
            const bool same = longer.step && longer.step == shorter.step && longer.fall_ms == 0 && shorter.fall_ms == 0;
            if (!same || shorter.rise_ms >= longer.rise_ms || !act.timers[over] || act.timers[not_over]) continue;
            const Id<ChartRun::Step> step = controller.steps[*longer.step];
            if (std::ranges::binary_search(before.situation, step))
                return UntimelyConditions{run.steps[step].name, longer.rise_ms, shorter.rise_ms};
        }
    return {};
}

}  // namespace

std::optional<UntimelyConditions> untimely(const ChartRun& run) {
    for (std::size_t i = 1; !run.timed && i < run.moments.size(); ++i)
        for (const ChartRun::Act& act : run.moments[i].acts)
            if (auto found = untimely(run, act, run.moments[i - 1].after)) return found;
    return {};
}

}  // namespace grafverif
