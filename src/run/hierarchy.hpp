// SPDX-License-Identifier: MIT
// Macro-steps, enclosing steps and forcing orders according to the rules of the standard, on sets of steps: activity is
// computed level by level up to a fixed point.
#pragma once

#include <vector>

#include "run/interpreter.hpp"

namespace grafverif {

/// The structure of a chart as far as the rules need it.
class Levels {
public:
    explicit Levels(const Chart& chart);

    /// The step that is activated instead of `step`: for a macro-step, the entry step of its expansion.
    Id<Chart::Step> entry(Id<Chart::Step> step) const;
    /// The step that must be active when `step` is left: for a macro-step, the exit step of its expansion.
    Id<Chart::Step> exit(Id<Chart::Step> step) const;

    /// True if the rules allow clearing `transition` once its steps are active. No order forces its chart, and for a
    /// source transition of an expansion or enclosed chart the owner is active.
    bool is_free(const Chart::Transition& transition, const std::vector<bool>& situation) const;

    /// The situation after an evolution from `old`; `cleared`: the result of rules 3 and 5.
    std::vector<bool> after(const std::vector<bool>& old, const std::vector<bool>& cleared) const;

    /// The situation after the user activates or deactivates `step`; for a macro-step, its expansion. The rules take
    /// precedence: the result may have another activity of `step`.
    std::vector<bool> by_hand(const std::vector<bool>& old, Id<Chart::Step> step, bool active) const;

    /// A step whose order forces the partial chart in `situation`; invalid if there is none.
    Id<Chart::Step> holder(Id<Chart::PartialChart> partial, const std::vector<bool>& situation) const;

    /// The situation at power-on.
    std::vector<bool> initial() const;

    /// One of two contradictory orders that are active in `situation`; invalid if there are none.
    Id<Chart::ForcingOrder> conflict(const std::vector<bool>& situation) const;

private:
    using Partial = Id<Chart::PartialChart>;

    bool contains(Partial region, Partial inner) const;
    std::vector<bool> round(const std::vector<bool>* old, const std::vector<bool>& cleared,
                            const std::vector<bool>& now) const;
    std::vector<bool> settled(const std::vector<bool>* old, const std::vector<bool>& cleared) const;
    void clear(Partial region, std::vector<bool>& situation) const;
    bool is_named(const Chart::ForcingOrder& order, Id<Chart::Step> step) const;
    bool agree(const Chart::ForcingOrder& one, const Chart::ForcingOrder& other) const;

    const Chart& chart_;
    bool has_hierarchy_ = false;
    std::vector<Id<Chart::Step>> entries_ = {}, exits_ = {};  ///< per macro-step: steps of its expansion
};

}  // namespace grafverif
