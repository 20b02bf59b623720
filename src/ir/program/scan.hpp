// SPDX-License-Identifier: MIT
// Scan: Equations that represent one scan of a Program. The value of every memory cell after the scan is a term over
// the inputs of the scan and the values of the cells before the scan.
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/ir/equations.hpp"
#include "ir/program/program.hpp"

namespace grafverif {

struct Scan {
    /// Every input cell is an input of the equations. Every other cell, except constants and temporary variables, is an
    /// internal variable or an output. The equations have no steps, no continuous outputs (equation (13) of CEP13), no
    /// timers and no stability condition. One cycle of the equations is one scan.
    Equations equations = {};
    ProgramLayout layout = {};
    /// Variable per cell; invalid for constants and temporary variables.
    std::vector<Id<Equations::Variable>> variables = {};
    std::vector<Id<Expr>> after = {};  ///< value per cell at the end of the scan

    /// The free input that represents the time since the previous scan; invalid if this time is constant or if no term
    /// reads it.
    Id<Equations::Variable> elapsed = {};
    struct Event {
        Id<Expr> condition = {};
        Span origin = {};
        ProgramFault fault = ProgramFault::DivisionByZero;  ///< type of the fault; unused for `overflows`
    };
    /// Run-time faults, in the order of execution. If a fault occurs in a scan, the values after the scan are
    /// unspecified.
    std::vector<Event> faults = {};
    /// Conditions under which an integer operation wraps around, in the order of execution.
    std::vector<Event> overflows = {};
    /// An execution of a statement, an evaluation of a condition of IF or WHILE, or a read of an output.
    struct Execution {
        Id<Program::Statement> statement = {};  ///< the statement; invalid for a condition
        Id<Program::Node> node = {};            ///< the condition; invalid for a statement

        /// For an assignment or read: the cell that is assigned or read. For a call: the first cell of the instance.
        std::uint32_t cell = 0;
        Id<Expr> reached = {};  ///< true if the execution occurs in the scan
        Id<Expr> value = {};    ///< value of the condition, or assigned value
    };
    std::vector<Execution> executions = {};  ///< in the order of execution; empty unless requested
};

/// For each variable of the equations: true if a term of `roots` reads the variable, or reads a variable whose next
/// value depends on the former variable.
std::vector<bool> variables_read(const Scan& scan, std::vector<Id<Expr>> roots);

}  // namespace grafverif
