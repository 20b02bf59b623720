// SPDX-License-Identifier: MIT
// Describes the abstraction of an untimed model, and the consequences of its verdicts for the timed loop.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/grafverif.hpp"

namespace grafverif {

struct Abstraction {
    enum class Preservation {
        /// The model has no plant. If a property of all states holds in the model, it also holds with every plant, in
        /// grain atomic (a PLC cycle is one move).
        ToEveryPlant,
        /// Plant automata move at any time and in any order. If a property of all runs holds in the model, or a
        /// `reachable` is violated, the verdict for the timed loop is the same.
        ToTimedLoop,
        ExactInIntegerTime,  ///< the model has the same states as the timed engine
        Nowhere,             ///< the order of events is restricted: verdicts apply only to this model
    };
    std::string words = {};  ///< description of the abstraction, such as `no plant` or `plant automata, interleaved`
    std::string grain = {};  ///< grain of interleaving; empty if the model does not depend on it
    Preservation preservation = Preservation::Nowhere;
    bool constrained = false;  ///< true if the model assumes the declared constraints on inputs

    /// True if only fair runs are considered. If true, a verdict on a property of runs applies only to this model;
    /// verdicts on properties of states are not affected.
    bool fair = false;
};
/// Returns the abstraction of the system that transition_system_of derives from `loop`, or from a chart if `loop` is
/// null.
Abstraction abstraction_of(const ModelOptions& options, const ClosedLoop* loop);

/// A transition system to check, with the charts of its controllers in the order of the controllers.
struct SystemToCheck {
    const TransitionSystem& system;
    std::vector<const Chart*> charts = {};
    Abstraction abstraction = {};
    /// For interleaved plant automata, returns the expanded network from which the system was derived. For any other
    /// system, the function or its result is empty. The function is called to explain a run. The function computes the
    /// network only once.
    std::function<const std::optional<Network>&()> network = {};
};

/// True for the implicit properties `no_race` and `no_out_of_range`, which exclude model errors.
bool excludes_fault(const Property& property);

/// Returns the properties `no_race` and `no_out_of_range` that are not proved by `verdicts`. If `no_race` or
/// `no_out_of_range` is violated, the behaviour after the violation is undefined and may differ in another model.
std::vector<std::string> unproven_faults(const TransitionSystem& system, const std::vector<Verdict>& verdicts);

/// Returns a text with the consequences of a verdict for the timed loop or for other plants. The text states the
/// condition that the properties `unproven` hold. The text is empty if the verdict is unknown.
std::string preservation_text(const SystemToCheck& check, const Property& property, const Verdict& verdict,
                              const std::vector<std::string>& unproven);

}  // namespace grafverif
