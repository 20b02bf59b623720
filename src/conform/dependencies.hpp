// SPDX-License-Identifier: MIT
// Dependencies of an evolution: only the conditions of transitions whose upstream step is active, and the equations
// that depend on a firing transition, need to be evaluated. The others are known in advance. A large chart has many
// transitions and variables, and an evolution concerns few.
#pragma once

#include <cstdint>
#include <vector>

#include "conform/state_store.hpp"
#include "grafverif/ir/equations.hpp"

namespace grafverif::conform {

struct Dependencies {
    using Numbers = std::vector<std::uint32_t>;

    /// Equations that an evolution evaluates: if one of these transitions fires, or always.
    struct Computed {
        std::vector<Numbers> by_firing = {};
        Numbers always = {};
    };

    std::vector<Numbers> guarded = {};  ///< per field, a step activity: transitions that fire only if it holds
    Numbers unguarded = {};             ///< the other transitions
    Computed fields = {};               ///< all others keep their values
    Computed races = {};                ///< stored variables; all others do not race
    bool firing_unsettles = false;      ///< true if no situation in which a transition fires is stable
};

Dependencies dependencies(const Equations& equations, const StateLayout& layout);

}  // namespace grafverif::conform
