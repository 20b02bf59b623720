// SPDX-License-Identifier: MIT
// Verdict: the result of an engine for one property, never a guess, with its run of the network.
//
// A run starts in the initial state of the Network. It is finite, or a lasso: the moves from `loop` on repeat forever;
// staying forever is a loop of one delay. A finite counterexample of `inevitable` or `leads to` ends in a state without
// successors. Every run with integer delays is a run of the dense-time model.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/property.hpp"

namespace grafverif {

/// Time passes.
struct Delay {
    std::int64_t units = 1;  ///< of the network's time unit
    bool operator==(const Delay&) const = default;
};
/// One edge of one process is taken.
struct Fire {
    Id<Network::Process> process = {};
    Id<Network::Edge> edge = {};  ///< in the template of the process
    bool operator==(const Fire&) const = default;
};
using Move = std::variant<Delay, Fire>;

struct Run {
    std::vector<Move> moves = {};
    std::optional<std::size_t> loop = {};  ///< the moves from here on lead back to the state before them

    bool operator==(const Run&) const = default;
};

enum class Outcome { Holds, Violated, Unknown };

/// Reason for an unknown verdict.
enum class UnknownReason {
    None,
    Bound,        ///< the limit of states is reached
    Memory,       ///< the memory limit is reached
    Stopped,      ///< stopped by the user or the deadline
    Inexact,      ///< integer time is inconclusive for dense time
    Unsupported,  ///< this engine does not support the property
    Faulty,       ///< the model has an error: see ModelError
    Failed,       ///< the external program gave no verdict
    Unchecked,    ///< the external program reports `holds` without evidence that can be checked
    Disagrees,    ///< the verdict of the external program contradicts its evidence, the model or the rules
};

/// The part of the network in which a verdict was found, if not all of it.
struct SearchScope {
    std::vector<std::string> searched = {};  ///< parts by name; empty: the complete network
    std::vector<std::string> left_out = {};  ///< the others; empty: all parts were explored, each separately
    std::string because = {};                ///< reason why these cannot affect the verdict
    bool cells = false;                      ///< parts are fragments, not independent subsystems
    bool operator==(const SearchScope&) const = default;
};

/// Names of instances reduced by the input abstraction of a verdict (docs/explanation/decomposition.md, "Input
/// abstraction").
struct InputsAbstracted {
    std::vector<std::string> chosen = {}, untimed = {}, paced = {};
    bool operator==(const InputsAbstracted&) const = default;
};

struct Verdict {
    Id<Property> about = {};    ///< in the checked model; invalid: not declared there (see `declared`)
    std::string property = {};  ///< its name; for one that expands: `S.X7`
    Pattern pattern = Pattern::Always;
    Outcome outcome = Outcome::Unknown;
    UnknownReason obstacle = UnknownReason::None;
    std::string reason = {};  ///< text, for an unknown verdict
    bool vacuous = false;     ///< holds vacuously; a note states why
    std::vector<std::string> notes = {};
    bool declared = true;  ///< false: decided although the model does not declare it (`no timelock`)
    bool expected_violated = false;
    std::string states = {};  ///< number of explored states, in decimal, of any size; empty: unknown
    std::optional<std::uint64_t> transitions = {};
    double seconds = 0;
    SearchScope scope = {};
    std::optional<InputsAbstracted> abstraction = {};  ///< with a run: it may not be a shortest one
    std::optional<Run> run = {};                       ///< counterexample; for a `reachable` that holds: witness
    Span origin = {};                                  ///< of the property

    bool operator==(const Verdict&) const = default;
};

/// A model error; the run leads to the state before `edge` is taken, or for a race to the state with the race.
struct ModelError {
    enum class Kind {
        OutOfRange,  ///< `edge` assigns `variable` a value outside its range
        ActionRace,  ///< two stored actions write different values in one evolution: the flag `variable` is set
        NoValue,     ///< the guard or an assignment of `edge` divides by zero
    };
    Kind kind = Kind::OutOfRange;
    Id<Network::Variable> variable = {};
    Id<Network::Process> process = {};  ///< process of the edge; invalid for a race
    Id<Network::Edge> edge = {};
    Run run = {};

    bool operator==(const ModelError&) const = default;
};

/// `holds`, `violated`, `unknown`.
std::string_view word(Outcome outcome);
/// `bound`, `memory`, `stopped`, `inexact`, `unsupported`, `faulty`, `failed`, `unchecked`, `engine-disagrees`; empty
/// for None.
std::string_view word(UnknownReason obstacle);
/// The code of a model error: `out-of-range`, `action-race`, `no-value`.
std::string_view word(ModelError::Kind kind);
/// Describes a model error: `` `N` would leave its range 0..3, in an evolution of `press` ``.
std::string text_of(const Network& network, const ModelError& error);

/// The initial verdict, without a result, for `property`, which has the id `about` in its model.
Verdict verdict_on(Id<Property> about, const Property& property);

/// Makes the verdict of an external program unknown (`engine-disagrees`) with this reason.
void distrust(Verdict& verdict, std::string_view why);

/// True if the verdict is the expected one; an unknown one never is.
bool as_expected(const Verdict& verdict);

}  // namespace grafverif
