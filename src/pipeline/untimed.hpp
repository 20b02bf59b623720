// SPDX-License-Identifier: MIT
// Abstraction of an untimed model, and the consequences of its verdicts for the timed loop.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/grafverif.hpp"

namespace grafverif {

struct Abstraction {
    enum class Preservation {
        /// No plant: a property of all states that holds also holds with every plant, in grain atomic.
        ToEveryPlant,
        /// Plant automata that move at any time in any order: a property of all runs that holds, and a `reachable` that
        /// is violated, have the same verdict in the timed loop.
        ToTimedLoop,
        ExactInIntegerTime,  ///< the states are the same as in the timed engine
        Nowhere,             ///< restricted order of events: verdicts apply only to the model
    };
    std::string words = {};  ///< description of the abstraction, such as `no plant` or `plant automata, interleaved`
    std::string grain = {};  ///< granularity; empty if the model does not distinguish it
    Preservation preservation = Preservation::Nowhere;
    bool constrained = false;  ///< true if the constraints on the inputs are assumed
    /// True if runs are fair: a verdict on a property of runs, unlike a verdict on a property of states, applies only
    /// to this model.
    bool fair = false;
};
/// Returns the abstraction of the system that transition_system_of derives from `loop`, or from a chart if `loop` is
/// null.
Abstraction abstraction_of(const ModelOptions& options, const ClosedLoop* loop);

/// A transition system to check, with the charts of its controllers, in order.
struct SystemToCheck {
    const TransitionSystem& system;
    std::vector<const Chart*> charts = {};
    Abstraction abstraction = {};
    /// For interleaved plant automata: returns the expanded network from which the system was derived. For any other
    /// system, the function or its result is empty. The function is called if a run is explained. It computes the
    /// network once.
    std::function<const std::optional<Network>&()> network = {};
};

/// True for the implicit properties `no_race` and `no_out_of_range`, which exclude model errors.
bool excludes_fault(const Property& property);

/// Returns the properties `no_race` and `no_out_of_range` that are not proved by `verdicts`. If `no_race` or
/// `no_out_of_range` is violated, the behaviour after the violation is undefined and may differ in another model.
std::vector<std::string> unproven_faults(const TransitionSystem& system, const std::vector<Verdict>& verdicts);

/// Returns the consequences of a verdict beyond its model, provided that the `unproven` properties hold, or an empty
/// string if the verdict is unknown.
std::string preservation_text(const SystemToCheck& check, const Property& property, const Verdict& verdict,
                              const std::vector<std::string>& unproven);

}  // namespace grafverif
