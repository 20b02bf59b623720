// SPDX-License-Identifier: MIT
// Beginning of the note that lists the transitions that are dead after the point of no return.
#pragma once

namespace grafverif {

inline constexpr const char* lost_text = "from the end of this run on these transitions are never cleared again: ";

}  // namespace grafverif
