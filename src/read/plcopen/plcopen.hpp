// SPDX-License-Identifier: MIT
// Reads PLCopen TC6 XML 1.01, 2.0 and 2.01 to the syntax tree of st_tree.hpp. Every program and function block whose
// body is a Sequential Function Chart becomes a unit with the same tree as its textual form. Graphical elements
// (divergences, jumps, connections) become transitions between named steps.
//
// In the CODESYS dialect, a condition is the expression of a connected `inVariable`. The element `addData` of a step
// contains the names of its entry, active and exit actions, in attributes that are identified by GUIDs.
#pragma once

#include "read/draft.hpp"
#include "read/xml.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif {

/// Reads the charts of a file. Reports errors and unsupported constructs through `draft`.
st::File read_plcopen(const Xml& xml, const Sources& sources, Draft& draft);

/// Reads all units of a project, with bodies in Structured Text, LD (ladder diagram), FBD (function block diagram) and
/// SFC, and its configuration. The result is the tree of the same program in Structured Text. An unsupported construct
/// is an error.
st::File read_plcopen_program(const Xml& xml, const Sources& sources, Diagnostics& diagnostics);

}  // namespace grafverif
