// SPDX-License-Identifier: MIT
// Dependencies of an evolution. Only the conditions of transitions whose upstream step is active, and the equations
// that depend on a firing transition, must be evaluated. The others are known in advance. A large chart has many
// transitions and variables, but an evolution concerns few of them.
#pragma once

#include <cstdint>
#include <vector>

#include "conform/state_store.hpp"
#include "grafverif/ir/equations.hpp"

namespace grafverif::conform {

struct Dependencies {
    using Numbers = std::vector<std::uint32_t>;

    /// Equations that an evolution evaluates, either always or if one of these transitions fires.
    struct Computed {
        std::vector<Numbers> by_firing = {};
        Numbers always = {};
    };

    /// For each field that is a step activity: transitions that fire only if it holds.
    std::vector<Numbers> guarded = {};
    Numbers unguarded = {};         ///< all other transitions
    Computed fields = {};           ///< fields that may change; all others keep their values
    Computed races = {};            ///< stored variables that may have a race; all others cannot
    bool firing_unsettles = false;  ///< true if a situation in which a transition fires is never stable
};

Dependencies dependencies(const Equations& equations, const StateLayout& layout);

}  // namespace grafverif::conform
