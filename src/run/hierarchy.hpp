// SPDX-License-Identifier: MIT
// Macro-steps, enclosing steps and forcing orders by the rules of the standard, on sets of steps: what is active is
// looked up, level by level, until nothing changes any more.
#pragma once

#include <vector>

#include "run/interpreter.hpp"

namespace grafverif {

/// The structure of a chart, as far as the rules ask for it.
class Levels {
public:
    explicit Levels(const Chart& chart);

    /// What is activated in the place of `step`: of a macro-step, the entry step of its expansion.
    Id<Chart::Step> entry(Id<Chart::Step> step) const;
    /// What must be active in its place when it is left.
    Id<Chart::Step> exit(Id<Chart::Step> step) const;

    /// Whether the rules let `transition` be cleared, were its steps active: no order holds its chart, and a source
    /// transition of an expansion or enclosed chart has its owner active.
    bool is_free(const Chart::Transition& transition, const std::vector<bool>& situation) const;

    /// The situation after an evolution from `old`, `cleared` being what rules 3 and 5 make of it.
    std::vector<bool> after(const std::vector<bool>& old, const std::vector<bool>& cleared) const;

    /// The situation after somebody has made `step` active, or not, by hand; of a macro-step its expansion. The rules have
    /// the last word: `step` may not be what it was made.
    std::vector<bool> by_hand(const std::vector<bool>& old, Id<Chart::Step> step, bool active) const;

    /// A step whose order holds the partial chart in `situation`; not valid: none does.
    Id<Chart::Step> holder(Id<Chart::PartialChart> partial, const std::vector<bool>& situation) const;

    /// The situation at power-on.
    std::vector<bool> initial() const;

    /// Whether `situation` has two orders that cannot be obeyed together; then one of them.
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
    std::vector<Id<Chart::Step>> entries_ = {}, exits_ = {};  ///< per step: of the expansion of a macro-step
};

}  // namespace grafverif
