// SPDX-License-Identifier: MIT
// Interface to programs that decide one query about a circuit: ABC and the model checkers of the hardware model
// checking competition. Writes their input and reads their results; the caller runs the program and passes its output.
//
// Names in the file are generated from numbers (`i7`, `l12`), because programs treat other names differently.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/pdr/pdr.hpp"
#include "circuit/circuit.hpp"
#include "support/program.hpp"

namespace grafverif::hwmcc {

/// Numbers of inputs and latches in the written file.
struct Numbering {
    /// Indices of inputs and latches in the circuit, in the order of the file.
    std::vector<std::size_t> inputs = {}, latches = {};
};

/// Returns the circuit with names `i0`, `i1`, ..., `l0`, `l1`, ..., and with at least one input, even if no gate reads
/// it.
Circuit with_numbers(Circuit circuit);

/// Reads a witness (HWMCC 2011: `1`, the initial latches, the inputs of each step, `.`) and returns the inputs of the
/// run. The result is empty if there is no witness or it does not match the circuit.
std::optional<std::vector<std::vector<bool>>> read_witness(const Circuit& circuit, const Numbering& numbering,
                                                           std::string_view text);
/// Converts ABC's counterexample (`write_cex -a`) to such a witness. The counterexample has no result line and ends in
/// `# DONE`. The result is empty if it ends differently.
std::string witness_of_abc(std::string_view text);
/// Returns the result in the first line of a witness: true for `1` (the state is reachable), false for `0` (it is
/// unreachable), otherwise empty.
std::optional<bool> preservation_class_of(std::string_view text);

/// Reads ABC's invariant (`pdr -d -I FILE`): the states that it excludes, one cube per row. The result is empty if the
/// invariant is invalid.
std::optional<std::vector<pdr::Cube>> read_invariant(const Circuit& circuit, std::string_view text);

/// Returns the reason why a program gave no result.
std::string failure_of(const ProgramResult& said);

}  // namespace grafverif::hwmcc
