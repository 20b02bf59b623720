// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"

namespace grafverif {

/// Text of a property in the input language: `never a && b`. `operands`: as written; `raw`: text of a formula in
/// another language.
std::string claim(Pattern pattern, const std::vector<std::string>& operands, const std::string& raw);
/// The same for a property with an observer. `bound`: its duration or count as written, if any.
std::string claim(const Sentence& watch, const std::vector<std::string>& operands, const std::string& bound);

/// The duration or count of a sentence; empty if it has none.
std::string bound_text(const Sentence& watch);

/// Text of the proof obligation of a constraint if there is a plant: `!(IN && OUT)` holds.
std::string sentence(const ClosedLoop& loop, const ClosedLoop::Constraint& constraint);

/// The constraints of `loop` as properties, with names different from those of its properties.
std::vector<Property> constraints_to_prove(const ClosedLoop& loop);

}  // namespace grafverif
