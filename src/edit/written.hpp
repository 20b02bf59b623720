// SPDX-License-Identifier: MIT
// Checks parts of a chart that a user writes in an input field, without the `;` at the end. The functions
// `fault_of_...` return the reason why a text is not a valid part, or an empty string.
#pragma once

#include <string>
#include <string_view>

#include "syntax/language/tree.hpp"

namespace grafverif::edit {

/// Returns `text` without white space at both ends and without the `;` at its end.
std::string trimmed(std::string_view text);

std::string fault_of_condition(const std::string& text);
std::string fault_of_action(const std::string& text);
/// Checks an assignment of a transition, such as `n := 0`.
std::string fault_of_assignment(const std::string& text);

/// The declaration of one variable of a chart, such as `output n: int 0..3 = 1`.
struct Declared {
    /// Reason why the text is not such a declaration; if not empty, the other members are empty.
    std::string fault = {};
    tree::VariableKind kind = tree::VariableKind::Input;
    std::string name = {};
    bool has_index = false;
    std::string range = {};  ///< arguments of a component for the range of an integer, such as `, LOW = 0, HIGH = 3`
};
Declared declared_variable(const std::string& text);

}  // namespace grafverif::edit
