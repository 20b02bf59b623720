// SPDX-License-Identifier: MIT
// What a text looks like from afar: its things one within the other, what can be folded, what is of which colour.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "lsp/names.hpp"

namespace grafverif::lsp {

/// The things that a file declares, in order of place; `parent` is one before it, or none.
struct Entry {
    const Thing* thing = nullptr;
    std::optional<std::size_t> parent = {};
};
std::vector<Entry> outline(const Names& names, const Parsed& file);

/// Lines, both shown when folded or not: the first and the last.
struct Fold {
    std::uint32_t first = 0, last = 0;
    bool comment = false;
};
std::vector<Fold> folds(const Names& names, const Parsed& file);

// Semantic tokens: what LSP calls its types and modifiers, and tokens by their place in these lists.
inline constexpr std::array<std::string_view, 12> token_types = {"keyword",  "comment",   "string",     "number",
                                                                 "variable", "parameter", "class",      "namespace",
                                                                 "function", "event",     "enumMember", "property"};
inline constexpr std::array<std::string_view, 3> token_modifiers = {"declaration", "readonly", "modification"};
/// Five numbers for each token, each place relative to the one before.
std::vector<std::uint32_t> tokens(const Names& names, const Parsed& file);

}  // namespace grafverif::lsp
