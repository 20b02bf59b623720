// SPDX-License-Identifier: MIT
// What an evolution has to look at. Of the conditions of transitions those whose step upstream is active; of the equations
// those that a transition which fires can make anything but `keep`. The rest is known beforehand: a large chart has many
// transitions and variables, and an evolution concerns few.
#pragma once

#include <cstdint>
#include <vector>

#include "conform/state_store.hpp"
#include "grafverif/ir/equations.hpp"

namespace grafverif::conform {

struct Dependencies {
    using Numbers = std::vector<std::uint32_t>;

    /// What an evolution computes: whenever one of these transitions fires, or in any case.
    struct Computed {
        std::vector<Numbers> by_firing = {};
        Numbers always = {};
    };

    std::vector<Numbers> guarded = {};  ///< per field: transitions that fire only where it, a step activity, holds
    Numbers unguarded = {};             ///< the other transitions
    Computed fields = {};               ///< all others keep their values
    Computed races = {};                ///< stored variables, of which all others do not race
    bool firing_unsettles = false;      ///< whether no situation in which a transition fires is stable
};

Dependencies dependencies(const Equations& equations, const StateLayout& layout);

}  // namespace grafverif::conform
