// SPDX-License-Identifier: MIT
// Searches for the shortest change of a run with free inputs (no plant) that violates a property about single states: a
// smallest set of events of inputs and timers such that the property holds in every state of the run without these
// events. Events in a state are:
//   - An input changes if its value differs from its value in the previous state. In the first state, an input changes
//     if its value differs from the value in its range that is closest to 0.
//   - A timer expires if its output is true and was false in the previous state. In the first state, a timer expires if
//     its output is true.
//
// To omit events, the run is re-executed from the first state. If the change of an input is omitted, the input keeps
// its value until its next change. If the expiry of a timer is omitted, the output of the timer stays false until the
// next expiry of this timer in the run. The order of several controllers is unchanged. After the end of the run, the
// execution continues until a state is repeated; from then on, the run repeats forever. In this continuation, no input
// changes, no timer expires, and each controller executes in every step. The constraints on the inputs, and the
// property, must hold in each state of the run. The run may be untimely (run/replay.hpp) only if the original run is
// untimely. For example, a run in which `5s/X1` has expired and `3s/X1` has not expired is untimely, because no plant
// produces it. Changes that move an event to a later state are not considered.
//
// For given inputs, the model has exactly one result for each step. Therefore each event of a smallest set is a cause
// as defined by Halpern and Pearl; the model represents the equations, and the other events of the set are the
// contingency. If only the other events of the set are omitted, the run still violates the property, or the run is not
// admissible. A run is not admissible if it violates a constraint, no plant produces it, a value leaves its range, or
// no state is repeated within 1000 states after its end.
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
    /// An event in a state of the run: the input or timer output `symbol` of the module `main` changes or expires.
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

/// Searches for the shortest change. Requires that `run` is a run of `system` that violates `property`. The result
/// contains no change if the property does not concern single states, or if the system has free variables other than
/// inputs, timers and the order of controllers. `effort` is the maximum number of steps in total for a system with few
/// terms; larger systems are allowed fewer steps.
InputChange fewest_input_changes(const TransitionSystem& system, const Property& property, const SystemRun& run,
                                 std::size_t effort = 20'000, const StopRequested& stopped = {});

/// Records the omitted events in `chart_run`, which is the projection of the same run.
void mark(const TransitionSystem& system, const std::vector<InputChange::ChoiceEvent>& left_out, ChartRun& chart_run);

}  // namespace grafverif
