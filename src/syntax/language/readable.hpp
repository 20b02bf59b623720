// SPDX-License-Identifier: MIT
// Checks that a source is text, and converts other encodings to UTF-8.
#pragma once

#include <string_view>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

inline constexpr std::size_t largest_text = std::size_t{256} << 20U;  ///< maximum size of a text in bytes

/// Converts a text in UTF-16 to UTF-8. A text that is not UTF-8 and may be Latin-1 (see is_latin) is converted from
/// Windows-1252, with a warning.
void make_utf8(Id<Source> source, Sources& sources, Diagnostics& diagnostics);

/// True if `part` is valid UTF-8 and not larger than `largest_text`. Otherwise, reports the reason: `part` is UTF-16,
/// contains a byte that is not UTF-8, or is larger than `largest_text`.
bool is_readable(Span part, const Sources& sources, Diagnostics& diagnostics);

/// Returns `part` without a leading byte order mark.
Span without_mark(Span part, const Sources& sources);

}  // namespace grafverif
