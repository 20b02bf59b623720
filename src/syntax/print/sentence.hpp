// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"

namespace grafverif {

/// Returns a property in the input language, such as `never a && b`. `operands` are the operands as text; `raw` is a
/// formula in another language.
std::string claim(Pattern pattern, const std::vector<std::string>& operands, const std::string& raw);
/// Returns a property with an observer. `bound` is its duration or count as text, if it has one.
std::string claim(const Sentence& watch, const std::vector<std::string>& operands, const std::string& bound);

/// Returns the duration or count of a sentence, or an empty string if it has none.
std::string bound_text(const Sentence& watch);

/// Returns the proof obligation of a constraint if there is a plant, such as `!(IN && OUT)`.
std::string sentence(const ClosedLoop& loop, const ClosedLoop::Constraint& constraint);

/// Returns the constraints of `loop` as properties, with names that differ from those of its properties.
std::vector<Property> constraints_to_prove(const ClosedLoop& loop);

}  // namespace grafverif
