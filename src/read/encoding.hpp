// SPDX-License-Identifier: MIT
// The encodings that XML comes in.
#pragma once

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

/// Rewrites the text of `source` as UTF-8 where its byte order mark or its XML declaration says that it is UTF-16 or
/// Latin-1 (or Windows-1252). False after an error: another encoding.
bool make_utf8(Id<Source> source, Sources& sources, Diagnostics& diagnostics);

}  // namespace grafverif
