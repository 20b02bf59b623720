// SPDX-License-Identifier: MIT
// Text that somebody else wrote - names, texts of properties, file names, what other programs say - as a terminal may
// see it. What a terminal obeys instead of showing it becomes `?`, one column wide: control characters (escape sequences
// begin with one), what turns the direction of the text that follows, separators of lines and paragraphs, and each byte
// that is no UTF-8. Everything for people goes through here on its way out; see json_text and xml_text for programs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace grafverif {

/// The character that a text begins with.
struct Glyph {
    std::size_t bytes = 1;   ///< that it takes; of what is no UTF-8: one
    std::uint32_t code = 0;  ///< Unicode; of what is no UTF-8: 0xFFFD
    bool well_formed = true;
    bool obeyed = false;      ///< by a terminal: control characters, tab and line feed too, and those of direction
    std::size_t columns = 1;  ///< on a terminal: 0, 1 or 2; obeyed ones count 1
};

/// Requires a text that is not empty.
Glyph first_glyph(std::string_view text);

/// The columns that `text`, in one line, takes on a terminal; a tab counts 1.
std::size_t columns_of(std::string_view text);

/// How many bytes of `text` stand in its first `columns` columns, whole characters.
std::size_t bytes_within(std::string_view text, std::size_t columns);

/// What there is room for in so many columns: `text`, or its beginning and `…`; `columns` is 1 at least.
std::string cut_to(std::string_view text, std::size_t columns);

/// `text`, and blanks behind it up to so many columns.
std::string padded(std::string_view text, std::size_t columns);

/// `text` in one line: `?` for what a terminal obeys, but a tab.
std::string printable(std::string_view text);

/// The same, but line feeds stay as well.
std::string printable_lines(std::string_view text);

}  // namespace grafverif
