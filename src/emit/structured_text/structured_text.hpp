// SPDX-License-Identifier: MIT
// Equations -> a controller in Structured Text (IEC 61131-3): a function block that executes one PLC cycle per call, with
// the inputs and outputs of the chart as its own. What was proven of the equations is what runs.
//
// What becomes what:
//   input, output          VAR_INPUT, VAR_OUTPUT of the same name; outputs are written at the end of the cycle
//   X_s, CF_t, internals   local variables; integers are DINT
//   time condition         TON, followed by TOF where it has a fall time; called before the first evolution of the cycle,
//                          which samples the time, and after each, so that a step left and activated anew within one
//                          cycle starts its timer anew
//   stability search       WHILE the situation is not stable, bounded by MAX_EVOLUTIONS
//   what has no meaning    output FAULT: 1 no stable situation within the bound (total instability), 2 a race of stored
//                          actions, 3 a value outside its range, 4 forcing orders that cannot be obeyed together. From then
//                          on the block keeps its outputs and does nothing.
// New values are computed from old ones: where an assignment would change what a later one reads, the new value waits in a
// variable of its own (N_...). Names are legalised once (syntax/legal_names); what had to change stands in the header.
//
// TestSequence -> a program that drives an instance of such a block, or of any other with the same inputs and outputs,
// through the test, one scan per call, and compares its outputs in each.
#pragma once

#include <cstdint>
#include <iosfwd>

#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/test_sequence.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif::structured_text {

enum class Form { Text, PlcopenXml };  ///< a textual unit, or a project of PLCopen TC6 XML 2.01

struct Options {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::uint32_t max_evolutions = 1000;  ///< of one cycle, under stability search
    Form form = Form::PlcopenXml;
};

/// Whether the block can compute what `equations` says: adds an error for each division by what is no constant (`and` and
/// `or` need not stop at the first operand that decides them), value beyond 32 bits, and duration beyond those of TIME.
bool expressible(const Equations& equations, Diagnostics& diagnostics);

/// Requires verify(equations).empty() and that they are expressible.
void emit(const Equations& equations, const Options& options, std::ostream& out);

/// Requires verify(test).empty().
void emit_test(const TestSequence& test, Form form, std::ostream& out);

}  // namespace grafverif::structured_text
