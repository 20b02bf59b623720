// SPDX-License-Identifier: MIT
// parse: text -> tree. The grammar is grammars/grafcet.yy, the words are those of grammars/grafcet.ll.
//
// A declaration with a syntax error is marked `broken` and the parser goes on with the next one, so that one run
// reports every error. What is reported here: bytes that are no text, words that are none, syntax, and limits.
#pragma once

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

/// The declarations of `source`; those in `broken` ones are incomplete. `diagnostics` holds an error iff something was.
tree::File parse_file(Id<Source> source, const Sources& sources, Diagnostics& diagnostics);

}  // namespace grafverif
