// SPDX-License-Identifier: MIT
#include "grafverif/run/replay_system.hpp"

#include <algorithm>
#include <cassert>

#include "grafverif/run/interpreter.hpp"

namespace grafverif {

namespace {

using System = TransitionSystem;
using SymbolValues = std::vector<std::int64_t>;   ///< per symbol of main

std::string joined_names(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "{" : ", ") + name;
    return text.empty() ? "{}" : text + "}";
}

/// One controller of the system beside its chart.
class SystemTwin {
public:
    SystemTwin(const System& system, const System::Controller& controller, const Chart& chart)
        : system_(system), controller_(controller), chart_(chart), state_(power_on(chart)) {
        inputs_.resize(chart.variables.size());
        for (const System::Named& output : controller.outputs) outputs_.push_back(variable(output.name));
        for (const System::Named& internal : controller.internals) internals_.push_back(variable(internal.name));
        for (const System::Named& input : controller.inputs) input_variables_.push_back(variable(input.name));
        const std::vector<TimedElement> elements = timed_elements(chart);
        for (std::size_t k = 0; k < elements.size(); ++k) timers_.push_back(timer_of(elements[k], k));
        timed_.resize(timers_.size());
    }

    /// Before the first state, where the first evolution shows in nothing and is no step of the system.
    std::string begin(const SymbolValues& first) {
        if (controller_.starts.valid()) return {};
        return evolved(evolve(chart_, state_, inputs_, timed_), first, first, false);
    }

    /// The step of the system from `before` to `after`; what the system has that the rules do not give.
    std::string step(const SymbolValues& before, const SymbolValues& after) {
        if (over_) return {};
        const bool evolves = holds(controller_.evolves, before, true);
        if (holds(controller_.starts, before, false)) {
            sample(before);
            timed_.assign(timed_.size(), false);
            return evolved(evolve(chart_, state_, inputs_, timed_), before, after, false);
        }
        if (holds(controller_.samples, before, evolves)) sample(before);
        if (!evolves) return holds(controller_.writes, before, false) ? written(after) : kept_outputs(before, after);
        Evolution result = evolve(chart_, state_, inputs_, timed_);
        std::vector<std::string> theirs, ours;
        for (const System::Named& transition : controller_.transitions)
            if (before[transition.symbol.index] != 0) theirs.push_back(transition.name);
        for (const Id<Chart::Transition> id : result.fired) ours.push_back(chart_.transitions[id].name);
        if (theirs != ours)
            return "transitions cleared: " + joined_names(theirs) + ", by the rules " + joined_names(ours);
        return evolved(std::move(result), before, after, true);
    }

private:
    Id<Chart::Variable> variable(const std::string& name) const {
        const auto found = std::ranges::find(chart_.variables, name, &Chart::Variable::name);
        assert(found != chart_.variables.end());
        return {static_cast<std::uint32_t>(found - chart_.variables.begin())};
    }

    /// The timer that tells whether `element` is over, if anything waits for it.
    std::optional<std::size_t> timer_of(const TimedElement& element, std::size_t index) const {
        if (element.watched.valid()) return controller_.conditions[index];
        const auto found = std::ranges::find_if(controller_.timers, [&](const System::TimerEnd& timer) {
            return timer.step == element.step.index && timer.rise_ms == element.rise_ms && timer.fall_ms == 0;
        });
        if (found == controller_.timers.end()) return {};
        return static_cast<std::size_t>(found - controller_.timers.begin());
    }

    bool holds(Id<Expr> condition, const SymbolValues& values, bool otherwise) const {
        return condition.valid() ? value_in(system_, values, condition) != 0 : otherwise;
    }

    void sample(const SymbolValues& now) {
        for (std::size_t i = 0; i < input_variables_.size(); ++i)
            inputs_[input_variables_[i].index] = now[controller_.inputs[i].symbol.index];
        for (std::size_t i = 0; i < timers_.size(); ++i)
            timed_[i] = timers_[i] && now[controller_.timers[*timers_[i]].symbol.index] != 0;
    }

