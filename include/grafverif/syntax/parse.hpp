// SPDX-License-Identifier: MIT
// parse: text -> tree. The grammar is grammars/grafcet.yy, the words are those of grammars/grafcet.ll.
//
// A declaration with a syntax error is marked `broken` and the parser goes on with the next one, so that one run
// reports every error. What is reported here: bytes that are no text, words that are none, syntax, and limits.
#pragma once

#include <optional>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "grafverif/syntax/tree.hpp"

namespace grafverif {

/// The declarations of `source`; those in `broken` ones are incomplete. `diagnostics` holds an error iff something was.
tree::File parse_file(Id<Source> source, const Sources& sources, Diagnostics& diagnostics);

/// A condition or property alone, with the table its expressions lie in.
struct LoneCondition {
    tree::File file = {};
    Id<tree::Expr> condition = {};
};
struct LoneProperty {
    tree::File file = {};
    tree::Property property = {};
};

/// What stands in `where`, a part of its source: a condition of a transition in XML, say. Empty after an error.
std::optional<LoneCondition> parse_condition(Span where, const Sources& sources, Diagnostics& diagnostics);
/// A pattern with its operands: `never a && b`.
std::optional<LoneProperty> parse_property(Span where, const Sources& sources, Diagnostics& diagnostics);

}  // namespace grafverif
