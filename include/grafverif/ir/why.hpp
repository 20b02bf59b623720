// SPDX-License-Identifier: MIT
// Why: dependencies of the proofs of a loop's properties, found by removing single elements (docs/explanation/why.md).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif {

struct Why {
    /// A property that holds.
    struct Ground {
        std::string property = {};
        /// For a state property: instances and timers without which it fails, while all other behaviour of plant and
        /// timers is arbitrary. Their clocks are also necessary if they are in `timings`.
        std::vector<std::string> parts = {}, timings = {};
        bool about_states = false;           ///< false: parts were not examined
        std::vector<std::string> open = {};  ///< parts without a result
        bool never_asked = false;            ///< its premise is never true
        bool operator==(const Ground&) const = default;
    };

    enum class Kind { Transition, Step, Term, Guard, Edge };
    /// A removed element; all others are unchanged (explain/drop.hpp).
    struct Thing {
        Kind kind = Kind::Transition;
        std::string name = {};                    ///< `t3`, `5`, `!a`, `shut -> opening`
        std::string of = {};                      ///< the owner of a term; the instance of an edge
        std::size_t nth = 1;                      ///< index among elements with the same name
        std::vector<std::string> needed_by = {};  ///< properties that fail without it
        std::vector<std::string> open = {};       ///< properties without a result
        bool operator==(const Thing&) const = default;
    };

    std::vector<Ground> grounds = {};
    std::vector<Thing> things = {};                ///< by kind, each in the order of the model
    std::vector<std::string> unneeded_parts = {};  ///< not needed by any of these properties, with all results known
    std::size_t searches = 0;
    std::string ended = {};  ///< reason why not all elements were tried; empty if all were
    bool operator==(const Why&) const = default;
};

/// `transition`, `step`, `term`, `guard`, `edge`.
constexpr std::string_view word(Why::Kind kind) {
    switch (kind) {
    case Why::Kind::Transition: return "transition";
    case Why::Kind::Step: return "step";
    case Why::Kind::Term: return "term";
    case Why::Kind::Guard: return "guard";
    case Why::Kind::Edge: return "edge";
    }
    return {};
}

}  // namespace grafverif
