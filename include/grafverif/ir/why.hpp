// SPDX-License-Identifier: MIT
// Why: what the properties of a loop that hold rest on, found by leaving out one thing after the other (docs/why.md).
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
        /// Of a property about all states: instances and timers without which it fails, where all else that the plant and the
        /// timers do is left open. Their clocks have a say in it where `timings` has them too.
        std::vector<std::string> parts = {}, timings = {};
        bool about_states = false;           ///< false: parts were not asked for
        std::vector<std::string> open = {};  ///< parts that could not be decided, so that nothing is said of them
        bool never_asked = false;            ///< its left side never holds
        bool operator==(const Ground&) const = default;
    };

    enum class Kind { Transition, Step, Term, Guard, Edge };
    /// Something that was left out by itself, all else as it is (explain/drop.hpp).
    struct Thing {
        Kind kind = Kind::Transition;
        std::string name = {};                    ///< `t3`, `5`, `!a`, `shut -> opening`
        std::string of = {};                      ///< what a term is a condition of; the instance of an edge
        std::size_t nth = 1;                      ///< of those whose words are the same
        std::vector<std::string> needed_by = {};  ///< properties that fail without it
        std::vector<std::string> open = {};       ///< properties of which it could not be decided
        bool operator==(const Thing&) const = default;
    };

    std::vector<Ground> grounds = {};
    std::vector<Thing> things = {};                ///< by kind, each in the order of the model
    std::vector<std::string> unneeded_parts = {};  ///< that no property of these needs, and of which none is open
    std::size_t searches = 0;
    std::string ended = {};  ///< why not all was tried; empty: it was
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
