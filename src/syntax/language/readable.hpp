// SPDX-License-Identifier: MIT
// Whether bytes are text at all.
#pragma once

#include <string_view>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

inline constexpr std::size_t largest_text = std::size_t{256} << 20U;  ///< bytes

/// Rewrites a text in UTF-16 as UTF-8, and one that can only be Latin-1 (or Windows-1252), which is warned of.
void make_utf8(Id<Source> source, Sources& sources, Diagnostics& diagnostics);

/// Reports text in UTF-16, the first byte of `part` that is not UTF-8, and parts above `largest_text`.
bool is_readable(Span part, const Sources& sources, Diagnostics& diagnostics);

/// `part` without a byte order mark at its beginning.
Span without_mark(Span part, const Sources& sources);

}  // namespace grafverif
