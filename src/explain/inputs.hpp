// SPDX-License-Identifier: MIT
// The shortest change of a run with free inputs (no plant): the smallest set of events of inputs and timers without
// which a property about single states holds along it. The events, state by state:
//   an input changes   its value differs from that in the previous state; in the first state, from 0, or from the value
//                      of its range that is closest to 0
//   a timer expires    its output is true, and was false in the previous state; in the first state, it is true
//
// To omit events, the run is re-executed from the first state. An omitted input keeps its value until its next change;
// an omitted timer is not expired until its next expiry. The order of several controllers is unchanged. After the end
// of the run the execution continues until a state is repeated, and so forever: no input changes, no timer expires, and
// each controller has its turn in every step. The constraints on the inputs, and the property, must hold in each of its
// states. The run may not be untimely (run/replay.hpp) unless the original is: no plant produces a run in which `5s/X1`
// has expired and `3s/X1` has not. Events that occur later than originally are not considered.
//
// The model gives each step one outcome. So the events of a smallest set are causes as defined by Halpern and Pearl,
// with the model as equations and the other events of the set as contingency. Omitting only those others leaves a run
// that is still bad or not admissible: a constraint forbids it, no plant produces it, a value leaves its range, or none
// of the 1000 states after its end is repeated.
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
    /// An event of `symbol`, of main, in a state of the run.
    struct ChoiceEvent {
        Id<TransitionSystem::Symbol> symbol = {};
        std::size_t state = 0;
        bool operator==(const ChoiceEvent&) const = default;
    };
    std::vector<ChoiceEvent> events = {};                   ///< all events, by state
    std::optional<std::vector<ChoiceEvent>> left_out = {};  ///< of the smallest sets, one with late changes
    SystemRun run = {};                                     ///< the run without them; it has a loop
    std::size_t tried = 0;                                  ///< number of sets
    bool exhausted = false;                                 ///< the effort is used up before all sets were tried
};

/// Requires that `run` is a run of `system` that violates `property`. Finds nothing for properties that are not about
/// single states, and for systems in which anything besides inputs and timers is free. `effort`: maximum number of
/// steps in total for a system of few terms; less for larger ones.
InputChange fewest_input_changes(const TransitionSystem& system, const Property& property, const SystemRun& run,
                                 std::size_t effort = 20'000, const StopRequested& stopped = {});

/// Records the omitted events in `told`, the projection of the same run.
void mark(const TransitionSystem& system, const std::vector<InputChange::ChoiceEvent>& left_out, ChartRun& told);

}  // namespace grafverif
