// SPDX-License-Identifier: MIT
// Why: what the properties of a loop that hold rest on, found by leaving out one thing after the other (docs/why.md).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace grafverif {

struct Why {
    /// A property that holds.
    struct Ground {
        std::string property = {};
        std::vector<std::string> transitions = {};  ///< never cleared, each by itself, they make it fail
        /// Of a property about all states: instances and timers without which it fails, where all else that the plant and the
        /// timers do is left open. Their clocks have a say in it where `timings` has them too.
        std::vector<std::string> parts = {}, timings = {};
        bool about_states = false;           ///< false: parts were not asked for
        std::vector<std::string> open = {};  ///< what could not be decided, so that nothing is said of it
        bool never_asked = false;            ///< its left side never holds
        bool operator==(const Ground&) const = default;
    };
    std::vector<Ground> grounds = {};
    /// What no property of these needs; nothing of which a property is open.
    std::vector<std::string> unneeded_transitions = {}, unneeded_parts = {};
    std::size_t searches = 0;
    std::string ended = {};  ///< why not all was tried; empty: it was
    bool operator==(const Why&) const = default;
};

}  // namespace grafverif
