// SPDX-License-Identifier: MIT
// The files of one input: the first and all it includes, parsed, included ones first.
#pragma once

#include <vector>

#include "grafverif/read/text.hpp"
#include "grafverif/syntax/tree.hpp"

namespace grafverif {

/// Each file once; cycles and files that cannot be had (then `missing`) are reported at the line that asks for them.
std::vector<tree::File> parse_with_includes(Id<Source> file, Sources& sources, const ReadContext& context,
                                            bool& missing, Diagnostics& diagnostics);

}  // namespace grafverif
