// SPDX-License-Identifier: MIT
// check_program: decides the properties of a PLC program with free inputs, for any number of scans, with the portfolio
// of engines for untimed models. Each run is replayed by the interpreter before it is reported.
#pragma once

#include <optional>
#include <string>

#include "grafverif/grafverif.hpp"
#include "grafverif/ir/why.hpp"
#include "ir/program/program.hpp"

namespace grafverif {

/// A model whose only chart represents a PLC program (see interface_of), the verdicts on the program and, if requested,
/// the statements and transitions on which the proofs depend.
struct CheckedProgram {
    Model model = {};
    Report report = {};
    std::optional<ProofExplanation> why = {};
};

/// Reads a program and a property file. Returns the model of the program, or nullopt after an error.
std::optional<Model> read_program_model(Id<Source> program, Id<Source> properties, Sources& sources,
                                        Diagnostics& diagnostics);

/// Checks a PLC program. `program` is Structured Text or PLCopen XML; `properties` is a property file
/// (docs/reference/programs.md). The result is empty after an error. If `explains` is true, the check of the properties
/// that hold is repeated for each statement and for each transition of a Sequential Function Chart, without this
/// element.
std::optional<CheckedProgram> check_program(Id<Source> program, Id<Source> properties, Sources& sources,
                                            const CheckOptions& options, Diagnostics& diagnostics,
                                            bool explains = false);

}  // namespace grafverif
