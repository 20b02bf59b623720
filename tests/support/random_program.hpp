// SPDX-License-Identifier: MIT
// Generates random PLC programs as Structured Text. The programs contain every statement, operator,
// standard function and standard block that programs accept. The programs also have nested function
// blocks called several times, functions, loops with EXIT and RETURN, arithmetic that wraps around,
// and faults.
#pragma once

#include <string>

#include "support/random_chart.hpp"

namespace grafverif {

std::string random_program(Random& random);

}  // namespace grafverif
