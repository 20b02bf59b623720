// SPDX-License-Identifier: MIT
// Timed engine: explicit-state model checking of a Network in integer time.
//
// Semantics: ir/network.hpp. One breadth-first exploration decides all properties about single states. Liveness
// properties are then decided on the state graph with UPPAAL semantics: a maximal run is infinite or ends in a state
// without successors; staying in a state forever is a run; in a state with p and q, `p leads to q` is fulfilled
// immediately.
//
// Exactness (proof: docs/explanation/timed-engine.md, "Exactness"). With closed clock constraints, integer time reaches
// the same discrete states as dense time; therefore `always`, `never` and `reachable` are exact. If the model has a
// strict constraint, a run that is found in integer time still decides these properties, but the absence of a run does
// not. A run in integer time can refute `inevitable`, `leads to`, `no deadlock` and `no timelock`. The engine decides
// that these properties hold only if no timelock can occur in dense time at a time that is not an integer. Otherwise,
// the verdict is unknown, and its reason names the location.
//
// Counterexamples to properties about single states have the minimum number of moves; a delay of any length counts as
// one move.
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

/// Number of found states from which on a search is large: then a state profile is computed.
constexpr std::uint64_t many_states = std::uint64_t{1} << 20U;

struct TimedProgress {
    std::uint64_t states = 0;
    std::uint64_t transitions = 0;
    std::uint64_t queue = 0;  ///< number of states found but not yet expanded
    std::uint64_t bytes = 0;
    double seconds = 0;
};

/// Premises of the covering (covering.hpp). If a member is true, the premise is dropped, so that tests can show that
/// the premise is necessary.
struct CoveringAblations {
    bool lower = false;  ///< true: lower bounds of clocks are ignored
    bool upper = false;  ///< true: upper bounds of clocks are ignored
    bool depth = false;  ///< true: a state is omitted even if the run to the simulating state is longer
};

/// Premises of macro-steps (macro_steps.hpp). If a member is true, the premise is dropped, so that tests can show that
/// the premise is necessary.
struct MacroStepAblations {
    bool properties = false;  ///< true: a transient state is omitted even if it decides a property
    bool timers = false;      ///< true: edges of timers are reordered even if something else reads the timers
    bool processes = false;   ///< true: states within a cycle are omitted even if other processes can move
    bool changes = false;     ///< true: an edge of the PLC is independent even if it changes variables that others read
};

struct MacroStepOptions {
    /// True: if all properties are about single states, the search omits transient states, and variables that nothing
    /// reads. Then runs do not have the minimum number of moves.
    bool enabled = false;
    /// Processes that move in transient states only by urgent edges (InputAbstraction::deferred).
    std::vector<Id<Network::Process>> deferred = {};
    /// PLCs that may begin a cycle whenever they wait and no timer has a request (InputAbstraction::unprompted).
    std::vector<Id<Network::Process>> unprompted = {};
    MacroStepAblations without = {};
};

/// Determines which searches compute TimedResult::profile. IfLarge: searches that a limit ended, and searches that
/// found at least `many_states` states.
enum class ProfileFor : std::uint8_t { None, IfLarge, All };

struct TimedOptions {
    std::vector<std::string> properties = {};  ///< names of the properties to check; all if empty. See `timelock`
    std::uint64_t max_states = 500'000'000;
    /// Maximum number of transitions; a search that reaches it ends as if it had reached `max_states`.
    std::uint64_t max_transitions = ~std::uint64_t{0};
    std::uint64_t max_memory = std::uint64_t{4} << 30U;  ///< bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;  ///< cancellation flag; if set, the check ends with the results so far
    unsigned jobs = 1;    ///< number of threads; 0 selects one per core. The results do not depend on this number
    unsigned slice = 64;  ///< maximum number of states in a slice, the unit of work of a thread
    /// True: edges of the state graph (links) are stored if a property needs them. False: the engine needs less memory,
    /// but several times more work for liveness properties.
    bool keep_links = true;
    bool timelock = true;                   ///< if false, `no timelock` is decided only if the model declares it
    bool premises = false;                  ///< compute TimedResult::premises
    std::vector<InputChoice> choices = {};  ///< choices of inputs, for an input abstraction
    /// True if the network is an input abstraction, with or without choices. Then `no timelock` holds only if no
    /// sequence of urgent edges is infinite.
    bool abstracted = false;
    /// True: if all properties are about single states, states that other states simulate are omitted (covering.hpp).
    bool covering = true;
    CoveringAblations covering_without = {};
    MacroStepOptions macro_steps = {};
    bool until_decided = false;  ///< true: the search ends when each property has been decided by a state
    bool paths = false;          ///< report TimedResult::paths
    /// Called for each state of a complete search without covering, after the verdicts are decided. Clocks have the
    /// values that represent them (ir/network_clocks.hpp).
    std::function<void(const NetworkState&)> each_state = {};
    std::function<void(const TimedProgress&)> progress = {};  ///< function that is called a few times per second
    ProfileFor profile = ProfileFor::IfLarge;
    std::function<void(const StateProfile&)> many = {};  ///< called once when the search has found `many_states`
    /// Function that returns the duration that determines the time unit; called when a profile is computed.
    std::function<std::optional<StateProfile::Finest>()> finest = {};
};

/// Facts that a complete search of a part (independent subsystem) determines, and on which verdicts about other parts
/// depend (docs/explanation/decomposition.md, "Sub-loops").
struct Premises {
    std::optional<Run> diverges = {};  ///< an infinite run in which time diverges; empty if no such run exists
    bool rests = false;                ///< true if no run continues forever within one instant
    bool settles = false;              ///< true if time passes only in quiescent states
};

/// A state of a run of an input abstraction. `state` is the state after `move`, without clock values.
struct AbstractState {
    Move move = {};
    NetworkState state = {};
    /// For each choice: a bit for each possible valuation; 0 if the move is not an edge of the PLC that makes the
    /// choice.
    std::vector<std::uint64_t> possible = {};
};

struct TimedResult {
    /// Verdicts in the order of the properties; the verdict on an undeclared `no timelock` is the last verdict.
    std::vector<Verdict> verdicts = {};
    std::vector<ModelError> errors = {};  ///< at most one error for each kind, edge and variable
    std::uint64_t states = 0;
    /// Number of computed edges, with those between the states of macro-steps, and delays of one unit.
    std::uint64_t transitions = 0;
    std::uint64_t bytes = 0;        ///< peak memory in bytes
    std::uint64_t state_bytes = 0;  ///< size of one packed state in bytes
    double seconds = 0;
    bool complete = true;      ///< true if every reachable state was expanded
    bool time_passes = false;  ///< true if time passes in some reachable state
    bool settles = true;       ///< false if the search looked for a quiescent state and found none
    /// State profile, if TimedOptions::profile selects the search. The profile is empty if there is not enough memory
    /// to compute it.
    std::optional<StateProfile> profile = {};
    std::optional<Premises> premises = {};
    /// For each verdict with a run to a single state: the states of this run after the initial state.
    std::vector<std::vector<AbstractState>> paths = {};
};

/// Checks the properties of `network`. Requires verify(network).empty().
TimedResult check_timed(const Network& network, const TimedOptions& options = {});

}  // namespace grafverif
