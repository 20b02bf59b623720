// SPDX-License-Identifier: MIT
// Writes Equations as a controller in Structured Text (IEC 61131-3): a function block with the inputs and outputs of
// the chart, which executes one PLC cycle per call. The block implements the same equations that are verified.
//
// Mapping:
//   input, output: VAR_INPUT, VAR_OUTPUT of the same name. Outputs are written at the end of the cycle.
//   X_s, CF_t, internal variables: Local variables; integers are DINT.
//   time condition: TON, followed by TOF if the time condition has a fall time. The timers are called before the first
//     evolution of the cycle, in order to sample the time, and after each evolution. Therefore a step that is
//     deactivated and activated again within one cycle restarts its timer.
//   stability search: WHILE the situation is not stable, bounded by MAX_EVOLUTIONS.
//   fault: The value of the output FAULT: 1 for no stable situation within the bound (total instability), 2 for a race
//     of stored actions, 3 for a value outside its range, 4 for contradictory forcing orders. After a fault the block
//     keeps its outputs and has no further effect.
//
// New values are computed from old values. If an assignment would change an operand of a later assignment, the new
// value is stored in a temporary variable (N_...). Names are converted to legal names once (syntax/print/legal_names);
// changed names are listed in the header.
//
// A second function writes a TestSequence as a program. The program runs the test on an instance of the block of the
// chart, or of any other block with the same inputs and outputs. Each call performs one scan and compares the outputs.
#pragma once

#include <cstdint>
#include <iosfwd>

#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/test_sequence.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif::structured_text {

enum class Form { Text, PlcopenXml };  ///< text of a program organization unit, or a project in PLCopen TC6 XML 2.01

/// Structured Text of the standard and of vendors (see dialects.hpp). Twincat and Siemens have their own file formats
/// and ignore Form.
enum class Dialect { Iec, Codesys, Twincat, Siemens };

struct Options {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::uint32_t max_evolutions = 1000;  ///< maximum number of evolutions in one cycle under stability search
    Form form = Form::PlcopenXml;
    Dialect dialect = Dialect::Iec;
};

/// True if a function block can compute `equations` exactly. Otherwise, reports each division by a divisor that is not
/// constant, each value beyond 32 bits, and each duration beyond the range of TIME. A division is reported even if a
/// previous operand excludes a zero divisor, because `and` and `or` in Structured Text may evaluate all operands.
bool expressible(const Equations& equations, Diagnostics& diagnostics);

/// Writes the function block. Requires verify(equations).empty() and that the equations are expressible.
void emit(const Equations& equations, const Options& options, std::ostream& out);

/// Writes the test program. Requires verify(test).empty().
void emit_test(const TestSequence& test, Form form, std::ostream& out);

}  // namespace grafverif::structured_text
