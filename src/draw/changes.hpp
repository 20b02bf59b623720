// SPDX-License-Identifier: MIT
// mark_changes: compares a drawing with the drawing of a slightly different chart.
#pragma once

#include "grafverif/ir/drawing.hpp"

namespace grafverif::draw {

/// Adds the class `changed` to each element of `drawing` without a counterpart in `other`. A step, transition,
/// condition or action has a counterpart if `other` contains an element with the same title and class. A link has a
/// counterpart if `other` contains a link between the same ends. The ids of counterparts may differ, because an id
/// contains the number of its element.
void mark_changes(Drawing& drawing, const Drawing& other);

}  // namespace grafverif::draw
