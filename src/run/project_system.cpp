// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "run/project.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

namespace {

using System = TransitionSystem;
using Values = std::vector<std::int64_t>;  ///< the value of each symbol of the module `main`
using Writes = ChartRun::Act::Writes;

ChartRun::Kind kind_of(System::Component::Kind kind) {
    switch (kind) {
    case System::Component::Kind::Plant: return ChartRun::Kind::Plant;
    case System::Component::Kind::Environment: return ChartRun::Kind::Environment;
    case System::Component::Kind::Timer: return ChartRun::Kind::Timer;
    }
    unreachable();
}

class SystemProjection {
public:
    SystemProjection(const System& system, const SystemRun& run)
        : system_(system),
          run_(run),
          shown_(run.states.front()),
          view_(made_, shown_.size(), system.controllers.size() == 1) {
        made_.name = system.name;
        made_.timed = system.ticks.valid();
        made_.searches = false;
        add_controllers();
        for (const System::Component& component : system.components) {
            std::vector<std::string> locations;
            if (component.location.valid()) locations = symbols()[component.location].values;
            made_.instances.add({kind_of(component.kind), component.name, std::move(locations)});
            for (const System::Named& variable : component.variables) add_signal(variable, ChartRun::Role::Plant);
        }
    }

    ChartRun made() {
        add(power_on());
        for (std::size_t step = 0; step + 1 < run_.states.size(); ++step) project_step(step, run_.states[step + 1]);
        if (run_.loop) project_step(run_.states.size() - 1, run_.states[*run_.loop]);
        return std::move(made_);
    }

private:
    const Table<System::Symbol>& symbols() const { return system_.modules[system_.main].symbols; }

    Id<ChartRun::Signal> add_signal(const System::Named& named, ChartRun::Role role) {
        return view_.add_signal(named.variable.index, {role, named.name, symbols()[named.variable].type});
    }

    void add_controllers() {
        // A variable that a controller writes is an output, even if another controller reads it.
        for (const System::Controller& from : system_.controllers)
            for (const System::Named& output : from.words.outputs) add_signal(output, ChartRun::Role::Output);
        for (const System::Controller& controller : system_.controllers) {
            const auto& from = controller.words;
            ChartRun::Controller made = view_.controller(
                from, [this](const System::Named& named, ChartRun::Role role) { return add_signal(named, role); });
            made.images.resize(made.outputs.size());
            for (const auto& timer : from.timers)
                made.timers.push_back(
                    made_.timers.add({from.name, timer.watched, timer.step, timer.rise_ms, timer.fall_ms, false}));
            made_.controllers.add(std::move(made));
        }
        shorten_names(made_.steps);
    }

    void add(ChartRun::Event moment) {
        moment.move = step_;
        moment.after = view_.state(time_, shown_);
        made_.moments.push_back(std::move(moment));
    }

    /// Returns the event at power-on, including the first evolutions that are not separate steps of the system.
    ChartRun::Event power_on() const {
        ChartRun::Event moment;
        for (std::uint32_t index = 0; index < system_.controllers.size(); ++index) {
            const System::Controller& from = system_.controllers[index];
            if (from.starts.valid()) continue;
            ChartRun::Act act{.controller = {index}, .starts = true, .inputs = Values(from.words.inputs.size())};
            if (from.words.mode == ExecutionMode::EveryCycle && holds(from.writes, shown_, true))
                act.writes = Writes::Yes;
            moment.acts.push_back(std::move(act));
        }
        return moment;
    }

    bool holds(Id<Expr> condition, const Values& values, bool otherwise) const {
        return condition.valid() ? value_in(system_, values, condition) != 0 : otherwise;
    }

    /// Updates the displayed value of the symbol to its value in `next`. Returns true if the displayed value changes.
    bool take(Id<System::Symbol> symbol, const Values& next) {
        std::int64_t& shown = shown_[symbol.index];
        return std::exchange(shown, next[symbol.index]) != next[symbol.index];
    }
    template <class Named>
    bool take(const std::vector<Named>& list, const Values& next) {
        bool changed = false;
        for (const Named& named : list) changed = take(named.variable, next) || changed;
        return changed;
    }

