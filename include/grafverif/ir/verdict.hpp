// SPDX-License-Identifier: MIT
// Verdict: the result of an engine for one property. A verdict may contain a run of the network as evidence.
//
// A run starts in the initial state of the Network. A run is finite or infinite; in an infinite run, the moves from
// `loop` on repeat forever. If a run stays in one state forever, the repeated moves are one delay. A finite
// counterexample of `inevitable` or `leads to` ends in a state without successors. A run with integer delays is also a
// run of the dense-time model.
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

/// A delay: time passes.
struct Delay {
    std::int64_t units = 1;  ///< number of time units of the network
    bool operator==(const Delay&) const = default;
};
/// A move of a run: a process takes an edge.
struct Fire {
    Id<Network::Process> process = {};
    Id<Network::Edge> edge = {};  ///< edge of the template of the process
    bool operator==(const Fire&) const = default;
};
using Move = std::variant<Delay, Fire>;

struct Run {
    std::vector<Move> moves = {};
    /// The moves from this index on lead back to the state before the move with this index; empty for a finite run.
    std::optional<std::size_t> loop = {};

    bool operator==(const Run&) const = default;
};

enum class Outcome { Holds, Violated, Unknown };

/// Reason for an unknown verdict.
enum class UnknownReason {
    None,
    Bound,        ///< the maximum number of states was reached
    Memory,       ///< the memory limit was reached
    Stopped,      ///< the user or the deadline stopped the engine
    Inexact,      ///< the result for integer time does not decide the property for dense time
    Unsupported,  ///< this engine does not support the property
    Faulty,       ///< the model has an error: see ModelError
    Failed,       ///< the external program gave no verdict
    Unchecked,    ///< the external program reports `holds` without evidence that can be checked

    /// The verdict of the external program contradicts the run that it returned, the model, or the rules of IEC 60848.
    Disagrees,
};

/// The subsystems or fragments of the network that were explored for a verdict.
struct SearchScope {
    /// Names of the explored subsystems or fragments.
    std::vector<std::string> searched = {};
    /// Names of the subsystems or fragments that were not explored. If `searched` and `left_out` are empty, the
    /// complete network was explored.
    std::vector<std::string> left_out = {};
    std::string because = {};  ///< reason why the subsystems or fragments in `left_out` cannot affect the verdict
    bool cells = false;        ///< true: the names are names of fragments; false: names of independent subsystems
    bool operator==(const SearchScope&) const = default;
};

/// Names of the instances that the input abstraction of a verdict simplified
/// (docs/explanation/decomposition.md, "Input abstraction").
struct InputsAbstracted {
    std::vector<std::string> chosen = {}, untimed = {}, paced = {};
    bool operator==(const InputsAbstracted&) const = default;
};

struct Verdict {
    Id<Property> about = {};  ///< property of the model; invalid if not `declared`

    /// Name of the property; for a property `S` of the form `reachable all steps`, `S.X7` for step 7.
    std::string property = {};
    Pattern pattern = Pattern::Always;
    Outcome outcome = Outcome::Unknown;
    UnknownReason obstacle = UnknownReason::None;
    std::string reason = {};  ///< reason for an unknown verdict, as text
    bool vacuous = false;     ///< true: the property holds vacuously; a note states why
    std::vector<std::string> notes = {};
    bool declared = true;  ///< false if the model does not declare the property (`no timelock`)
    bool expected_violated = false;
    std::string states = {};  ///< number of explored states, in decimal, of any size; empty if unknown
    std::optional<std::uint64_t> transitions = {};
    double seconds = 0;
    SearchScope scope = {};
    /// The input abstraction of the verdict, if one was used; `run` is then not necessarily a
    /// shortest run.
    std::optional<InputsAbstracted> abstraction = {};
    std::optional<Run> run = {};  ///< counterexample, or witness of a `reachable` property that holds
    Span origin = {};             ///< position of the property in the sources

    bool operator==(const Verdict&) const = default;
};

/// A model error. The run ends in the state in which `edge` can be taken; for a race, the run ends in the state in
/// which the flag is set.
struct ModelError {
    enum class Kind {
        OutOfRange,  ///< `edge` assigns `variable` a value outside its range
        ActionRace,  ///< two stored actions write different values in one evolution: the flag `variable` is set
        NoValue,     ///< the guard or an assignment of `edge` divides by zero
    };
    Kind kind = Kind::OutOfRange;
    Id<Network::Variable> variable = {};
    Id<Network::Process> process = {};  ///< process of `edge`; invalid for a race
    Id<Network::Edge> edge = {};
    Run run = {};

    bool operator==(const ModelError&) const = default;
};

/// Returns `holds`, `violated` or `unknown`.
std::string_view word(Outcome outcome);
/// Returns `bound`, `memory`, `stopped`, `inexact`, `unsupported`, `faulty`, `failed`, `unchecked` or
/// `engine-disagrees`; empty for None.
std::string_view word(UnknownReason obstacle);
/// Returns the code of a model error: `out-of-range`, `action-race` or `no-value`.
std::string_view word(ModelError::Kind kind);
/// Returns a description of a model error, such as `` `N` would leave its range 0..3, in an evolution of `press` ``.
std::string text_of(const Network& network, const ModelError& error);

/// Returns an initial verdict without a result for `property`, which has the id `about` in its model.
Verdict verdict_on(Id<Property> about, const Property& property);

/// Changes a verdict to unknown. The arguments are the class and the text of the reason.
void set_unknown(Verdict& verdict, UnknownReason obstacle, std::string reason);

/// Returns the reason for an unknown verdict at a memory limit of `bytes`, such as `memory limit of 512 MiB reached`.
std::string memory_limit_reached(std::uint64_t bytes);

/// Changes the verdict of an external program to unknown (`engine-disagrees`) with the reason `why`.
void distrust(Verdict& verdict, std::string_view why);

/// True if the property is violated and `expected_violated` is true, or if the property holds and `expected_violated`
/// is false.
bool as_expected(const Verdict& verdict);

}  // namespace grafverif
