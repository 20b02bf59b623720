// SPDX-License-Identifier: MIT
// parse: text -> tree. The grammar is grammars/grafcet.yy, the tokens are defined in grammars/grafcet.ll.
//
// A declaration with a syntax error is marked `broken` and the parser resumes at the next one, so that one run reports
// every error. Reported are: invalid bytes, invalid tokens, syntax errors and exceeded limits.
#pragma once

#include <atomic>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

/// The declarations of `source`; `broken` ones are incomplete. `diagnostics` gets an error if and only if the file or a
/// declaration is broken.
/// Once `stop` is set, the text ends at the next token: the file is broken.
tree::File parse_file(Id<Source> source, const Sources& sources, Diagnostics& diagnostics,
                      const std::atomic<bool>* stop = nullptr);

}  // namespace grafverif
