// SPDX-License-Identifier: MIT
// Defines the beginning of the note that lists the transitions that are never cleared after the end of a trace.
#pragma once

namespace grafverif {

inline constexpr const char* dead_text = "after this trace, these transitions are never cleared again: ";

}  // namespace grafverif
