// SPDX-License-Identifier: MIT
// Abstraction of an untimed model, and the consequences of its verdicts for the timed loop (design: "targets").
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/grafverif.hpp"

namespace grafverif {

struct Abstraction {
    enum class Preservation {
        ToEveryPlant,  ///< no plant: a property that holds for all runs also holds with every plant, in grain atomic
        ToTimedLoop,   ///< plant automata that move at any time in any order: verdicts also apply to the timed loop
        ExactInIntegerTime,  ///< the states are the same as in the timed engine
        Nowhere,             ///< restricted order of events: verdicts apply only to the model
    };
    std::string words = {};  ///< description such as `no plant` or `plant automata, interleaved`
    std::string grain = {};  ///< granularity; empty if the model does not distinguish it
    Preservation preservation = Preservation::Nowhere;
    bool constrained = false;  ///< true if the constraints on the inputs are assumed
    /// True if runs are fair: a property of runs, unlike a property of states, holds only for this model.
    bool fair = false;
};
/// Returns the abstraction in the result of transition_system_of for `loop`, or for a chart without a loop.
Abstraction abstraction_of(const ModelOptions& options, const ClosedLoop* loop);

/// A transition system to check, with the charts of its controllers, in order.
struct SystemToCheck {
    const TransitionSystem& system;
    std::vector<const Chart*> charts = {};
    Abstraction abstraction = {};
    /// For interleaved plant automata: the expanded network from which the system was derived; otherwise empty. It is
    /// called if a run is explained, and computed once.
    std::function<const std::optional<Network>&()> network = {};
};

/// Returns those of the properties `no_race` and `no_out_of_range` that `verdicts` do not prove. If one of them fails,
/// the behaviour after the failure is undefined and may differ in another model.
std::vector<std::string> unproven_faults(const TransitionSystem& system, const std::vector<Verdict>& verdicts);

/// Returns the consequences of a verdict beyond its model, provided that the `unproven` properties hold, or an empty
/// string if the verdict is unknown.
std::string preservation_text(const SystemToCheck& check, const Property& property, const Verdict& verdict,
                              const std::vector<std::string>& unproven);

}  // namespace grafverif
