// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"

namespace grafverif {

/// What a property claims, as the language writes it: `never a && b`. `operands`: as written; `raw`: of a formula in
/// another language.
std::string claim(Pattern pattern, const std::vector<std::string>& operands, const std::string& raw);
/// The same of a sentence that an observer judges. `bound`: its duration or count as written, where it has one.
std::string claim(const Sentence& watch, const std::vector<std::string>& operands, const std::string& bound);

/// The duration or the count of a sentence; empty: it has none.
std::string bound_text(const Sentence& watch);

/// What is to prove of a constraint beside a plant, in words: `!(IN && OUT)` holds of it.
std::string sentence(const ClosedLoop& loop, const ClosedLoop::Constraint& constraint);

/// The constraints of `loop` as properties of it, under names that no property has.
std::vector<Property> constraints_to_prove(const ClosedLoop& loop);

}  // namespace grafverif
