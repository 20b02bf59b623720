// SPDX-License-Identifier: MIT
// parse: converts a text in the .grafcet language to a syntax tree. The grammar is grammars/grafcet.yy;
// grammars/grafcet.ll defines the tokens.
//
// A declaration with a syntax error is marked `broken`, and the parser resumes at the next declaration, so that one run
// reports every error. The parser reports invalid bytes, invalid tokens, syntax errors and exceeded limits.
#pragma once

#include <atomic>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

/// Returns the declarations of `source`; a declaration with a syntax error is incomplete and marked `broken`. Unless
/// `stop` becomes true, an error is added to `diagnostics` if and only if the file or a declaration is `broken`. If
/// `stop` becomes true, parsing ends at the next token, and the file is `broken`, possibly without an error.
tree::File parse_file(Id<Source> source, const Sources& sources, Diagnostics& diagnostics,
                      const std::atomic<bool>* stop = nullptr);

}  // namespace grafverif
