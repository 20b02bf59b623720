// SPDX-License-Identifier: MIT
// Interface to programs that decide one query about a circuit: ABC, and the checkers of the hardware model checking
// competition. Writes their input and reads their results; the caller runs the program and passes its output.
//
// Names in the file are generated numbers (`i7`, `l12`), since programs treat names differently.
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
    std::vector<std::size_t> inputs = {}, latches = {};  ///< indices in the circuit, in the order of the file
};

/// The circuit with names `i0`, `i1`, ..., `l0`, `l1`, ..., and with at least one input, even if it is not read.
Circuit with_numbers(Circuit circuit);

/// Reads a witness (HWMCC 2011: `1`, the initial latches, the inputs of each step, `.`): the inputs of a run. Nothing
/// if there is none, or if it does not match the circuit.
std::optional<std::vector<std::vector<bool>>> read_witness(const Circuit& circuit, const Numbering& numbering,
                                                           std::string_view text);
/// Converts ABC's counterexample (`write_cex -a`) to such a witness; it has no result line, and ends in `# DONE`. Empty
/// if it ends differently.
std::string witness_of_abc(std::string_view text);
/// The result in the first line of a witness: `1`, the state is reachable, `0`, it is not. Nothing: neither.
std::optional<bool> preservation_class_of(std::string_view text);

/// Reads ABC's invariant (`pdr -d -I FILE`): the states that it excludes, one per row. Nothing if it is invalid.
std::optional<std::vector<pdr::Cube>> read_invariant(const Circuit& circuit, std::string_view text);

/// The reason why a program gave no result.
std::string failure_of(const ProgramResult& said);

}  // namespace grafverif::hwmcc
