// SPDX-License-Identifier: MIT
// The words of a text, whatever is wrong with it: for colours, and to know where a cursor stands in half a declaration.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif::lsp {

struct Word {
    enum class Kind { Name, Number, String, Comment, Sign };
    Kind kind = Kind::Sign;
    std::uint32_t begin = 0, end = 0;
};
std::vector<Word> words_of(std::string_view text);

/// Whether `word` is one of the language, where it is no name.
bool is_keyword(std::string_view word);
/// Whether it is one everywhere.
bool is_reserved(std::string_view word);
/// Whether a thing can be called so; steps and locations by a number, too.
bool is_name(std::string_view word, bool numbers);

/// A declaration that is being typed: the words before the cursor, those of the blocks around it first.
struct Half {
    std::vector<std::vector<std::string>> blocks = {};  ///< the words before each `{` that is open
    std::vector<std::string> words = {};  ///< behind the last `;` or brace; the one at the cursor left out
    bool in_text = false;                 ///< in a comment or a string: nothing is to be said
};
Half half_at(std::string_view text, std::size_t cursor);

}  // namespace grafverif::lsp
