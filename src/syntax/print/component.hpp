// SPDX-License-Identifier: MIT
// The terms of a component as the file would write them.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/component.hpp"

namespace grafverif {

std::string term_text(const Component& component, Id<Expr> term);
/// `t <= STEP && u < 3s`; empty: there are none.
std::string clocks_text(const Component& component, const std::vector<Component::ClockConstraint>& constraints);
/// What must hold for the edge, clocks included; empty: nothing.
std::string guard_text(const Component& component, const Component::Edge& edge);
/// `X := X + 1, t := 0`; empty: the edge changes nothing.
std::string effect_text(const Component& component, const Component::Edge& edge);

}  // namespace grafverif
