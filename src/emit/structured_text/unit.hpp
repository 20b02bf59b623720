// SPDX-License-Identifier: MIT
// A program organization unit of IEC 61131-3 (a program or a function block), with functions that print it as text and
// as XML.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "emit/controller/code.hpp"
#include "emit/structured_text/dialects.hpp"

namespace grafverif::structured_text {

using controller::Section;

struct UnitVariable {
    Section section = Section::Local;
    std::string name = {};
    std::string type = {};     ///< type: `BOOL`, `DINT`, `INT`, `UDINT`, `TON`, `TOF`, or the name of a block
    bool derived = false;      ///< true if the type is a function block
    std::string initial = {};  ///< initial value as a literal; may be empty
    std::string comment = {};
};

struct Unit {
    bool is_program = false;  ///< true for a program, false for a function block
    std::string name = {};
    std::string comment = {};  ///< comment of the unit; may have several lines
    std::vector<UnitVariable> variables = {};
    std::string body = {};
};

/// Returns `text` for use inside a comment: a blank is inserted between the characters of `(*` and `*)`.
std::string comment_text(std::string text);

/// Prints the unit in the file format of the dialect. For dialects with the standard format, `form` selects text or
/// XML.
void print(const Unit& unit, Form form, const DialectRow& dialect, std::ostream& out);

}  // namespace grafverif::structured_text
