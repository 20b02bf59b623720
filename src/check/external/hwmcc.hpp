// SPDX-License-Identifier: MIT
// Programs that take one question about a circuit: ABC, and the checkers of the hardware model checking competition. What
// they read, and what their answers mean; whoever calls runs the program and hands over what it left.
//
// Names in the file are numbers of ours (`i7`, `l12`): what a program does with a name is its own affair.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/pdr/pdr.hpp"
#include "circuit/circuit.hpp"
#include "support/program.hpp"

namespace grafverif::hwmcc {

/// How inputs and latches are numbered in the file that is written of a question.
struct Numbering {
    std::vector<std::size_t> inputs = {}, latches = {};  ///< those of the circuit, in the order of the file
};

/// The circuit with names `i0`, `i1`, ..., `l0`, `l1`, ..., and with an input, whether or not anything reads it.
Circuit with_numbers(Circuit circuit);

/// What a witness says (HWMCC 2011: `1`, the latches that it begins with, the inputs of each step, `.`): the inputs of a
/// run. Nothing: there is none, or it is of something else.
std::optional<std::vector<std::vector<bool>>> read_witness(const Circuit& circuit, const Numbering& numbering,
                                                           std::string_view text);
/// What ABC writes of a run (`write_cex -a`) as such a witness; it has no claim, and ends in `# DONE`. Empty: it ends elsewhere.
std::string witness_of_abc(std::string_view text);
/// What the first line of a witness claims: `1` that the state is reached, `0` that it is not. Nothing: neither.
std::optional<bool> claim_of(std::string_view text);

/// The invariant that ABC writes (`pdr -d -I FILE`): the states that it excludes, a row each. Nothing: it is none.
std::optional<std::vector<pdr::Cube>> read_invariant(const Circuit& circuit, std::string_view text);

/// Why a program gave no answer.
std::string failure_of(const ProgramResult& said);

}  // namespace grafverif::hwmcc
