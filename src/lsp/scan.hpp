// SPDX-License-Identifier: MIT
// Error-tolerant scanner: determines the tokens of a text, for syntax colours and for completion in incomplete
// declarations.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lsp/workspace.hpp"

namespace grafverif::lsp {

struct Word {
    enum class Kind { Name, Number, String, Comment, Sign };
    Kind kind = Kind::Sign;
    std::uint32_t begin = 0, end = 0;
};
std::vector<Word> words_of(std::string_view text, TextLanguage language = TextLanguage::Grafcet);

/// Returns the keywords of Structured Text, in capital letters and in alphabetical order.
std::span<const std::string_view> structured_text_keywords();

/// True if `word` is a keyword of the language in at least one context.
bool is_keyword(std::string_view word, TextLanguage language = TextLanguage::Grafcet);
/// True if `word` is a keyword in every context.
bool is_reserved(std::string_view word);
/// True if `word` is a valid name. If `numbers` is true, numbers are also valid names, as for steps and locations.
bool is_name(std::string_view word, bool numbers);

/// An incomplete declaration: the tokens before the cursor, preceded by the tokens of the enclosing blocks.
struct IncompleteDeclaration {
    std::vector<std::vector<std::string>> blocks = {};  ///< the tokens before each open `{`
    std::vector<std::string> words = {};  ///< tokens after the last `;` or brace, except the token at the cursor

    /// True if the cursor is in a comment or a string; completion then proposes nothing.
    bool in_text = false;
};
IncompleteDeclaration half_at(std::string_view text, std::size_t cursor);

}  // namespace grafverif::lsp
