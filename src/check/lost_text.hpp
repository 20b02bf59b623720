// SPDX-License-Identifier: MIT
// How the note begins that names what is lost behind the point of no return.
#pragma once

namespace grafverif {

inline constexpr const char* lost_text = "from the end of this run on these transitions are never cleared again: ";

}  // namespace grafverif