    std::string evolved(Evolution result, const SymbolValues& before, const SymbolValues& after, bool in_cycle) {
        over_ = result.race || result.fault;   // the system goes on, with a flag set; the rules do not
        if (over_) return {};
        state_ = std::move(result.state);
        std::vector<std::string> theirs, ours;
        for (std::size_t i = 0; i < controller_.steps.size(); ++i) {
            if (after[controller_.steps[i].symbol.index] != 0) theirs.push_back(controller_.steps[i].name);
            if (state_.situation[i]) ours.push_back(controller_.steps[i].name);
        }
        if (theirs != ours) return "situation " + joined_names(theirs) + ", by the rules " + joined_names(ours);
        for (std::size_t i = 0; i < internals_.size(); ++i)
            if (after[controller_.internals[i].symbol.index] != state_.values[internals_[i].index])
                return differs(controller_.internals[i], after, state_.values[internals_[i].index]);
        // A step that evolves and writes at once writes nothing as long as the search for stability goes on.
        const bool due = controller_.mode == ExecutionMode::EveryCycle || (in_cycle && result.stable);
        if (due && holds(controller_.writes, before, true)) return written(after);
        return in_cycle ? kept_outputs(before, after) : std::string();
    }

    std::string written(const SymbolValues& after) const {
        const auto outputs = output_values(chart_, state_, inputs_, timed_);
        if (!outputs) return {};   // a division by zero: the flag of the system says so
        for (std::size_t i = 0; i < outputs_.size(); ++i)
            if (after[controller_.outputs[i].symbol.index] != (*outputs)[outputs_[i].index])
                return differs(controller_.outputs[i], after, (*outputs)[outputs_[i].index]);
        return {};
    }

    std::string kept_outputs(const SymbolValues& before, const SymbolValues& after) const {
        for (const System::Named& output : controller_.outputs)
            if (before[output.symbol.index] != after[output.symbol.index])
                return differs(output, after, before[output.symbol.index]);
        return {};
    }

    static std::string differs(const System::Named& named, const SymbolValues& values, std::int64_t expected) {
        return named.name + " is " + std::to_string(values[named.symbol.index]) + ", by the rules " +
               std::to_string(expected);
    }

    const System& system_;
    const System::Controller& controller_;
    const Chart& chart_;
    State state_;
    std::vector<std::int64_t> inputs_ = {};   ///< as sampled, per variable of the chart
    std::vector<bool> timed_ = {};            ///< as sampled, per timed element
    std::vector<Id<Chart::Variable>> input_variables_ = {}, outputs_ = {}, internals_ = {};
    std::vector<std::optional<std::size_t>> timers_ = {};   ///< per timed element
    bool over_ = false;
};

}  // namespace

std::optional<Disagreement> disagreement(const System& system, std::span<const Chart* const> charts,
                                         const SystemRun& run) {
    std::vector<SystemTwin> twins;
    for (std::size_t i = 0; i < system.controllers.size(); ++i)
        twins.emplace_back(system, system.controllers[i], *charts[i]);
    const auto found = [&](std::size_t step, std::size_t twin, std::string what) {
        return Disagreement{step, "controller " + system.controllers[twin].name, std::move(what)};
    };
    for (std::size_t twin = 0; twin < twins.size(); ++twin)
        if (std::string what = twins[twin].begin(run.states.front()); !what.empty()) return found(0, twin, what);
    for (std::size_t i = 0; i < run.states.size(); ++i) {
        const bool last = i + 1 == run.states.size();
        if (last && !run.loop) break;
        for (std::size_t twin = 0; twin < twins.size(); ++twin) {
            std::string what = twins[twin].step(run.states[i], run.states[last ? *run.loop : i + 1]);
            if (!what.empty()) return found(i, twin, what);
        }
    }
    return {};
}

namespace {

std::optional<Untimely> untimely(const System::Controller& controller, const SymbolValues& sampled) {
    for (const System::TimerEnd& longer : controller.timers)
        for (const System::TimerEnd& shorter : controller.timers) {
            const bool same = longer.step && longer.step == shorter.step && longer.fall_ms == 0 && shorter.fall_ms == 0;
            if (!same || shorter.rise_ms >= longer.rise_ms) continue;
            const System::Named& step = controller.steps[*longer.step];
            if (sampled[step.symbol.index] != 0 && sampled[longer.symbol.index] != 0 && sampled[shorter.symbol.index] == 0)
                return Untimely{step.name, longer.rise_ms, shorter.rise_ms};
        }
    return {};
}

}  // namespace

std::optional<Untimely> untimely(const System& system, const SystemRun& run) {
    if (system.ticks.valid()) return {};
    for (std::size_t i = 0; i < run.states.size(); ++i) {
        if (i + 1 == run.states.size() && !run.loop) break;   // no step leaves it
        for (const System::Controller& controller : system.controllers) {
            const Id<Expr> samples = controller.samples.valid() ? controller.samples : controller.evolves;
            if (samples.valid() && value_in(system, run.states[i], samples) == 0) continue;
            if (auto found = untimely(controller, run.states[i])) return found;
        }
    }
    return {};
}

}  // namespace grafverif
