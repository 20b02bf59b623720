// SPDX-License-Identifier: MIT
#include "grafverif/report/tell_system.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "grafverif/support/overloaded.hpp"
#include "grafverif/syntax/dialect.hpp"
#include "report/words.hpp"

namespace grafverif {

namespace {

using System = TransitionSystem;
using Values = std::vector<std::int64_t>;   ///< per symbol of main

class SystemTeller {
public:
    SystemTeller(const System& system, const SystemRun& run, Detail detail)
        : system_(system), run_(run), detail_(detail), shown_(run.states.front()) {
        trace_.timed = system.ticks.valid();
        make_signals();
    }

    Trace told() {
        add({.kind = Trace::Kind::Controller,
             .component = system_.controllers.size() == 1 ? system_.controllers.front().name : system_.name,
             .what = "power on"});
        for (std::size_t step = 0; step + 1 < run_.states.size(); ++step) tell_step(step, run_.states[step + 1]);
        if (run_.loop) {
            if (*run_.loop + 1 == run_.states.size()) trace_.loop_from = trace_.steps.size();
            tell_step(run_.states.size() - 1, run_.states[*run_.loop]);
            if (*trace_.loop_from == trace_.steps.size())
                add({.kind = Trace::Kind::Environment, .what = "nothing changes, for ever"});
        }
        return std::move(trace_);
    }

private:
    const Table<System::Symbol>& symbols() const { return system_.modules[system_.main].symbols; }

    void make_signals() {
        std::unordered_set<std::uint32_t> written;
        for (const System::Controller& controller : system_.controllers)
            for (const System::Named& output : controller.outputs) written.insert(output.symbol.index);
        std::unordered_set<std::uint32_t> listed;
        const auto signal = [&](const std::string& name, Id<System::Symbol> symbol, std::vector<Id<System::Symbol>>& ids,
                                std::vector<Trace::Signal>& list) {
            if (!listed.insert(symbol.index).second) return;
            ids.push_back(symbol);
            list.push_back({name, symbols()[symbol].type});
        };
        for (const System::Controller& controller : system_.controllers) {
            const std::string prefix = system_.controllers.size() == 1 ? "" : controller.name + ".";
            for (const System::Named& step : controller.steps) {
                steps_.push_back(step.symbol);
                trace_.steps_of_charts.push_back(prefix + step.name);
            }
            for (const System::Named& input : controller.inputs)
                if (!written.contains(input.symbol.index)) signal(input.name, input.symbol, inputs_, trace_.inputs);
            for (const System::Named& output : controller.outputs)
                signal(output.name, output.symbol, outputs_, trace_.outputs);
            for (const System::Named& internal : controller.internals)
                signal(internal.name, internal.symbol, internals_, trace_.internals);
        }
        for (const System::Component& component : system_.components)
            for (const System::Named& variable : component.variables)
                signal(variable.name, variable.symbol, plant_, trace_.plant);
        trace_.short_names = shortened_names(trace_.steps_of_charts);
    }

    Trace::State snapshot() const {
        const auto values = [&](const std::vector<Id<System::Symbol>>& ids) {
            Values list;
            for (const Id<System::Symbol> id : ids) list.push_back(shown_[id.index]);
            return list;
        };
        Trace::State state{.time_ms = moment_,
                           .inputs = values(inputs_),
                           .outputs = values(outputs_),
                           .internals = values(internals_),
                           .plant = values(plant_)};
        for (std::uint32_t step = 0; step < steps_.size(); ++step)
            if (shown_[steps_[step].index] != 0) state.situation.push_back(step);
        return state;
    }

    void add(Trace::Step step) {
        step.after = snapshot();
        trace_.steps.push_back(std::move(step));
    }

    /// Shows the symbol as it is in `next`; whether that is a change.
    bool take(Id<System::Symbol> symbol, const Values& next) {
        std::int64_t& shown = shown_[symbol.index];
        return std::exchange(shown, next[symbol.index]) != next[symbol.index];
    }
    bool take(const std::vector<System::Named>& list, const Values& next) {
        bool changed = false;
        for (const System::Named& named : list) changed = take(named.symbol, next) || changed;
        return changed;
    }

    /// Step `index`, from its state to `next`.
    void tell_step(std::size_t index, const Values& next) {
        const Values& before = run_.states[index];
        if (run_.loop == index) trace_.loop_from = trace_.steps.size();
        const bool ticks = system_.ticks.valid() && value_in(system_, before, system_.ticks) != 0;
        moment_ += trace_.timed ? (ticks ? system_.tick_ms : 0) : 1;
        if (ticks) tell_delay();
        for (const System::Controller& controller : system_.controllers) tell_controller(controller, before, next);
        for (const System::Controller& controller : system_.controllers) tell_timers(controller, before, next);
        for (const System::Component& component : system_.components) tell_component(component, next);
        bool changed = false;
        for (const Id<System::Symbol> input : inputs_) changed = take(input, next) || changed;
        if (changed) add({.kind = Trace::Kind::Environment, .what = "inputs change"});
        shown_ = next;
    }

