// SPDX-License-Identifier: MIT
// Wording: prints the parts of a chart, with names of steps that the caller provides.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"

namespace grafverif::comparing {

/// The name of a step: `2`, `G1.2`.
using Naming = std::function<std::string(Id<Chart::Step>)>;

class Wording {
public:
    /// `chart` must outlive this object.
    Wording(const Chart& chart, Naming naming) : chart_(chart), naming_(std::move(naming)) {}

    /// `!START && G1.X2`
    std::string term(Id<Expr> term) const;
    /// `N: int 0..3 = 1`
    std::string variable(const Chart::Variable& variable) const;
    /// A step without its actions: `initial step 2`, `macro step M expands E`.
    std::string head(Id<Chart::Step> step) const;
    /// `LAMP if a after 3s`, `N := N + 1 on activation`, `force G1 := {2, 3}`; in the order of the tables.
    std::vector<std::string> actions(Id<Chart::Step> step) const;
    /// `1, 2 -> 3`
    std::string way(Id<Chart::Transition> transition) const;
    /// `when a do N := 0`
    std::string guard(Id<Chart::Transition> transition) const;

private:
    std::string names(const std::vector<Id<Chart::Step>>& steps) const;

    const Chart& chart_;
    Naming naming_;
};

}  // namespace grafverif::comparing
