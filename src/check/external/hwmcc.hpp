// SPDX-License-Identifier: MIT
// Interface to programs that decide one query about a circuit: ABC and the model checkers of the hardware model
// checking competition. The functions write the input of a program and read its output; the caller runs the program.
//
// Names of inputs and latches in the written file consist of a letter and a number (`i7`, `l12`), because programs
// interpret other names differently.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/pdr/pdr.hpp"
#include "circuit/circuit.hpp"
#include "support/program.hpp"

namespace grafverif::hwmcc {

/// Relates the inputs and latches of the written file to the inputs and latches of the circuit.
struct Numbering {
    /// Indices of inputs and latches in the circuit, in the order of the file.
    std::vector<std::size_t> inputs = {}, latches = {};
};

/// Renames the inputs of the circuit to `i0`, `i1`, ... and the latches to `l0`, `l1`, .... If the circuit has no
/// input, the result has one additional input that no gate reads.
Circuit with_numbers(Circuit circuit);

/// Reads a witness and returns the inputs in each step of the run. The lines of a witness (format of HWMCC 2011) are
/// `1`, the initial values of the latches, the inputs of each step, and `.`. The result is empty if there is no
/// witness, or if the witness does not match the circuit.
std::optional<std::vector<std::vector<bool>>> read_witness(const Circuit& circuit, const Numbering& numbering,
                                                           std::string_view text);
/// Converts ABC's counterexample (`write_cex -a`) to a witness for read_witness. The counterexample of ABC has no
/// result line; the function adds the result line `1`. If the text does not contain the line `# DONE`, which marks the
/// end of a complete counterexample, the result is empty.
std::string witness_of_abc(std::string_view text);
/// Returns the result that the first result line of a text states: true for `1` or `sat` (the bad state is reachable),
/// false for `0` or `unsat` (the bad state is unreachable), and nullopt without a result line.
std::optional<bool> witness_result(std::string_view text);

/// Reads an invariant of ABC (`pdr -d -I FILE`). Returns the states that the invariant excludes: one cube (conjunction
/// of latch values) for each row of the text. The result is empty if the invariant is invalid.
std::optional<std::vector<pdr::Cube>> read_invariant(const Circuit& circuit, std::string_view text);

/// Returns the reason why a program gave no result.
std::string failure_of(const ProgramResult& program_result);

}  // namespace grafverif::hwmcc
