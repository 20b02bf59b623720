// SPDX-License-Identifier: MIT
// PLCopen TC6 XML 1.01, 2.0, 2.01 -> st tree: every program and function block whose body is a Sequential Function Chart
// becomes a unit as if it had been written in the textual form. What is drawn (divergences, jumps, connections) becomes
// transitions between named steps.
//
// The dialect of CODESYS: conditions are expressions of connected `inVariable`s; the entry, active and exit action of a
// step stand as names in `addData`, under attributes that are known by their GUIDs.
#pragma once

#include "read/draft.hpp"
#include "read/xml.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif {

/// Faults and what cannot be taken over are said through `draft`.
st::File read_plcopen(const Xml& xml, const Sources& sources, Draft& draft);

}  // namespace grafverif
