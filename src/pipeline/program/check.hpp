// SPDX-License-Identifier: MIT
// check_program: decides the properties of a PLC program with free inputs, for any number of scans, with the portfolio
// of engines for untimed models. Each run is replayed by the interpreter before it is reported.
#pragma once

#include <optional>
#include <string>

#include "grafverif/grafverif.hpp"
#include "ir/program/program.hpp"

namespace grafverif {

/// `program` is Structured Text; `properties` is a property file (docs/reference/programs.md). The result is empty
/// after an error.
std::optional<Report> check_program(Id<Source> program, Id<Source> properties, Sources& sources,
                                    const CheckOptions& options, Diagnostics& diagnostics);

}  // namespace grafverif
