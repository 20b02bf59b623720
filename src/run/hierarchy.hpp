// SPDX-License-Identifier: MIT
// Applies the rules of the standard for macro-steps, enclosing steps and forcing orders to sets of steps. The activity
// of steps is computed for one level of the hierarchy after another, until the activity no longer changes.
#pragma once

#include <vector>

#include "run/interpreter.hpp"

namespace grafverif {

/// The levels of the hierarchy of a chart, with the rules that apply to them.
class Levels {
public:
    explicit Levels(const Chart& chart);

    /// Returns the step that is activated in place of `step`: for a macro-step, the entry step of its expansion.
    Id<Chart::Step> entry(Id<Chart::Step> step) const;
    /// Returns the step that must be active for transitions from `step` to be enabled: for a macro-step, the exit step
    /// of its expansion.
    Id<Chart::Step> exit(Id<Chart::Step> step) const;

    /// True if the rules allow clearing `transition` when its upstream steps are active: no forcing order is active for
    /// its chart. For a source transition of an expansion or of an enclosed chart, the macro-step or the enclosing step
    /// must also be active.
    bool is_free(const Chart::Transition& transition, const std::vector<bool>& situation) const;

    /// Returns the situation after an evolution from `old`. `cleared` is the situation that results from rules 3 and 5.
    std::vector<bool> after(const std::vector<bool>& old, const std::vector<bool>& cleared) const;

    /// Returns the situation after the user activates or deactivates `step`, or the expansion of a macro-step. The
    /// rules of the hierarchy take precedence over the user; therefore, the activity of `step` in the result may differ
    /// from `active`.
    std::vector<bool> by_hand(const std::vector<bool>& old, Id<Chart::Step> step, bool active) const;

    /// Returns an active step of `situation` whose forcing order forces the partial chart, or an invalid id if no
    /// forcing order forces it.
    Id<Chart::Step> holder(Id<Chart::PartialChart> partial, const std::vector<bool>& situation) const;

    /// Returns the situation at power-on.
    std::vector<bool> initial() const;

    /// Returns one of two contradictory forcing orders that are active in `situation`, or an invalid id if no active
    /// orders are contradictory.
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
    /// Per macro-step: entry step and exit step of its expansion.
    std::vector<Id<Chart::Step>> entries_ = {}, exits_ = {};
};

}  // namespace grafverif
