// SPDX-License-Identifier: MIT
// analyse_program: finds statements and conditions of a PLC program that have no effect or always the same effect.
//
// Each finding states that an event occurs in no scan, for all sequences of inputs. The events are terms over the
// values before a scan and the inputs, which symbolic execution determines (Scan::executions). The engines of `check`
// prove for all reachable states that such a term is never true. An event that can be neither proved impossible nor
// shown possible remains open. A finding about a run-time fault has a run that the interpreter replays.
#pragma once

#include <string>

#include "grafverif/grafverif.hpp"
#include "ir/program/program.hpp"

namespace grafverif {

/// Analyses `program` with free inputs. `name` is the name in the analysis. Empty after an error.
std::optional<Analysis> analyse_program(const Program& program, const std::string& name, const Limits& limits,
                                        Diagnostics& diagnostics);

}  // namespace grafverif
