// SPDX-License-Identifier: MIT
// The shortest change of a run with free inputs (no plant): a smallest set of events of inputs and timers such that a
// property about single states holds in every state of the run without these events. The events, state by state:
//   an input changes   its value differs from its value in the previous state; in the first state, from the value in
//                      its range that is closest to 0
//   a timer expires    its output is true, and was false in the previous state; in the first state, it is true
//
// To omit events, the run is re-executed from the first state. If the change of an input is omitted, the input keeps
// its value until its next change. If the expiry of a timer is omitted, the timer expires at its next expiry. The order
// of several controllers is unchanged. After the end of the run, the execution continues until a state is repeated;
// from then on, the run repeats forever. In this continuation, no input changes, no timer expires, and each controller
// executes in every step. The constraints on the inputs, and the property, must hold in each state of the run. The run
// may be untimely (run/replay.hpp) only if the original run is untimely. For example, a run in which `5s/X1` has
// expired and `3s/X1` has not expired is untimely, because no plant produces it. Events that occur later than in the
// original run are not considered.
//
// The model has exactly one result for each step. Therefore the events of a smallest set are causes as defined by
// Halpern and Pearl, with the model as equations and the other events of the set as contingency. If one event of the
// set is not omitted, the run still violates the property, or the run is not admissible: it violates a constraint, no
// plant produces it, a value leaves its range, or none of the 1000 states after its end is repeated.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "explain/smallest.hpp"
#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/transition_system.hpp"
#include "ir/flat_system.hpp"

namespace grafverif {

struct InputChange {
    /// An event in a state of the run: `symbol`, a symbol of the module `main`, changes or expires.
    struct ChoiceEvent {
        Id<TransitionSystem::Symbol> symbol = {};
        std::size_t state = 0;
        bool operator==(const ChoiceEvent&) const = default;
    };
    std::vector<ChoiceEvent> events = {};  ///< all events, ordered by state
    /// The omitted events: among all smallest sets, the set whose events occur latest. Empty if no set was found.
    std::optional<std::vector<ChoiceEvent>> left_out = {};
    SystemRun run = {};     ///< the run without the events `left_out`; it has a loop
    std::size_t tried = 0;  ///< number of sets that were tried
    /// True if the search ended before all sets were tried: it was stopped or reached the maximum effort.
    bool exhausted = false;
};

/// Searches for the shortest change. Requires that `run` is a run of `system` that violates `property`. Returns no
/// change if the property does not concern single states, or if the system has free variables other than inputs and
/// timers. `effort` is the maximum number of steps in total for a system with few terms; larger systems are allowed
/// fewer steps.
InputChange fewest_input_changes(const TransitionSystem& system, const Property& property, const SystemRun& run,
                                 std::size_t effort = 20'000, const StopRequested& stopped = {});

/// Records the omitted events in `chart_run`, the projection of the same run.
void mark(const TransitionSystem& system, const std::vector<InputChange::ChoiceEvent>& left_out, ChartRun& chart_run);

}  // namespace grafverif
