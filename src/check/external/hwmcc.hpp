// SPDX-License-Identifier: MIT
// Interface to programs that decide one query about a circuit: ABC and the model checkers of the hardware model
// checking competition. The functions write the input of a program and read its output; the caller runs the program.
//
// Names in the file are generated from numbers (`i7`, `l12`), because programs interpret other names differently.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/pdr/pdr.hpp"
#include "circuit/circuit.hpp"
#include "support/program.hpp"

namespace grafverif::hwmcc {

/// Relates the inputs and latches of the written file to those of the circuit.
struct Numbering {
    /// Indices of inputs and latches in the circuit, in the order of the file.
    std::vector<std::size_t> inputs = {}, latches = {};
};

/// Returns the circuit with the names `i0`, `i1`, ..., `l0`, `l1`, .... If the circuit has no input, an input that no
/// gate reads is added.
Circuit with_numbers(Circuit circuit);

/// Reads a witness (HWMCC 2011: `1`, the initial latches, the inputs of each step, `.`) and returns the inputs of the
/// run. The result is empty if there is no witness, or if the witness does not match the circuit.
std::optional<std::vector<std::vector<bool>>> read_witness(const Circuit& circuit, const Numbering& numbering,
                                                           std::string_view text);
/// Converts ABC's counterexample (`write_cex -a`) to a witness for read_witness. The counterexample has no result line.
/// If the text does not contain `# DONE`, which marks its end, the result is empty.
std::string witness_of_abc(std::string_view text);
/// Returns the first result line of a text: true for `1` or `sat` (the state is reachable), false for `0` or `unsat`
/// (it is unreachable), otherwise empty.
std::optional<bool> witness_result(std::string_view text);

/// Reads an invariant of ABC (`pdr -d -I FILE`). Returns the states that the invariant excludes, one cube per row. The
/// result is empty if the invariant is invalid.
std::optional<std::vector<pdr::Cube>> read_invariant(const Circuit& circuit, std::string_view text);

/// Returns the reason why a program gave no result.
std::string failure_of(const ProgramResult& program_result);

}  // namespace grafverif::hwmcc
