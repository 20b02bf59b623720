// SPDX-License-Identifier: MIT
// analyse_program: finds statements and conditions of a PLC program that have no effect or always the same effect.
//
// Except for run-time faults, each finding states that an event occurs in no scan, for all sequences of inputs.
// Symbolic execution describes each event as a term over the inputs and the values before a scan (Scan::executions).
// The engines of `check` prove for all reachable states that such a term is never true. An event that can be neither
// proved impossible nor shown possible remains open. A finding about a run-time fault states that the fault is
// possible, and has a run that the interpreter replays.
#pragma once

#include <string>

#include "grafverif/grafverif.hpp"
#include "ir/program/program.hpp"

namespace grafverif {

/// Analyses `program` with free inputs. `name` is the name of the program in the result. The result is empty after an
/// error.
std::optional<Analysis> analyse_program(const Program& program, const std::string& name, const Limits& limits,
                                        Diagnostics& diagnostics);

}  // namespace grafverif
