// SPDX-License-Identifier: MIT
// check_program: decides the properties of a PLC program with free inputs, by the portfolio of engines for untimed
// models, without a bound on the number of scans. Each run is replayed on the interpreter before it is reported.
#pragma once

#include <optional>

#include "grafverif/grafverif.hpp"

namespace grafverif {

/// `program`: Structured Text; `properties`: a property file (docs/reference/programs.md). Empty after an error.
std::optional<Report> check_program(Id<Source> program, Id<Source> properties, Sources& sources,
                                    const CheckOptions& options, Diagnostics& diagnostics);

}  // namespace grafverif
