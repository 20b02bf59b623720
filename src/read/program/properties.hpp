// SPDX-License-Identifier: MIT
// read_properties: reads a property file (YAML) of the public IEC 61131-3 verification suite, format version 0.1.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "read/program/program.hpp"

namespace grafverif {

/// A property of a PLC program: a requirement on the values at the end of each scan. The inputs are unconstrained.
struct ProgramProperty {
    enum class Kind { Invariant, MutualExclusion, Absence, Reachability, Reachable, Assertion, Termination };
    enum class Error { Overflow, DivisionByZero, ArrayBounds };  ///< for Absence: the error that must not occur
    std::string name = {};
    std::string text = {};
    Kind kind = Kind::Invariant;
    Error error = Error::Overflow;
    /// MutualExclusion has at least two conditions; every other kind has at most one condition.
    std::vector<Id<Program::Node>> conditions = {};
    Span origin = {};

    bool is_about_fault() const { return kind == Kind::Absence && error != Error::Overflow; }
    ProgramFault fault() const {
        return error == Error::ArrayBounds ? ProgramFault::ArrayBounds : ProgramFault::DivisionByZero;
    }
};

/// Reads the properties of a property file. The result is empty after at least one error. Adds the nodes of the
/// expressions to `program`.
std::optional<std::vector<ProgramProperty>> read_properties(Id<Source> source, Sources& sources, ProgramText& program,
                                                            Diagnostics& diagnostics);

}  // namespace grafverif
