// SPDX-License-Identifier: MIT
// mark_changes: compares a drawing with the drawing of a slightly different chart.
#pragma once

#include "grafverif/ir/drawing.hpp"

namespace grafverif::draw {

/// Adds the class `changed` to each element of `drawing` without a counterpart in `other`. An element without a
/// counterpart is a step, transition, condition or action with another title or class, or a link between other ends.
/// Elements that differ only in their numbers are treated as equal.
void mark_changes(Drawing& drawing, const Drawing& other);

}  // namespace grafverif::draw
