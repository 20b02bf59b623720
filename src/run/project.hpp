// SPDX-License-Identifier: MIT
// project: a run of a Network, of a TransitionSystem or of a Chart -> a ChartRun, without rows.
//
// What becomes what, of a Network:
//   edge of an instance, of a timer    a moment; of a timer an internal one, unless a delay of it is over
//   edge of a PLC                      a moment with the act of its controller, phase by phase as its procedures say
//   delay                              a moment
// Of a TransitionSystem, a step becomes what it did, in this order: time that passes; the controllers that did
// something, with what they found; timers that ended; components that moved; inputs that changed by themselves. Its
// moments are numbers of steps, or times where the system ticks. A step in which nothing shows is an internal moment.
// Of a Chart that the interpreter runs, whoever runs it says what is a moment.
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

/// Where the values of a model's state are what the charts and the plant know; keys are places among those values.
class ChartView {
public:
    /// Where the controller is not `alone`, names of steps and internal variables begin with its own.
    ChartView(ChartRun& run, std::size_t keys, bool alone) : run_(&run), alone_(alone), signals_(keys) {}

    /// The controller without timers and images. `add(named, role)` adds the signal of a variable.
    template <class Variable, class Add>
    ChartRun::Controller controller(const ControllerWords<Variable>& words, const Add& add) {
        ChartRun::Controller made{.name = words.name, .mode = words.mode, .conditions = words.conditions};
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
    /// What is there already keeps its role.
    Id<ChartRun::Signal> add_signal(std::uint32_t key, ChartRun::Signal signal);
    /// Not valid: the value is none of a signal.
    Id<ChartRun::Signal> signal(std::uint32_t key) const { return signals_[key]; }
    ChartRun::State state(std::int64_t time_ms, const std::vector<std::int64_t>& values) const;

private:
    void add_step(ChartRun::Controller& controller, const StepName& name, std::uint32_t key);

    ChartRun* run_;
    bool alone_;
    std::vector<Id<ChartRun::Signal>> signals_;  ///< per key
    std::vector<std::uint32_t> signal_keys_ = {}, step_keys_ = {};
};

/// Projects a run while it happens.
class NetworkProjection {
public:
    /// Makes `run` one of `network` that begins in `state`. Both outlive the projection.
    NetworkProjection(const Network& network, const NetworkState& state, ChartRun& run);

    /// One move has led from `before` to `after`.
    void append(const Move& move, const NetworkState& before, const NetworkState& after);
    /// Somebody has made it so by hand: a moment of the kind `environment` about which there is nothing else to tell.
    void append_by_hand(const NetworkState& after);

private:
    void add_controllers();
    Id<ChartRun::Signal> add_signal(Id<Network::Variable> id, ChartRun::Role role);
    ChartRun::Controller controller_of(const Network::Controller& from);
    void add_timers(const Network::Controller& from, ChartRun::Controller& controller);
    void fill(ChartRun::Moment& moment, const Fire& fire, const NetworkState& before, const NetworkState& after) const;
    ChartRun::Act act(Id<Network::Controller> id, const Network::Edge& edge, const NetworkState& before,
                      const NetworkState& after) const;

    const Network& network_;
    ChartRun& run_;
    ChartView view_;
    std::vector<Id<Network::Controller>> controller_of_ = {};  ///< per process: whose PLC it is
    std::vector<Id<ChartRun::Instance>> instance_of_ = {};     ///< per process, if it is none
    std::vector<Id<ChartRun::Timer>> timer_of_ = {};           ///< per process
    std::vector<Id<Network::Variable>> end_of_ = {};           ///< per timer
    std::int64_t time_ms_ = 0;
};

/// A run of a chart that the interpreter runs, its inputs free: what there is to tell of it, and no moment yet. Its signals
/// are the variables of the chart, in order; stored outputs have no images.
ChartRun project(const Chart& chart, ExecutionMode mode);
/// What such a run has in `state`.
ChartRun::State project(const Chart& chart, const State& state, InputValues inputs, std::int64_t time_ms);
/// Adds a moment and its row: an instant in which `fired` was cleared, evolution by evolution, and what is so behind it. The
/// first evolution of a run clears nothing, and a row of its own says so.
void append_instant(ChartRun& run, std::string what, const std::vector<std::vector<Id<Chart::Transition>>>& fired,
                    ChartRun::State after);

/// Requires that the system or network is one that a stage of ours made, and of a SystemRun that it is one of `system`.
ChartRun project(const Network& network, const Run& run);
ChartRun project(const TransitionSystem& system, const SystemRun& run);

}  // namespace grafverif
