// SPDX-License-Identifier: MIT
// scan_of: symbolic execution of one scan of a Program -> Equations. The value of every cell after the scan is a term
// over its values before the scan and the inputs. Terms are shared, and the branches of IF and CASE are merged per cell,
// so that the size of the terms is linear in the number of executed statements. Loops are unrolled and calls inlined.
#pragma once

#include <optional>
#include <vector>

#include "grafverif/ir/equations.hpp"
#include "grafverif/support/diagnostic.hpp"
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

/// Empty after an error: a loop without a constant bound, or a program that is too large.
std::optional<Scan> scan_of(const Program& program, Diagnostics& diagnostics);

/// The value of an expression over the variables of `main` at the end of the scan. Empty after an error.
std::optional<Id<Expr>> value_after(const Program& program, Id<Program::Node> node, Scan& scan,
                                    Diagnostics& diagnostics);

}  // namespace grafverif
