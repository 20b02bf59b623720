// SPDX-License-Identifier: MIT
// Engines for untimed models: each decides the properties of one transition system and returns what it found.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/engines.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/transition_system.hpp"

namespace grafverif::app {

/// What an untimed model leaves out, and so what its verdicts are worth (design: "targets").
struct Abstraction {
    enum class Carries {
        ToEveryPlant,         ///< no plant: what holds of all runs does so with every plant, in grain atomic
        ToTimedLoop,          ///< plant automata that move at any time in any order: likewise of the timed loop
        ExactInIntegerTime,   ///< the states of the timed engine
        Nowhere,              ///< a restricted order of events
    };
    std::string words = {};   ///< `no plant`, `plant automata, interleaved`
    std::string grain = {};   ///< empty: none of its own
    Carries carries = Carries::Nowhere;
    bool constrained = false; ///< the constraints on the inputs are assumed
    bool fair = false;        ///< runs are fair: what is said of them, rather than of states, is about this model
};
/// Of the model that transition_system_of (pipeline) makes of `loop`, or of a lone chart.
Abstraction abstraction_of(const Options& options, const ClosedLoop* loop);

/// Whether the options, or `model` for want of a loop, ask for a chart alone.
bool is_of_a_chart(const Model& model, const Options& options);

/// Adds what a chart alone is asked: that each of its steps can be reached (`reachable.X2`).
void ask_for_steps(TransitionSystem& system);

/// The name of what a chart alone is asked under stability search, as `analyse` is: that its situation becomes stable
/// whatever the inputs (code `total-instability`).
inline constexpr const char* stabilises = "stabilises";

/// Adds the answer to it.
void add_stabilises(const Chart& chart, const Equations& equations, const Options& options, const Interrupt& interrupt,
                    Findings& findings);

/// A transition system to be checked, with the charts of its controllers, in order.
struct SystemToCheck {
    const TransitionSystem& system;
    std::vector<const Chart*> charts = {};
    Abstraction abstraction = {};
};

/// The properties among `no_race` and `no_out_of_range` that `verdicts` do not prove. Where one of them fails, what
/// comes after is not defined, and another model may go on otherwise.
std::vector<std::string> unproven_faults(const TransitionSystem& system, const std::vector<Verdict>& verdicts);

/// What a verdict says beyond its model, as long as the `unproven` hold; empty where it is unknown.
std::string carries_words(const SystemToCheck& check, const Property& property, const Verdict& verdict,
                          const std::vector<std::string>& unproven);

/// Whether a property called `property` is one of those asked for; `S.X7` is asked for by `S` as well.
bool is_asked(std::string_view property, const std::vector<std::string>& asked);

/// The embedded symbolic engine. Shows its progress on a terminal; every run is replayed on the rules first.
Findings check_symbolically(const SystemToCheck& check, const Options& options, const Streams& streams,
                            const Interrupt& interrupt);

/// `NuSMV` or `nuXmv` from the PATH, on the model we write. Nothing after an error: it is not there.
std::optional<Findings> check_by_nusmv(const SystemToCheck& check, const std::string& program, Job& job,
                                       const Interrupt& interrupt);

}  // namespace grafverif::app
