// SPDX-License-Identifier: MIT
// Checks that a source is text, and converts other encodings to UTF-8.
#pragma once

#include <string_view>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

inline constexpr std::size_t largest_text = std::size_t{256} << 20U;  ///< maximum size of a text in bytes

/// Converts UTF-16 to UTF-8. If the text cannot have another encoding, it is converted from Latin-1 (or Windows-1252),
/// with a warning.
void make_utf8(Id<Source> source, Sources& sources, Diagnostics& diagnostics);

/// True if `part` is valid UTF-8. Otherwise reports UTF-16, the first byte that is not UTF-8, or a size above
/// `largest_text`.
bool is_readable(Span part, const Sources& sources, Diagnostics& diagnostics);

/// Returns `part` without a leading byte order mark.
Span without_mark(Span part, const Sources& sources);

}  // namespace grafverif
