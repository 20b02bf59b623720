// SPDX-License-Identifier: MIT
// What an untimed model leaves out, and so what its verdicts are worth (design: "targets").
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/grafverif.hpp"

namespace grafverif {

struct Abstraction {
    enum class Carries {
        ToEveryPlant,        ///< no plant: what holds of all runs does so with every plant, in grain atomic
        ToTimedLoop,         ///< plant automata that move at any time in any order: likewise of the timed loop
        ExactInIntegerTime,  ///< the states of the timed engine
        Nowhere,             ///< a restricted order of events
    };
    std::string words = {};  ///< `no plant`, `plant automata, interleaved`
    std::string grain = {};  ///< empty: none of its own
    Carries carries = Carries::Nowhere;
    bool constrained = false;  ///< the constraints on the inputs are assumed
    bool fair = false;         ///< runs are fair: what is said of them, rather than of states, is about this model
};
/// Of the model that transition_system_of makes of `loop`, or of a lone chart.
Abstraction abstraction_of(const ModelOptions& options, const ClosedLoop* loop);

/// A transition system to be checked, with the charts of its controllers, in order.
struct SystemToCheck {
    const TransitionSystem& system;
    std::vector<const Chart*> charts = {};
    Abstraction abstraction = {};
    /// Of plant automata that take turns, the network that the system was made of, expanded; else empty. Called where a run is
    /// explained, and made once.
    std::function<const std::optional<Network>&()> network = {};
};

/// The properties among `no_race` and `no_out_of_range` that `verdicts` do not prove. Where one of them fails, what
/// comes after is not defined, and another model may go on otherwise.
std::vector<std::string> unproven_faults(const TransitionSystem& system, const std::vector<Verdict>& verdicts);

/// What a verdict says beyond its model, as long as the `unproven` hold; empty where it is unknown.
std::string carries_words(const SystemToCheck& check, const Property& property, const Verdict& verdict,
                          const std::vector<std::string>& unproven);

}  // namespace grafverif
