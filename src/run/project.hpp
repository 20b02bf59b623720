// SPDX-License-Identifier: MIT
// project: converts a run of a Network, of a TransitionSystem or of a Chart to a ChartRun, without the rows of its
// printed trace.
//
// Mapping for a Network:
//   edge of an instance, of a timer    an event; an event of a timer is internal unless the rise time or fall time of
//                                      the timer elapses
//   edge of a PLC                      an event with the actions of its controller, in the order of its phases
//   delay                              an event
// For a TransitionSystem, each step is split into events in the following order: time; controllers that acted, with
// their results; timers that expired; components that moved; inputs that changed spontaneously. The time of an event is
// the number of its step or, if the system has ticks, the time in milliseconds. A step without visible changes is an
// internal event. For a Chart that the interpreter executes, the caller defines the events.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"
#include "ir/flat_system.hpp"
#include "ir/network_run.hpp"
#include "run/interpreter.hpp"

namespace grafverif {

/// Maps the values in a state of a model to the signals of the charts and the plant. A key is the index of a value in
/// the state.
class ChartView {
public:
    /// If there are several controllers (`alone` is false), the name of a controller qualifies the names of its steps
    /// and internal variables.
    ChartView(ChartRun& run, std::size_t keys, bool alone) : run_(&run), alone_(alone), signals_(keys) {}

    /// Returns the controller without timers and images. `add(named, role)` adds the signal of a variable.
    template <class Variable, class Add>
    ChartRun::Controller controller(const ControllerWords<Variable>& words, const Add& add) {
        ChartRun::Controller made{
            .name = words.name, .mode = words.mode, .cycle = words.cycle, .conditions = words.conditions};
        for (const auto& step : words.steps) add_step(made, step.name, step.variable.index);
        for (const auto& transition : words.transitions)
            made.transitions.push_back(run_->transitions.add({transition.name}));
        for (const auto& input : words.inputs) made.inputs.push_back(add(input, ChartRun::Role::Input));
        for (const auto& output : words.outputs) made.outputs.push_back(add(output, ChartRun::Role::Output));
        for (auto internal : words.internals) {
            if (!alone_) internal.name = words.name + "." + internal.name;
            made.internals.push_back(add(internal, ChartRun::Role::Internal));
        }
        return made;
    }
    /// Returns the input values that `act` reads. `values` are the values in the state before the act. An act that
    /// continues a scan, or that follows its start, reads the values that the scan holds.
    template <class Variable>
    std::vector<std::int64_t> inputs(const ControllerWords<Variable>& words, const ChartRun::Act& act,
                                     const std::vector<std::int64_t>& values) const {
        std::vector<std::int64_t> read;
        const bool reads_held = !words.held.empty() && !act.starts && !act.scans;
        for (std::size_t k = 0; k < words.inputs.size(); ++k)
            read.push_back(values[(reads_held ? words.held[k] : words.inputs[k].variable).index]);
        return read;
    }
    /// Adds a signal for a value. An existing signal keeps its role.
    Id<ChartRun::Signal> add_signal(std::uint32_t key, ChartRun::Signal signal);
    /// Returns the signal of a value, or an invalid id if the value has no signal.
    Id<ChartRun::Signal> signal(std::uint32_t key) const { return signals_[key]; }
    ChartRun::State state(std::int64_t time_ms, const std::vector<std::int64_t>& values) const;

private:
    void add_step(ChartRun::Controller& controller, const StepName& name, std::uint32_t key);

    ChartRun* run_;
    bool alone_;
    std::vector<Id<ChartRun::Signal>> signals_;  ///< for each key: its signal
    std::vector<std::uint32_t> signal_keys_ = {}, step_keys_ = {};
};

/// Converts a run incrementally, one move at a time.
class NetworkProjection {
public:
    /// Initializes `run` as a run of `network` that begins in `state`. `network` and `run` must outlive the projection.
    NetworkProjection(const Network& network, const NetworkState& state, ChartRun& run);

    /// Appends one move from `before` to `after`.
    void append(const Move& move, const NetworkState& before, const NetworkState& after);
    /// Appends a change made by the user: an event of the type `environment` without further data.
    void append_by_hand(const NetworkState& after);

private:
    void add_controllers();
    Id<ChartRun::Signal> add_signal(Id<Network::Variable> id, ChartRun::Role role);
    ChartRun::Controller controller_of(const Network::Controller& from);
    void add_timers(const Network::Controller& from, ChartRun::Controller& controller);
    void fill(ChartRun::Event& moment, const Fire& fire, const NetworkState& before, const NetworkState& after) const;
    ChartRun::Act act(Id<Network::Controller> id, const Network::Edge& edge, const NetworkState& before,
                      const NetworkState& after) const;

    const Network& network_;
    ChartRun& run_;
    ChartView view_;
    std::vector<Id<Network::Controller>> controller_of_ = {};  ///< per process of a PLC: its controller
    /// For each process that is neither a controller nor a timer: its instance.
    std::vector<Id<ChartRun::Instance>> instance_of_ = {};
    std::vector<Id<ChartRun::Timer>> timer_of_ = {};  ///< timer of each process
    std::vector<Id<Network::Variable>> end_of_ = {};  ///< output variable of each timer
    std::int64_t time_ms_ = 0;
};

/// Returns an empty run (declarations, no events) of `chart`, for a chart that the interpreter executes with free
/// inputs. The signals of the run are the variables of the chart, in order; stored outputs have no images.
ChartRun project(const Chart& chart, ExecutionMode mode);
/// Returns the values of the signals in a run of `chart` for the state `state`.
ChartRun::State project(const Chart& chart, const State& state, InputValues inputs, std::int64_t time_ms);
/// Appends an instant as one event with its row. `after` is the state after the instant. `fired` contains the
/// transitions that each evolution of the instant clears. The first evolution of a run clears no transition and has a
/// separate row.
void append_instant(ChartRun& run, std::string what, const std::vector<std::vector<Id<Chart::Transition>>>& fired,
                    ChartRun::State after);

/// Converts a run. Requires that grafverif built the network or system, and that `run` is a run of this network or
/// system.
ChartRun project(const Network& network, const Run& run);
ChartRun project(const TransitionSystem& system, const SystemRun& run);

}  // namespace grafverif
