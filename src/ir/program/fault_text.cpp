// SPDX-License-Identifier: MIT
#include "ir/program/fault_text.hpp"

namespace grafverif {

std::string text_of(ProgramFault fault) {
    switch (fault) {
    case ProgramFault::DivisionByZero: return "the program divides by zero";
    case ProgramFault::ArrayBounds: return "the program uses an index outside of its array";
    case ProgramFault::Chart: return "a chart activates an active step, or an action has two durations";
    case ProgramFault::Range: break;
    }
    return "the program computes a value outside of the range of its type";
}

}  // namespace grafverif
