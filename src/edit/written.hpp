// SPDX-License-Identifier: MIT
// Parts of a chart that a user writes in a field: their text without the `;` at the end, and the reason why a text is not
// such a part. The functions `fault_of_...` return an empty string for a valid part.
#pragma once

#include <string>
#include <string_view>

namespace grafverif::edit {

/// Returns `text` without white space at both ends and without the `;` at its end.
std::string trimmed(std::string_view text);

std::string fault_of_condition(const std::string& text);
std::string fault_of_action(const std::string& text);
/// For an assignment of a transition, `n := 0`.
std::string fault_of_assignment(const std::string& text);
/// For the declaration of one variable of a chart, `output n: int 0..3 = 1`.
std::string fault_of_declaration(const std::string& text);

}  // namespace grafverif::edit
