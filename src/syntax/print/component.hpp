// SPDX-License-Identifier: MIT
// Prints the terms of a component in the notation of the input language.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/component.hpp"

namespace grafverif {

std::string term_text(const Component& component, Id<Expr> term);
/// Returns clock constraints as text such as `t <= STEP && u < 3s`, or an empty string if there are no constraints.
std::string clocks_text(const Component& component, const std::vector<Component::ClockConstraint>& constraints);
/// Returns the guard of the edge as text, including clock constraints, or an empty string if the guard is always true.
std::string guard_text(const Component& component, const Component::Edge& edge);
/// Returns the effects of the edge as text such as `X := X + 1, t := 0`, or an empty string if the edge has neither
/// assignments nor resets.
std::string effect_text(const Component& component, const Component::Edge& edge);

}  // namespace grafverif
