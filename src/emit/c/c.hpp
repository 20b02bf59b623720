// SPDX-License-Identifier: MIT
// Writes Equations as a controller in C99: a header and a source file that depend only on <stdbool.h> and <stdint.h>.
// The two files contain the same statements as the function block in Structured Text (emit/controller).
//
//   `NAME_inputs`: The struct of the inputs.
//   `NAME_state`:  The struct of the outputs, the internal variables and the timers.
//   `NAME_init`:   Sets the state at power-on.
//   `NAME_scan`:   Executes one PLC cycle: reads the inputs, and changes the state. Its argument `elapsed_ms` is the
//                  time since the previous call.
//
// Integers have fixed widths. The code allocates no memory, and has no recursion and no global variables. Its only loop
// is the stability search, which executes at most NAME_MAX_EVOLUTIONS evolutions.
#pragma once

#include <string>
#include <string_view>

#include "emit/controller/code.hpp"

namespace grafverif::c {

/// Returns the content of the header.
std::string header_of(const controller::Code& code);

/// Returns the content of the source file. `header` is the name of the header, or empty if the source follows the text
/// of the header in the same file.
std::string source_of(const controller::Code& code, std::string_view header);

}  // namespace grafverif::c
