// SPDX-License-Identifier: MIT
// Prints the expressions and variables of a Program in the notation of Structured Text.
#pragma once

#include <string>

#include "ir/program/program.hpp"

namespace grafverif {

/// Returns the name of a variable of `unit`, such as `Level`, `Delay.Q` or `A[I + 1]`, or a global
/// name. If a variable belongs to a Sequential Function Chart and statements cannot access the
/// variable, its name contains a space.
std::string place_text(const Program& program, Id<Program::Unit> unit, const Program::Place& place);

/// Returns the name of the instance of `block` at `place`, relative to `unit`.
std::string instance_text(const Program& program, Id<Program::Unit> unit, const Program::Place& place,
                          Id<Program::Unit> block);

/// Returns the text of an expression in `unit`.
std::string term_text(const Program& program, Id<Program::Unit> unit, Id<Program::Node> term);

/// Returns the text of a statement in `unit`, without a semicolon: an assignment, a call without its arguments, EXIT or
/// RETURN.
std::string statement_text(const Program& program, Id<Program::Unit> unit, const Program::Statement& statement);

}  // namespace grafverif
