// SPDX-License-Identifier: MIT
// Verdict: the answer of an engine to one property, never a guess, with the run of the network that shows it.
//
// A run starts in the initial state of the Network. It is finite, or a lasso: the moves from `loop` on repeat forever;
// staying forever is a loop of one delay. A finite counterexample of `inevitable` or `leads to` ends in a state without
// successors. Every run of integer delays is a run of the dense-time model.
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
/// One edge of one process fires.
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

/// Why a verdict is unknown.
enum class Obstacle {
    None,
    Bound,        ///< the number of states allowed is used up
    Memory,       ///< the memory allowed is used up
    Stopped,      ///< the user or the deadline ended the search
    Inexact,      ///< integer time does not decide it for dense time
    Unsupported,  ///< this engine does not take the property
    Faulty,       ///< the model breaks off somewhere: see ModelError
    Failed,       ///< the external program gave no verdict
    Unchecked,    ///< it says `holds`, and shows nothing that could be checked
    Disagrees,    ///< the external program gave one that its own words, our model or the rules contradict
};

/// What a verdict was found in, where that is not the whole network.
struct Scope {
    std::vector<std::string> searched = {};  ///< parts by name; none: the whole
    std::vector<std::string> left_out = {};  ///< the others; none: those searched are all, each by itself
    std::string because = {};                ///< why these have no say
    bool cells = false;                      ///< the parts are cells, else sub-loops
    bool operator==(const Scope&) const = default;
};

/// Instances, by name, that the input abstraction behind a verdict reduced (docs/engines.md, "Input abstraction").
struct InputsAbstracted {
    std::vector<std::string> chosen = {}, untimed = {}, paced = {};
    bool operator==(const InputsAbstracted&) const = default;
};

struct Verdict {
    Id<Property> about = {};    ///< of the model checked; not valid: the model does not ask (see `declared`)
    std::string property = {};  ///< its name; of one that expands: `S.X7`
    Pattern pattern = Pattern::Always;
    Outcome outcome = Outcome::Unknown;
    Obstacle obstacle = Obstacle::None;
    std::string reason = {};  ///< of an unknown verdict, in words
    bool vacuous = false;     ///< holds for want of anything to judge; a note says why
    std::vector<std::string> notes = {};
    bool declared = true;  ///< false: decided though the model does not ask (`no timelock`)
    bool expected_violated = false;
    std::string states = {};  ///< of the whole search, in decimal, however many; empty: not known
    std::optional<std::uint64_t> transitions = {};
    double seconds = 0;
    Scope scope = {};
    std::optional<InputsAbstracted> abstraction = {};  ///< with a run: it need not be a shortest one
    std::optional<Run> run = {};                       ///< counterexample; of a `reachable` that holds: witness
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
    Id<Network::Process> process = {};  ///< whose edge it is; for a race not valid
    Id<Network::Edge> edge = {};
    Run run = {};

    bool operator==(const ModelError&) const = default;
};

/// `holds`, `violated`, `unknown`.
std::string_view word(Outcome outcome);
/// `bound`, `memory`, `stopped`, `inexact`, `unsupported`, `faulty`, `failed`, `unchecked`, `engine-disagrees`; empty for None.
std::string_view word(Obstacle obstacle);
/// The code of a model error: `out-of-range`, `action-race`, `no-value`.
std::string_view word(ModelError::Kind kind);
/// What breaks off and where: `` `N` would leave its range 0..3, in an evolution of `press` ``.
std::string text_of(const Network& network, const ModelError& error);

/// The verdict on `property`, the one called `about` in its model, before anything is known.
Verdict verdict_on(Id<Property> about, const Property& property);

/// Makes the verdict of an external program unknown (`engine-disagrees`), for this reason.
void distrust(Verdict& verdict, std::string_view why);

/// Whether the verdict is the one the model asks for; an unknown one never is.
bool as_expected(const Verdict& verdict);

}  // namespace grafverif
