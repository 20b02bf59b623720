// SPDX-License-Identifier: MIT
// Scan: one scan of a Program as Equations. The value of every cell after the scan is a term over its values before the
// scan and the inputs.
#pragma once

#include <vector>

#include "grafverif/ir/equations.hpp"
#include "ir/program/program.hpp"

namespace grafverif {

struct Scan {
    /// Every input is an input of the equations, every other cell an internal variable or output. There are no steps,
    /// outputs of equation (13), timers or stability: one cycle is one scan.
    Equations equations = {};
    ProgramLayout layout = {};
    std::vector<Id<Equations::Variable>> variables = {};  ///< per cell; invalid for constants and temporary variables
    std::vector<Id<Expr>> after = {};                     ///< per cell: its value at the end of the scan
    Id<Equations::Variable> elapsed = {};  ///< time since the last scan, free; invalid if it is fixed or not read
    struct Event {
        Id<Expr> condition = {};
        Span origin = {};
    };
    std::vector<Event> faults = {};     ///< divisions by zero: nothing is stated about the scan in which one occurs
    std::vector<Event> overflows = {};  ///< results that wrap around
};

}  // namespace grafverif
