// SPDX-License-Identifier: MIT
// Prints properties in the input language.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"

namespace grafverif {

/// Returns the text of a property in the input language, such as `never a && b`. `operands` contains the operands as
/// text; `raw` is a formula in another language.
std::string claim(Pattern pattern, const std::vector<std::string>& operands, const std::string& raw);
/// Returns the text of a property with an observer. `bound` is the duration or count of the property as text; empty if
/// the property has neither.
std::string claim(const Sentence& watch, const std::vector<std::string>& operands, const std::string& bound);

/// Returns the duration or count of a property with an observer as text, or an empty string if the property has
/// neither.
std::string bound_text(const Sentence& watch);

/// Returns the text of the property that states a constraint for a plant, such as `!(IN && OUT) holds for this plant`.
std::string sentence(const ClosedLoop& loop, const ClosedLoop::Constraint& constraint);

/// Returns the constraints of `loop` as properties with names that differ from the names of all
/// properties of `loop`.
std::vector<Property> constraints_to_prove(const ClosedLoop& loop);

}  // namespace grafverif
