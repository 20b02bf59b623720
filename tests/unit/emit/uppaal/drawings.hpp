// SPDX-License-Identifier: MIT
// Checks that elements of the drawing of a UPPAAL project do not overlap. A character is 8 pixels wide, a line 16 high,
// a location a circle of radius 12.
#pragma once

#include <string>

namespace grafverif::test {

/// Returns one line for each overlap of two locations, names or labels of one template, and an empty string for a
/// project without overlaps.
std::string overlaps(const std::string& xml);

}  // namespace grafverif::test
