// SPDX-License-Identifier: MIT
// Scan: one scan of a Program as Equations. The value of every cell after the scan is a term over the values of cells
// before the scan and the inputs.
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/ir/equations.hpp"
#include "ir/program/program.hpp"

namespace grafverif {

struct Scan {
    /// Every input cell is an input of the equations. Every other cell, except constants and temporary variables, is an
    /// internal variable or an output. The equations have no steps, no continuous outputs (equation (13) of
    /// CEP13), no timers and no stability condition: one cycle is one scan.
    Equations equations = {};
    ProgramLayout layout = {};
    /// Variable per cell; invalid for constants and temporary variables.
    std::vector<Id<Equations::Variable>> variables = {};
    std::vector<Id<Expr>> after = {};  ///< value per cell at the end of the scan
    /// The free input for the time since the previous scan; invalid if the time is constant or not read.
    Id<Equations::Variable> elapsed = {};
    struct Event {
        Id<Expr> condition = {};
        Span origin = {};
        ProgramFault fault = ProgramFault::DivisionByZero;  ///< only for `faults`
    };
    /// Run-time faults, in the order of execution. If a fault occurs in a scan, the values after the scan are
    /// unspecified.
    std::vector<Event> faults = {};
    std::vector<Event> overflows = {};  ///< results that wrap around
    /// An execution of a statement, or an evaluation of a condition of IF or WHILE.
    struct Execution {
        Id<Program::Statement> statement = {};  ///< invalid for a condition
        Id<Program::Node> node = {};            ///< the condition; invalid for a statement
        std::uint32_t cell = 0;                 ///< for an assignment or call: the assigned cell, or the first cell
        Id<Expr> reached = {};                  ///< true if the execution occurs in the scan
        Id<Expr> value = {};                    ///< value of the condition, or assigned value
    };
    /// In the order of execution; empty unless requested.
    std::vector<Execution> executions = {};
};

/// For each variable of the equations: true if `roots` depend on it, directly or through next values.
std::vector<bool> variables_read(const Scan& scan, std::vector<Id<Expr>> roots);

}  // namespace grafverif
