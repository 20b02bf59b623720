// SPDX-License-Identifier: MIT
// A program organization unit of IEC 61131-3 (a program or a function block), with functions that print it as text and
// as XML.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "emit/structured_text/structured_text.hpp"

namespace grafverif::structured_text {

enum class Section { Input, Output, Local, Constant };

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
    std::string comment = {};  ///< may have several lines
    std::vector<UnitVariable> variables = {};
    std::string body = {};
};

/// Returns `text` for use inside a comment: a blank is inserted between the characters of `(*` and `*)`.
std::string comment_text(std::string text);

void print(const Unit& unit, Form form, std::ostream& out);

}  // namespace grafverif::structured_text
