// SPDX-License-Identifier: MIT
// Dependencies of an evolution. The condition of a transition with an upstream step needs to be evaluated only if this
// step (the first one, if there are several) is active. An equation whose value changes only by firing needs to be
// evaluated only if a transition on which it depends fires. All other conditions of transitions and all other equations
// are always evaluated. The results of the conditions and equations that are not evaluated are known in advance. This
// is efficient, because an evolution concerns only few of the many transitions and variables in a large chart.
#pragma once

#include <cstdint>
#include <vector>

#include "conform/state_store.hpp"
#include "grafverif/ir/equations.hpp"

namespace grafverif::conform {

struct Dependencies {
    using Numbers = std::vector<std::uint32_t>;

    /// Equations that an evolution evaluates: always (`always`), or only if a specific transition fires (`by_firing`).
    struct Computed {
        std::vector<Numbers> by_firing = {};
        Numbers always = {};
    };

    /// For each field that is a step activity: transitions that fire only if the step is active.
    std::vector<Numbers> guarded = {};
    Numbers unguarded = {};         ///< all other transitions
    Computed fields = {};           ///< fields that may change; all other fields keep their values
    Computed races = {};            ///< stored variables on which a race is possible
    bool firing_unsettles = false;  ///< true if a situation in which a transition fires is never stable
};

Dependencies dependencies(const Equations& equations, const StateLayout& layout);

}  // namespace grafverif::conform
