// SPDX-License-Identifier: MIT
// parse_st: converts Structured Text and textual Sequential Function Charts to the syntax tree of st_tree.hpp. The
// grammar is grammars/st.yy; grammars/st.ll defines the tokens. All functions add their results to an st::File, so that
// all texts of one XML document use the same table of names.
#pragma once

#include <optional>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif::st {

/// A part of a source. If `escaped` is true, the text is XML with character references such as `&lt;`.
struct Piece {
    Span where = {};
    bool escaped = false;
};
/// A text that consists of several parts of sources, for example the paragraphs of an XML element.
using Text = std::vector<Piece>;

/// Parses an expression. The result is empty after at least one error.
std::optional<Id<Expr>> parse_expression(const Text& text, File& file, const Sources& sources,
                                         Diagnostics& diagnostics);
std::optional<Block> parse_statements(const Text& text, File& file, const Sources& sources, Diagnostics& diagnostics);
/// Parses the programs, function blocks, functions and global variables of a text file. Returns false after an error.
bool parse_units(const Text& text, File& file, const Sources& sources, Diagnostics& diagnostics);
/// Same as `parse_units`, but also parses types and configurations. This function reads the
/// programs that grafverif executes. Returns false after an error.
bool parse_programs(const Text& text, File& file, const Sources& sources, Diagnostics& diagnostics);
/// Parses an expression of a property, which may also contain the operators `! && || == !=`. The result is empty after
/// at least one error.
std::optional<Id<Expr>> parse_property(const Text& text, File& file, const Sources& sources, Diagnostics& diagnostics);

}  // namespace grafverif::st