    /// Delays in a row are one step.
    void tell_delay() {
        const bool goes_on = trace_.steps.back().kind == Trace::Kind::Delay && trace_.loop_from != trace_.steps.size();
        if (goes_on) trace_.steps.pop_back();
        add({.kind = Trace::Kind::Delay, .what = "time passes"});
    }

    void tell_controller(const System::Controller& controller, const Values& before, const Values& next) {
        const bool starts = controller.starts.valid() && value_in(system_, before, controller.starts) != 0;
        const bool evolves = !controller.evolves.valid() || value_in(system_, before, controller.evolves) != 0;
        std::vector<std::string> cleared;
        for (const System::Named& transition : controller.transitions)
            if (evolves && before[transition.symbol.index] != 0) cleared.push_back(transition.name);
        bool changed = take(controller.steps, next);
        changed = take(controller.outputs, next) || changed;
        changed = take(controller.internals, next) || changed;
        const bool seen = changed || !cleared.empty();
        if (!seen && (!evolves || detail_ == Detail::Chart)) return;
        Trace::Step step{.kind = Trace::Kind::Controller, .component = controller.name, .internal = !seen};
        if (starts) step.what = "first evolution";
        if (!cleared.empty()) step.fired.push_back(std::move(cleared));
        add(std::move(step));
    }

    /// A timer t1/X matters while its step is active.
    void tell_timers(const System::Controller& controller, const Values& before, const Values& next) {
        for (const System::TimerEnd& timer : controller.timers) {
            const auto over = [&](const Values& values) {
                const bool lapses = timer.step && timer.fall_ms == 0;
                return values[timer.symbol.index] != 0 &&
                       (!lapses || values[controller.steps[*timer.step].symbol.index] != 0);
            };
            take(timer.symbol, next);
            if (over(before) || !over(next)) continue;
            add({.kind = Trace::Kind::Timer, .component = controller.name, .what = timer_words(controller, timer)});
        }
    }

    static std::string timer_words(const System::Controller& controller, const System::TimerEnd& timer) {
        const std::string rise = timer.rise_ms > 0 ? duration_text(timer.rise_ms) : "";
        if (!timer.step) return (rise.empty() ? duration_text(timer.fall_ms) : rise) + " are over";
        const std::string& step = controller.steps[*timer.step].name;
        const std::string of = step.find('.') == std::string::npos ? "X" + step : step;
        const std::string fall = timer.fall_ms > 0 ? "/" + duration_text(timer.fall_ms) : "";
        return (rise.empty() ? "" : rise + "/") + of + fall + " is true";
    }

    void tell_component(const System::Component& component, const Values& next) {
        std::string words;
        const auto append = [&words](const std::string& word) { words += (words.empty() ? "" : ", ") + word; };
        bool changed = false;
        if (component.location.valid() && next[component.location.index] != shown_[component.location.index]) {
            const System::Symbol& location = symbols()[component.location];
            append(location.values[static_cast<std::size_t>(next[component.location.index] - location.type.low)]);
            changed = take(component.location, next);
        }
        for (const System::Named& variable : component.variables) {
            const std::int64_t before = shown_[variable.symbol.index];
            if (!take(variable.symbol, next)) continue;
            append(change_words(variable.name, symbols()[variable.symbol].type, before, next[variable.symbol.index]));
            changed = true;
        }
        changed = take(component.inputs, next) || changed;
        if (!changed) return;
        add({.kind = kind_of(component.kind), .component = component.name, .what = std::move(words)});
    }

    static Trace::Kind kind_of(System::Component::Kind kind) {
        switch (kind) {
        case System::Component::Kind::Plant:       return Trace::Kind::Plant;
        case System::Component::Kind::Environment: return Trace::Kind::Environment;
        case System::Component::Kind::Timer:       return Trace::Kind::Timer;
        }
        unreachable();
    }

    const System& system_;
    const SystemRun& run_;
    Detail detail_;
    Values shown_;               ///< as the trace has it so far
    Trace trace_ = {};
    std::vector<Id<System::Symbol>> steps_ = {}, inputs_ = {}, outputs_ = {}, internals_ = {}, plant_ = {};
    std::int64_t moment_ = 0;
};

}  // namespace

Trace tell(const System& system, const SystemRun& run, Detail detail) { return SystemTeller(system, run, detail).told(); }

}  // namespace grafverif
