// SPDX-License-Identifier: MIT
// Timed engine: explicit-state model checking of a Network in integer time.
//
// Semantics: ir/network.hpp. One breadth-first exploration decides all state properties. Liveness properties are then
// decided on the state graph with UPPAAL semantics: a maximal run is infinite or ends in a state without successors;
// staying in a state forever is a run; a state that satisfies p and q fulfils `p leads to q`.
//
// Exactness (proof: docs/explanation/timed-engine.md, "Exactness"). With closed clock constraints, integer time reaches
// the same discrete states as dense time; therefore `always`, `never` and `reachable` are exact. With a strict
// constraint, only runs that are found in integer time are conclusive for these properties. An integer run can refute
// `inevitable`, `leads to`, `no deadlock` and `no timelock`. These properties hold only if no timelock can occur
// between two ticks; otherwise the verdict is unknown and its reason names the location.
//
// Counterexamples to state properties have the minimum number of moves; a delay of any length counts as one move.
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

/// Number of states at which a state profile is computed.
constexpr std::uint64_t many_states = std::uint64_t{1} << 20U;

struct TimedProgress {
    std::uint64_t states = 0;
    std::uint64_t transitions = 0;
    std::uint64_t queue = 0;  ///< number of states found but not yet expanded
    std::uint64_t bytes = 0;
    double seconds = 0;
};

/// Premises of the covering (covering.hpp) that tests omit on purpose.
struct CoveringAblations {
    bool lower = false;  ///< lower bounds of clocks are ignored
    bool upper = false;  ///< upper bounds of clocks are ignored
    bool depth = false;  ///< a state is omitted although the run to the state that simulates it may be longer
};

/// Determines which searches compute TimedResult::profile. IfLarge: those that a limit ended, and those that found
/// `many_states` states.
enum class ProfileFor : std::uint8_t { None, IfLarge, All };

struct TimedOptions {
    std::vector<std::string> properties = {};  ///< names of the properties to check; all if empty. See `timelock`
    std::uint64_t max_states = 500'000'000;
    std::uint64_t max_transitions = ~std::uint64_t{0};   ///< bound on the work; reported like `max_states`
    std::uint64_t max_memory = std::uint64_t{4} << 30U;  ///< bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;  ///< cancellation flag: return the results so far
    unsigned jobs = 1;    ///< number of threads; 0 selects one per core. The results do not depend on it
    unsigned slice = 64;  ///< number of states in a unit of work of a thread
    /// If false, the engine needs less memory, but several times more work for liveness. Links are stored only if a
    /// property needs them.
    bool keep_links = true;
    bool timelock = true;                   ///< if false, `no timelock` is decided only if a property requires it
    bool premises = false;                  ///< compute TimedResult::premises
    std::vector<InputChoice> choices = {};  ///< choices of inputs, for an input abstraction
    /// The network is an input abstraction, with or without choices: `no timelock` holds only if no sequence of urgent
    /// edges is infinite.
    bool abstracted = false;
    /// Omit states that other states simulate (covering.hpp), if all properties are about single states.
    bool covering = true;
    CoveringAblations covering_without = {};
    bool until_decided = false;  ///< end the search when each property is decided by a state
    bool paths = false;          ///< report TimedResult::paths
    std::function<void(const TimedProgress&)> progress = {};  ///< function that is called a few times per second
    ProfileFor profile = ProfileFor::IfLarge;
    std::function<void(const StateProfile&)> many = {};  ///< called once when the search has found `many_states`
    /// Function that is called when a profile is computed.
    std::function<std::optional<StateProfile::Finest>()> finest = {};
};

/// Results of a complete search of a part, on which verdicts about other parts depend
/// (docs/explanation/decomposition.md, "Sub-loops").
struct Premises {
    std::optional<Run> diverges = {};  ///< a lasso in which time diverges; empty if no such run exists
    bool rests = false;                ///< true if no run continues forever within one instant
    bool settles = false;              ///< true if time passes only in quiescent states
};

/// A state of a run of an input abstraction, without clocks: the state after `move`.
struct AbstractState {
    Move move = {};
    NetworkState state = {};
    /// For each choice: a bit for each possible valuation; 0 if the move is not an edge of the PLC that makes the
    /// choice.
    std::vector<std::uint64_t> possible = {};
};

struct TimedResult {
    /// Verdicts in the order of the properties; an undeclared `no timelock` is the last.
    std::vector<Verdict> verdicts = {};
    std::vector<ModelError> errors = {};  ///< at most one error for each kind, edge and variable
    std::uint64_t states = 0;
    std::uint64_t transitions = 0;  ///< number of edges and delays of one unit
    std::uint64_t bytes = 0;        ///< peak memory in bytes
    std::uint64_t state_bytes = 0;  ///< size of one packed state in bytes
    double seconds = 0;
    bool complete = true;      ///< true if every reachable state was expanded
    bool time_passes = false;  ///< true if time passes in some reachable state
    bool settles = true;       ///< false if a quiescent state was searched for and not found
    /// State profile, if TimedOptions::profile selects the search. It is empty if there is not enough memory.
    std::optional<StateProfile> profile = {};
    std::optional<Premises> premises = {};
    /// For each verdict with a run to a single state: the states of this run after the initial state.
    std::vector<std::vector<AbstractState>> paths = {};
};

/// Checks the properties of `network`. Requires verify(network).empty().
TimedResult check_timed(const Network& network, const TimedOptions& options = {});

}  // namespace grafverif
