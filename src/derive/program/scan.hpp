// SPDX-License-Identifier: MIT
// scan_of: symbolic execution of one scan of a Program -> Equations. The value of every cell after the scan is a term
// over its values before the scan and the inputs. Terms are shared, and the branches of IF and CASE are merged per
// cell, so that the size of the terms is linear in the number of executed statements. Loops are unrolled and calls
// inlined.
#pragma once

#include <optional>

#include "grafverif/support/diagnostic.hpp"
#include "ir/program/scan.hpp"

namespace grafverif {

/// Empty after an error: a loop without a constant bound, or a program that is too large.
std::optional<Scan> scan_of(const Program& program, Diagnostics& diagnostics);

/// The value of an expression over the variables of `main` at the end of the scan. Empty after an error.
std::optional<Id<Expr>> value_after(const Program& program, Id<Program::Node> node, Scan& scan,
                                    Diagnostics& diagnostics);

}  // namespace grafverif
