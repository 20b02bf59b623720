// SPDX-License-Identifier: MIT
// Abstraction of an untimed model, and what its verdicts imply for the timed loop (design: "targets").
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/grafverif.hpp"

namespace grafverif {

struct Abstraction {
    enum class Preservation {
        ToEveryPlant,        ///< no plant: a property of all runs also holds with every plant, in grain atomic
        ToTimedLoop,         ///< plant automata that move at any time in any order: also for the timed loop
        ExactInIntegerTime,  ///< the states of the timed engine
        Nowhere,             ///< a restricted order of events
    };
    std::string words = {};  ///< `no plant`, `plant automata, interleaved`
    std::string grain = {};  ///< empty: no separate one
    Preservation preservation = Preservation::Nowhere;
    bool constrained = false;  ///< the constraints on the inputs are assumed
    bool fair = false;         ///< runs are fair: a property of runs, other than of states, holds for this model only
};
/// The abstraction in the result of transition_system_of for `loop`, or for a lone chart.
Abstraction abstraction_of(const ModelOptions& options, const ClosedLoop* loop);

/// A transition system to be checked, with the charts of its controllers, in order.
struct SystemToCheck {
    const TransitionSystem& system;
    std::vector<const Chart*> charts = {};
    Abstraction abstraction = {};
    /// For interleaved plant automata, the network that the system was derived from, expanded; otherwise empty. Called
    /// if a run is explained, and computed once.
    std::function<const std::optional<Network>&()> network = {};
};

/// The properties among `no_race` and `no_out_of_range` that `verdicts` do not prove. If one of them fails, the
/// continuation is undefined and may differ in another model.
std::vector<std::string> unproven_faults(const TransitionSystem& system, const std::vector<Verdict>& verdicts);

/// The implications of a verdict beyond its model, provided that the `unproven` hold; empty if it is unknown.
std::string preservation_text(const SystemToCheck& check, const Property& property, const Verdict& verdict,
                              const std::vector<std::string>& unproven);

}  // namespace grafverif
