// SPDX-License-Identifier: MIT
// Random PLC programs as Structured Text: every statement, operator, standard function and standard block that programs
// accept, nested function blocks called several times, functions, loops with EXIT and RETURN, wrap-around, faults.
#pragma once

#include <string>

#include "support/random_chart.hpp"

namespace grafverif {

std::string random_program(Random& random);

}  // namespace grafverif
