// SPDX-License-Identifier: MIT
// Beginning of the note that lists the transitions that are never cleared again after the end of a trace.
#pragma once

namespace grafverif {

inline constexpr const char* dead_text = "after this trace, these transitions are never cleared again: ";

}  // namespace grafverif
