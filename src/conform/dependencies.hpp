// SPDX-License-Identifier: MIT
// Determines which conditions and equations an evolution must evaluate. The condition of a transition with upstream
// steps needs to be evaluated only if the first upstream step is active. An equation whose value changes only by firing
// needs to be evaluated only if a transition on which it depends fires. All other conditions of transitions and all
// other equations are always evaluated. A condition that is not evaluated is false; the variable of an equation that is
// not evaluated keeps its value. This method saves time, because an evolution changes only few of the many variables in
// a large chart.
#pragma once

#include <cstdint>
#include <vector>

#include "conform/state_store.hpp"
#include "grafverif/ir/equations.hpp"

namespace grafverif::conform {

struct Dependencies {
    using Numbers = std::vector<std::uint32_t>;

    /// Equations that every evolution evaluates (`always`), and, per transition, equations that an evolution evaluates
    /// only if this transition fires (`by_firing`).
    struct Computed {
        std::vector<Numbers> by_firing = {};
        Numbers always = {};
    };

    /// For each field: if the field is the activity of a step, the transitions whose first upstream step is this step;
    /// otherwise an empty list.
    std::vector<Numbers> guarded = {};
    Numbers unguarded = {};  ///< transitions without an upstream step
    Computed fields = {};    ///< fields that may change; all other fields keep their values
    Computed races = {};     ///< stored variables to which two actions may write different values (race)

    /// True if a situation is never stable when a transition fires in it.
    bool firing_unsettles = false;
};

Dependencies dependencies(const Equations& equations, const StateLayout& layout);

}  // namespace grafverif::conform
