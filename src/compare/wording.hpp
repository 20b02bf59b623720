// SPDX-License-Identifier: MIT
// Wording: prints the parts of a chart. The caller provides the names of the steps.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"

namespace grafverif::comparing {

/// Returns the name of a step: `2`, `G1.2`.
using Naming = std::function<std::string(Id<Chart::Step>)>;

class Wording {
public:
    /// `chart` must outlive this object.
    Wording(const Chart& chart, Naming naming) : chart_(chart), naming_(std::move(naming)) {}

    /// Returns a term such as `!START && G1.X2`.
    std::string term(Id<Expr> term) const;
    /// Returns a declaration such as `N: int 0..3 = 1`.
    std::string variable(const Chart::Variable& variable) const;
    /// Returns a step without its actions, such as `initial step 2` or `macro step M expands E`.
    std::string head(Id<Chart::Step> step) const;
    /// Returns the actions of a step in the order of the tables, such as `LAMP if a after 3s`, `N := N + 1 on
    /// activation`, `force G1 := {2, 3}`.
    std::vector<std::string> actions(Id<Chart::Step> step) const;
    /// Returns the steps of a transition, such as `1, 2 -> 3`.
    std::string endpoints(Id<Chart::Transition> transition) const;
    /// Returns the condition and actions of a transition, such as `when a do N := 0`.
    std::string guard(Id<Chart::Transition> transition) const;

private:
    std::string names(const std::vector<Id<Chart::Step>>& steps) const;

    const Chart& chart_;
    Naming naming_;
};

}  // namespace grafverif::comparing
