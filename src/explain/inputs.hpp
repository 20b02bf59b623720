// SPDX-License-Identifier: MIT
// The shortest change of a run whose inputs are free (no plant): the fewest of the things that inputs and times do in it
// without which a property about single states holds along it. What they do, state by state:
//   an input changes   it has another value than in the state before; in the first state, than 0, or what of its range is
//                      next to 0
//   a time is over     its end holds, and did not in the state before; in the first state, it holds
//
// Without some of them the run is made again from the first state on. An input that does not change keeps its value until it
// changes the next time; a time that is not over is not until it is the next time. Whose turn it is, where there are several
// controllers, is as it was. Behind its end the run goes on until a state comes again, and so for ever: nothing changes any
// more, no time is over any more, and each controller has its turn in every step. Constraints on the inputs must hold in each
// of its states, and the property; and the run may not be untimely (run/replay.hpp) where the one that fails is not: no plant gives a
// run in which `5s/X1` is over and `3s/X1` is not. What comes later than it did is not looked at.
//
// The model gives each step one outcome, so what a smallest set leaves out are causes in the sense of Halpern and Pearl, with
// the model for their equations and the others of the set for their contingency: without those alone the run is bad still, or
// it is none that counts: a constraint forbids it, no plant gives it, a value leaves its range, or no state came again among 1000
// behind its end.
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
    /// What `symbol`, of main, does in a state of the run.
    struct Event {
        Id<TransitionSystem::Symbol> symbol = {};
        std::size_t state = 0;
        bool operator==(const Event&) const = default;
    };
    std::vector<Event> events = {};                   ///< all there are, by state
    std::optional<std::vector<Event>> left_out = {};  ///< of the smallest sets one that changes late
    SystemRun run = {};                               ///< what is made without them; it has a loop
    std::size_t tried = 0;                            ///< sets
    bool exhausted = false;                           ///< the effort allowed is spent, and there were more to try
};

/// Requires that `run` is one of `system` and shows that `property` is violated. Nothing is found for properties that are not
/// about single states, and for systems where something else than inputs and times is free. `effort`: at most so many steps are
/// made in all, of a system of few terms; of larger ones less.
InputChange fewest_input_changes(const TransitionSystem& system, const Property& property, const SystemRun& run,
                                 std::size_t effort = 20'000, const StopAsked& stopped = {});

/// Tells in `told`, the projection of the same run, what was left out.
void mark(const TransitionSystem& system, const std::vector<InputChange::Event>& left_out, ChartRun& told);

}  // namespace grafverif
