// SPDX-License-Identifier: MIT
// read_properties: a property file (YAML) of the public IEC 61131-3 verification suite, format version 0.1.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "read/program/program.hpp"

namespace grafverif {

/// A property of the values at the end of every scan, with free inputs.
struct ProgramProperty {
    enum class Kind { Invariant, MutualExclusion, Absence, Reachability, Reachable, Assertion, Termination };
    enum class Error { Overflow, DivisionByZero, ArrayBounds };  ///< of Absence
    std::string name = {};
    std::string text = {};
    Kind kind = Kind::Invariant;
    Error error = Error::Overflow;
    std::vector<Id<Program::Node>> conditions = {};  ///< of MutualExclusion: at least two; of the others: at most one
    Span origin = {};
};

/// Empty after at least one error. The expressions are added to the nodes of `program`.
std::optional<std::vector<ProgramProperty>> read_properties(Id<Source> source, Sources& sources, ProgramText& program,
                                                            Diagnostics& diagnostics);

}  // namespace grafverif
