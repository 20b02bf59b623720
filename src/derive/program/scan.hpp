// SPDX-License-Identifier: MIT
// scan_of: translates a Program to Equations by symbolic execution of one scan. The value of every memory cell after
// the scan is a term over the values before the scan and the inputs. Terms are shared, and after IF and CASE the values
// of each cell are merged into one conditional term. Therefore the size of the terms is linear in the number of
// executed statements. Loops are unrolled and calls are inlined.
#pragma once

#include <optional>

#include "grafverif/support/diagnostic.hpp"
#include "ir/program/scan.hpp"

namespace grafverif {

/// Translates the program. If `records` is true, the result contains the executions of the statements. The result is
/// empty after an error: the number of iterations of a loop has no constant bound, or the program is too large.
std::optional<Scan> scan_of(const Program& program, Diagnostics& diagnostics, bool records = false);

/// Returns the value of an expression over the variables of `main` at the end of the scan, or nullopt after an error.
std::optional<Id<Expr>> value_after(const Program& program, Id<Program::Node> node, Scan& scan,
                                    Diagnostics& diagnostics);

}  // namespace grafverif
