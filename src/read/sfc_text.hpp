// SPDX-License-Identifier: MIT
// The textual form of Sequential Function Charts (IEC 61131-3, 2.6): text -> tree.
#pragma once

#include "grafverif/syntax/tree.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// The charts of `source`. Broken after an error.
tree::File read_sfc_text(Id<Source> source, const Sources& sources, bool lossy, Diagnostics& diagnostics);

}  // namespace grafverif
