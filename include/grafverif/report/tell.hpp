// SPDX-License-Identifier: MIT
// tell: a run of a Network -> a Trace, in the words of the charts; a verb.
//
// What becomes what:
//   edge of an instance             a step of its own: the location reached, what changed in the plant
//   timer edge run -> done          a step of its own; what else timers do is internal
//   edges of a PLC                  one step per search for stability in which a transition is cleared or an output
//                                   changes; what does neither is internal
//   delays in a row                 one step
// Where the plant moves in the midst of a PLC cycle, the cycle's step is told in two parts, each at its place; where
// the plant then changes an input that has been sampled and matters, the sampling is a step.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/network_run.hpp"
#include "grafverif/ir/trace.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// Whether the moves of the translation are told too, each as a step marked internal.
enum class Detail { Chart, Everything };

/// Tells a run while it happens.
class Teller {
public:
    /// `network` outlives the teller.
    Teller(const Network& network, Detail detail);

    /// One move has led from `before` to `after`.
    void move(const Move& move, const NetworkState& before, const NetworkState& after);
    /// Ends the steps that are still open: `now` is the state reached.
    void flush(const NetworkState& now);
    /// What is told from here on repeats for ever.
    void begin_loop(const NetworkState& now);
    /// The run is over: a loop in which nothing was told is told here.
    void finish(const NetworkState& now);

    const Trace& trace() const { return trace_; }

private:
    /// What a controller has done since its last step.
    struct Open {
        std::vector<std::vector<std::string>> fired = {};
        bool first = false;    ///< the first evolution is among it
        bool sampled = false;  ///< inputs are read, the evolution is to come
        bool changed = false;  ///< an output or a stored variable has changed
        bool written = false;  ///< outputs have been written since the last evolution
    };

    void make_signals();
    void index_processes();
    Trace::State snapshot(const NetworkState& state) const;
    void add(Trace::Step step, const NetworkState& state);
    void close(std::size_t controller, const NetworkState& state);
    void close_delay(const NetworkState& state);
    void tell_instance(const Fire& fire, const NetworkState& before, const NetworkState& after);
    void tell_timer(const Fire& fire, const NetworkState& before, const NetworkState& after);
    void tell_controller(const Fire& fire, const NetworkState& before, const NetworkState& after);
    void tell_phase(std::size_t controller, const Network::Edge& edge, const Open& open, const NetworkState& after);
    void tell_sampling(const NetworkState& before, const NetworkState& after);

    const Network& network_;
    Detail detail_;
    Trace trace_ = {};
    std::vector<Id<Network::Variable>> steps_ = {}, inputs_ = {}, outputs_ = {}, internals_ = {}, plant_ = {};
    std::vector<std::uint32_t> controller_of_ = {};  ///< per process: a PLC's or timer's controller
    std::vector<Open> open_ = {};                    ///< per controller
    std::int64_t time_ms_ = 0;
    std::int64_t delay_ms_ = 0;  ///< not yet told
};

/// What `fire` would do in `state`, in the words of a trace, inputs of the controllers included: `Start: START`.
std::string choice_words(const Network& network, const NetworkState& state, const Fire& fire);

/// Requires that `run` is one of `network` (see replay in ir/network_run.hpp).
Trace tell(const Network& network, const Run& run, Detail detail = Detail::Chart);

}  // namespace grafverif
