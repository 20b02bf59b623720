// SPDX-License-Identifier: MIT
// Texts of run-time faults of PLC programs.
#pragma once

#include <string>

#include "ir/program/program.hpp"

namespace grafverif {

/// Returns a sentence about a run-time fault, without a full stop.
std::string text_of(ProgramFault fault);

}  // namespace grafverif