    /// Projects step `index`, which leads to the state `next`.
    void project_step(std::size_t index, const Values& next) {
        const Values& before = run_.states[index];
        step_ = index;
        const std::size_t first = made_.moments.size();
        if (run_.loop == index) made_.loop = first;
        const bool ticks = holds(system_.ticks, before, false);
        time_ += made_.timed ? (ticks ? system_.tick_ms : 0) : 1;
        if (ticks) add({.kind = ChartRun::Kind::Delay});
        for (std::uint32_t controller = 0; controller < system_.controllers.size(); ++controller)
            project_controller(controller, before, next);
        for (std::uint32_t controller = 0; controller < system_.controllers.size(); ++controller)
            project_timers(controller, before, next);
        for (std::uint32_t component = 0; component < system_.components.size(); ++component)
            project_component(component, next);
        ChartRun::Event inputs{.kind = ChartRun::Kind::Environment};
        for (const System::Controller& controller : system_.controllers)
            for (const System::Named& input : controller.words.inputs)
                if (take(input.variable, next)) inputs.changed.push_back(view_.signal(input.variable.index));
        inputs.internal = inputs.changed.empty();
        shown_ = next;
        if (!inputs.internal || made_.moments.size() == first) add(std::move(inputs));
    }

    void project_controller(std::uint32_t index, const Values& before, const Values& next) {
        const System::Controller& from = system_.controllers[index];
        ChartRun::Act act{.controller = {index},
                          .scans = holds(from.scans, before, false),
                          .starts = holds(from.starts, before, false)};
        act.evolves = !act.starts && holds(from.evolves, before, true);
        act.samples = !act.starts && holds(from.samples, before, act.evolves);
        if (act.starts || act.samples) act.inputs = view_.inputs(from.words, act, before);
        if (act.samples)
            for (const auto& timer : from.words.timers) act.timers.push_back(before[timer.end.index] != 0);
        for (std::size_t k = 0; act.evolves && k < from.words.transitions.size(); ++k)
            if (before[from.words.transitions[k].variable.index] != 0)
                act.fired.push_back(made_.controllers[act.controller].transitions[k]);
        if (holds(from.writes, before, act.starts || act.evolves)) act.writes = writes(from, act);
        bool changed = take(from.words.steps, next);
        changed = take(from.words.outputs, next) || changed;
        changed = take(from.words.internals, next) || changed;
        if (changed || act.scans || act.starts || act.samples || act.evolves || act.writes != Writes::No)
            add({.kind = ChartRun::Kind::Controller, .acts = {std::move(act)}});
    }

    /// Returns when the controller writes its outputs in a step. A controller that executes an evolution and writes in
    /// the same step does not write while its search for stability continues.
    static Writes writes(const System::Controller& from, const ChartRun::Act& act) {
        const bool searches = from.words.mode == ExecutionMode::StabilitySearch;
        if (act.starts) return searches ? Writes::No : Writes::Yes;
        return act.evolves && searches ? Writes::IfStable : Writes::Yes;
    }

    /// Adds an event for each timer of controller `index` that has expired. The output of a timer t1/X is ignored while
    /// its step is inactive.
    void project_timers(std::uint32_t index, const Values& before, const Values& next) {
        const auto& from = system_.controllers[index].words;
        for (std::size_t k = 0; k < from.timers.size(); ++k) {
            const auto& timer = from.timers[k];
            const auto over = [&](const Values& values) {
                const bool lapses = timer.step && timer.fall_ms == 0;
                return values[timer.end.index] != 0 && (!lapses || values[from.steps[*timer.step].variable.index] != 0);
            };
            take(timer.end, next);
            if (!over(before) && over(next))
                add({.kind = ChartRun::Kind::Timer,
                     .timer = made_.controllers[{index}].timers[k],
                     .timer_holds = true});
        }
    }

    void project_component(std::uint32_t index, const Values& next) {
        const System::Component& component = system_.components[index];
        const bool of_model = component.kind == System::Component::Kind::Timer;  // the expiry of a timer is a separate
                                                                                 // event
        ChartRun::Event moment{.kind = kind_of(component.kind), .internal = of_model, .instance = {index}};
        if (component.location.valid() && take(component.location, next))
            moment.location =
                static_cast<std::size_t>(next[component.location.index] - symbols()[component.location].type.low);
        bool changed = moment.location.has_value();
        for (const std::vector<System::Named>* list : {&component.variables, &component.inputs})
            for (const System::Named& variable : *list) {
                if (!take(variable.variable, next)) continue;
                changed = true;
                if (const auto signal = view_.signal(variable.variable.index); signal.valid())
                    moment.changed.push_back(signal);
            }
        if (changed) add(std::move(moment));
    }

    const System& system_;
    const SystemRun& run_;
    Values shown_;  ///< values as displayed at the current position of the run
    ChartRun made_ = {};
    ChartView view_;
    std::size_t step_ = 0;
    std::int64_t time_ = 0;
};

}  // namespace

ChartRun project(const System& system, const SystemRun& run) { return SystemProjection(system, run).made(); }

}  // namespace grafverif
