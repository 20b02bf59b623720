// SPDX-License-Identifier: MIT
// Computes the structure of a text for the editor: outline, folding ranges, and semantic tokens.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "lsp/names.hpp"

namespace grafverif::lsp {

/// An entry of the outline of a file. `parent` is the index of an earlier entry; empty at the top level.
struct Entry {
    const Declaration* element = nullptr;
    std::optional<std::size_t> parent = {};
};
std::vector<Entry> outline(const Names& names, const Parsed& file);

/// The first and the last line of a folding range. When the range is folded, its first and last line remain visible.
struct Fold {
    std::uint32_t first = 0, last = 0;
    bool comment = false;
};
std::vector<Fold> folds(const Names& names, const Parsed& file);

// LSP names of the types and modifiers of semantic tokens. Tokens contain indices of these arrays.
inline constexpr std::array<std::string_view, 12> token_types = {"keyword",  "comment",   "string",     "number",
                                                                 "variable", "parameter", "class",      "namespace",
                                                                 "function", "event",     "enumMember", "property"};
inline constexpr std::array<std::string_view, 3> token_modifiers = {"declaration", "readonly", "modification"};
/// Returns the semantic tokens as defined by LSP: five numbers for each token, with positions relative to the previous
/// token.
std::vector<std::uint32_t> tokens(const Names& names, const Parsed& file);

}  // namespace grafverif::lsp
