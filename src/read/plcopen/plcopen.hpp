// SPDX-License-Identifier: MIT
// PLCopen TC6 XML 1.01, 2.0, 2.01 -> st tree. Every program and function block whose body is a Sequential Function
// Chart becomes a unit, as if it had been written in the textual form. Graphical elements (divergences, jumps,
// connections) become transitions between named steps.
//
// CODESYS dialect: conditions are expressions of connected `inVariable`s; the entry, active and exit action of a step
// are names in `addData`, in attributes identified by their GUIDs.
#pragma once

#include "read/draft.hpp"
#include "read/xml.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif {

/// Errors and unsupported constructs are reported through `draft`.
st::File read_plcopen(const Xml& xml, const Sources& sources, Draft& draft);

/// All units of a project, with bodies in Structured Text, LD (ladder diagram), FBD (function block diagram) and
/// SFC, and its configuration: the tree of the same program in Structured Text. What cannot be read is an error.
st::File read_plcopen_program(const Xml& xml, const Sources& sources, Diagnostics& diagnostics);

}  // namespace grafverif
