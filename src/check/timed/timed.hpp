// SPDX-License-Identifier: MIT
// The timed engine: explicit-state search of a Network in integer time.
//
// Semantics: ir/network.hpp. One exploration, breadth first, decides every property about single states at once;
// liveness is decided on the graph it leaves behind. Liveness as UPPAAL defines it: a maximal run is infinite or ends
// where nothing can happen any more; staying in a state for ever counts as a run; `p leads to q` is kept by a state
// where p and q hold together.
//
// Exactness (design: "properties, verdicts, traces"; argued in docs/engines.md). With closed clock constraints integer
// time reaches the discrete states of dense time, so `always`, `never`, `reachable` are exact; a strict constraint makes
// them one-sided. `inevitable`, `leads to`, `no deadlock`, `no timelock` are violated when an integer run violates them,
// and hold only where no time-lock can hide between the ticks; else they are unknown, with the place named.
//
// Counterexamples about single states are shortest: fewest moves, a delay of any length counting one.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/state_profile.hpp"
#include "grafverif/ir/verdict.hpp"
#include "ir/network_inputs.hpp"
#include "ir/network_run.hpp"

namespace grafverif {

/// So many states ask for an explanation.
constexpr std::uint64_t many_states = std::uint64_t{1} << 20U;

struct TimedProgress {
    std::uint64_t states = 0;
    std::uint64_t transitions = 0;
    std::uint64_t queue = 0;  ///< states found, their moves not yet looked at
    std::uint64_t bytes = 0;
    double seconds = 0;
};

struct TimedOptions {
    std::vector<std::string> properties = {};  ///< names; empty: all. `no timelock` is always decided
    std::uint64_t max_states = 500'000'000;
    std::uint64_t max_memory = std::uint64_t{4} << 30U;  ///< bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;  ///< set by somebody else: end with what is known
    unsigned jobs = 1;       ///< threads; 0: as many as there are cores. What is found does not depend on it
    unsigned slice = 64;     ///< states that a thread takes at a time; far fewer than there are, or one thread does all
    bool keep_links = true;  ///< false: less memory, several times the work for liveness. Kept only where needed
    bool timelock = true;    ///< false: not decided where nobody asks
    bool premises = false;   ///< find out TimedResult::premises
    std::vector<InputChoice> choices = {};                    ///< of an input abstraction
    bool until_decided = false;                               ///< end the search when each property has its state
    bool paths = false;                                       ///< report TimedResult::paths
    std::function<void(const TimedProgress&)> progress = {};  ///< called a few times per second
    bool profile = false;  ///< asks for TimedResult::profile, whatever the search comes to
    std::function<void(const StateProfile&)> many = {};  ///< called once, when the search has found `many_states`
    std::function<std::optional<StateProfile::Finest>()> finest = {};  ///< asked for a profile
};

/// What a search that came to its end says of the network as a neighbour of others (docs/engines.md, "Sub-loops").
struct Premises {
    std::optional<Run> diverges = {};  ///< a lasso in which time passes
    bool rests = false;                ///< no run goes on for ever within one instant
    bool settles = false;              ///< time passes in settled states only
};

/// A state on a run of an input abstraction, after `move`. Its clocks are left out.
struct AbstractState {
    Move move = {};
    NetworkState state = {};
    std::vector<std::uint64_t> possible = {};  ///< per choice, a bit per valuation; 0: the move is no edge of its PLC
};

struct TimedResult {
    std::vector<Verdict> verdicts = {};   ///< in the order of the properties, `no timelock` last if undeclared
    std::vector<ModelError> errors = {};  ///< at most one per kind, edge and variable
    std::uint64_t states = 0;
    std::uint64_t transitions = 0;  ///< edges and delays of one unit
    std::uint64_t bytes = 0;        ///< most memory held at once
    std::uint64_t state_bytes = 0;  ///< one state, packed
    double seconds = 0;
    bool complete = true;      ///< every reachable state was looked at
    bool time_passes = false;  ///< in some reachable state
    /// Where it was asked for, the search was cut off or found `many_states`; not where there is no memory for it.
    std::optional<StateProfile> profile = {};
    std::optional<Premises> premises = {};
    /// Per verdict with a run to a single state, the states of that run after the initial one.
    std::vector<std::vector<AbstractState>> paths = {};
};

/// Requires verify(network).empty().
TimedResult check_timed(const Network& network, const TimedOptions& options = {});

}  // namespace grafverif
