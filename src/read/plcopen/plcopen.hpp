// SPDX-License-Identifier: MIT
// Reads PLCopen TC6 XML 1.01, 2.0 and 2.01 to an st tree. Every program and function block whose body is a Sequential
// Function Chart becomes a unit, as if it were written in the textual form. Graphical elements (divergences, jumps,
// connections) become transitions between named steps.
//
// In the CODESYS dialect, conditions are expressions of connected `inVariable`s. The entry, active and exit actions of
// a step are given by name in `addData`, in attributes identified by their GUIDs.
#pragma once

#include "read/draft.hpp"
#include "read/xml.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif {

/// Reads the charts. Errors and unsupported constructs are reported through `draft`.
st::File read_plcopen(const Xml& xml, const Sources& sources, Draft& draft);

/// Reads all units of a project, with bodies in Structured Text, LD (ladder diagram), FBD (function block diagram) and
/// SFC, and its configuration. The result is the tree of the same program in Structured Text. An unsupported construct
/// is an error.
st::File read_plcopen_program(const Xml& xml, const Sources& sources, Diagnostics& diagnostics);

}  // namespace grafverif
