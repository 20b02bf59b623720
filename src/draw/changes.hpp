// SPDX-License-Identifier: MIT
// mark_changes: what a drawing has that another drawing of nearly the same chart has not.
#pragma once

#include "grafverif/ir/drawing.hpp"

namespace grafverif::draw {

/// Gives the class `changed` to each element of `drawing` that says what none of `other` says: a step, transition, condition or
/// action of another title or class, a link between other ends. An element that only has another number is the same.
void mark_changes(Drawing& drawing, const Drawing& other);

}  // namespace grafverif::draw
