// SPDX-License-Identifier: MIT
// Timed engine: explicit-state model checking of a Network in integer time.
//
// The semantics is defined in ir/network.hpp. One breadth-first exploration decides all properties about single states.
// Liveness properties are then decided on the state graph with UPPAAL semantics: a maximal run is infinite or ends in a
// state without successors; staying in a state forever is a run; a state in which p and q hold fulfils `p leads to q`
// immediately.
//
// Exactness (proof: docs/explanation/timed-engine.md, "Exactness"). With closed clock constraints, integer time reaches
// the same discrete states as dense time; therefore `always`, `never` and `reachable` are exact. If the model has a
// strict constraint, a run in integer time still decides these properties, but the absence of a run in integer time
// does not. A run in integer time can refute `inevitable`, `leads to`, `no deadlock` and `no timelock`. The engine
// proves that one of these properties holds only if no timelock can occur in dense time at a time that is not an
// integer. If such a timelock may occur, the verdict is unknown, and its reason names the location.
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

/// A search with at least this number of states is large. By default, a state profile is computed for a large search.
constexpr std::uint64_t many_states = std::uint64_t{1} << 20U;

struct TimedProgress {
    std::uint64_t states = 0;
    std::uint64_t transitions = 0;
    std::uint64_t queue = 0;  ///< number of states that are found but not yet expanded
    std::uint64_t bytes = 0;
    double seconds = 0;
};

/// Premises of the covering (covering.hpp). If a member is true, the premise is dropped, so that tests can show that
/// the premise is necessary.
struct CoveringAblations {
    bool lower = false;  ///< if true, lower bounds of clocks are ignored
    bool upper = false;  ///< if true, upper bounds of clocks are ignored
    bool depth = false;  ///< if true, a state is omitted even if the run to the simulating state is longer
};

/// Premises of macro-steps (macro_steps.hpp). If a member is true, the premise is dropped, so that tests can show that
/// the premise is necessary.
struct MacroStepAblations {
    bool properties = false;  ///< if true, a transient state is omitted even if it decides a property
    bool timers = false;      ///< if true, edges of timers are reordered even if other processes or properties read the
                              ///< timers
    bool processes = false;   ///< if true, states within a cycle are omitted even if other processes can move
    bool changes = false;     ///< if true, an edge of the PLC counts as independent even if it changes variables that
                              ///< other processes read
};

struct MacroStepOptions {
    /// If true and all properties are about single states, the search does not store transient states. It also does not
    /// store variables that no edge and no property reads. In this case, runs do not have the minimum number of moves.
    bool enabled = false;
    /// Processes that, in transient states, move only by urgent edges (InputAbstraction::deferred).
    std::vector<Id<Network::Process>> deferred = {};
    /// PLCs that may begin a cycle whenever they wait and no timer has a request (InputAbstraction::unprompted).
    std::vector<Id<Network::Process>> unprompted = {};
    MacroStepAblations without = {};
};

/// Determines which searches compute TimedResult::profile. IfLarge selects searches that a limit ended, and searches
/// that found at least `many_states` states.
enum class ProfileFor : std::uint8_t { None, IfLarge, All };

struct TimedOptions {
    std::vector<std::string> properties = {};  ///< names of the properties to check; an empty list selects all; see
                                               ///< also `timelock`
    std::uint64_t max_states = 500'000'000;
    /// Maximum number of transitions. A search that reaches this number ends as if it had reached `max_states`.
    std::uint64_t max_transitions = ~std::uint64_t{0};
    std::uint64_t max_memory = std::uint64_t{4} << 30U;  ///< memory limit in bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;  ///< cancellation flag; if set, the check ends with the results so far
    unsigned jobs = 1;    ///< number of threads; 0 selects one thread per core. The results do not depend on this
                          ///< number.
    unsigned slice = 64;  ///< maximum number of states in a slice, the unit of work of a thread

    /// If true, the engine stores the edges of the state graph (links) if a property needs them. If false, the engine
    /// needs less memory, but liveness properties need several times more work.
    bool keep_links = true;
    bool timelock = true;                   ///< if false, `no timelock` is decided only if the model declares it
    bool premises = false;                  ///< if true, TimedResult::premises is computed
    std::vector<InputChoice> choices = {};  ///< choices of input values, if the network is an input abstraction

    /// True if the network is an input abstraction, with or without choices. For an input abstraction, `no timelock`
    /// holds only if no sequence of urgent edges is infinite.
    bool abstracted = false;
    /// If true and all properties are about single states, the search omits states that other states simulate
    /// (covering.hpp).
    bool covering = true;
    CoveringAblations covering_without = {};
    MacroStepOptions macro_steps = {};
    bool until_decided = false;  ///< if true, the search ends when single states have decided all properties
    bool paths = false;          ///< if true, TimedResult::paths is computed

    /// Called for each state, after the verdicts are computed. Not called if the search is incomplete or covering is
    /// used. A clock value above the cap of the clock is represented by the cap (ir/network_clocks.hpp).
    std::function<void(const NetworkState&)> each_state = {};
    std::function<void(const TimedProgress&)> progress = {};  ///< called a few times per second
    ProfileFor profile = ProfileFor::IfLarge;
    /// Called once, when the search has found `many_states` states.
    std::function<void(const StateProfile&)> many = {};
    /// Returns the duration of the model that determines the time unit. Called when a profile is computed.
    std::function<std::optional<StateProfile::Finest>()> finest = {};
};

/// Facts about a part (independent subsystem), on which verdicts about other parts depend
/// (docs/explanation/decomposition.md, "Sub-loops"). A complete search of the part determines these facts.
struct Premises {
    std::optional<Run> diverges = {};  ///< an infinite run in which time diverges; empty if no such run exists
    bool rests = false;                ///< true if no run continues forever within one instant
    bool settles = false;              ///< true if time passes only in quiescent states
};

/// A state of a run of an input abstraction. `state` is the state after `move`, without clock values.
struct AbstractState {
    Move move = {};
    NetworkState state = {};
    /// For each choice: a bit for each possible valuation. Each choice is made by one PLC; its bits are 0 if `move` is
    /// not an edge of this PLC.
    std::vector<std::uint64_t> possible = {};
};

struct TimedResult {
    /// Verdicts in the order of the properties; if the network does not declare `no timelock`, the verdict on `no
    /// timelock` is the last verdict.
    std::vector<Verdict> verdicts = {};
    std::vector<ModelError> errors = {};  ///< at most one error for each kind, edge and variable
    std::uint64_t states = 0;
    /// Number of computed edges and delays of one time unit, including edges inside macro-steps.
    std::uint64_t transitions = 0;
    std::uint64_t bytes = 0;        ///< peak memory in bytes
    std::uint64_t state_bytes = 0;  ///< size of one packed state in bytes
    double seconds = 0;
    bool complete = true;      ///< true if every reachable state was expanded
    bool time_passes = false;  ///< true if time passes in some reachable state
    bool settles = true;       ///< false if a search for a quiescent state found no such state

    /// State profile, if TimedOptions::profile selects this search. Also empty if memory is insufficient for the
    /// computation of the profile.
    std::optional<StateProfile> profile = {};
    std::optional<Premises> premises = {};
    /// For each verdict that a run to a single state decides: the states of this run after the initial state.
    std::vector<std::vector<AbstractState>> paths = {};
};

/// Checks the properties of `network`. Requires verify(network).empty().
TimedResult check_timed(const Network& network, const TimedOptions& options = {});

}  // namespace grafverif
