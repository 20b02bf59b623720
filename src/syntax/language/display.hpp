// SPDX-License-Identifier: MIT
// Warns about text whose display in editors and terminals is misleading: control characters, and different names in one
// file that look the same (equal skeletons of UTS 39, Unicode Security Mechanisms).
#pragma once

#include <span>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

/// Warns about control characters in `part`, such as bidirectional controls, and about unusual line separators, such as
/// a carriage return without a line feed.
void check_controls(Span part, const Sources& sources, Diagnostics& diagnostics);

/// Warns about each name with non-ASCII characters that looks like a keyword, a step variable or another name of
/// `file`, or has fullwidth letters or digits. `first_places` contains the first occurrence of each word of
/// `file.words`.
void check_confusables(const tree::File& file, std::span<const Span> first_places, Diagnostics& diagnostics);

}  // namespace grafverif
