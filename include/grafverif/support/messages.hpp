// SPDX-License-Identifier: MIT
// The wording of every diagnostic, one function each, so that it can be reviewed in one place. Messages are lower
// case, put names in backticks, say what was seen first and, after `; `, what to do.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif::messages {

// -- the command line and files ------------------------------------------------------------------------------------
Diagnostic cannot_read(std::string_view path, std::string_view why);

// -- reading ---------------------------------------------------------------------------------------------------------

// -- derive ----------------------------------------------------------------------------------------------------------

// -- plant and compose -------------------------------------------------------------------------------------------------

// -- schedule and emit -------------------------------------------------------------------------------------------------

}  // namespace grafverif::messages
