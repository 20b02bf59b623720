// SPDX-License-Identifier: MIT
// Makes external text safe to print on a terminal: names, property texts, file names, output of other programs.
// Characters that a terminal interprets instead of displaying them are replaced by `?`, which is one column wide.
// The replaced characters are control characters (which begin escape sequences), directional
// formatting characters, line and paragraph separators, and each byte of invalid UTF-8. All output
// for users passes through these functions; json_text and xml_text are used for output to programs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace grafverif {

/// The first character of a text.
struct Glyph {
    std::size_t bytes = 1;   ///< length in bytes; 1 for invalid UTF-8
    std::uint32_t code = 0;  ///< Unicode code point; U+FFFD for invalid UTF-8
    bool well_formed = true;
    /// True if terminals interpret the character: control characters (including tab and line feed), directional
    /// formatting, line and paragraph separators, and each byte of invalid UTF-8.
    bool obeyed = false;
    std::size_t columns = 1;  ///< width on a terminal: 0, 1 or 2; 1 if `obeyed`
};

/// Returns the first character of a text, which must not be empty.
Glyph first_glyph(std::string_view text);

/// Returns the width of the single line `text` on a terminal; a tab has width 1.
std::size_t columns_of(std::string_view text);

/// Returns the number of bytes of the complete characters in the first `columns` columns of `text`.
std::size_t bytes_within(std::string_view text, std::size_t columns);

/// Returns `text` if it fits into `columns` columns; otherwise the beginning of `text`, followed by `…`. Requires
/// `columns` >= 1.
std::string cut_to(std::string_view text, std::size_t columns);

/// Returns `text`, padded with trailing spaces to `columns` columns.
std::string padded(std::string_view text, std::size_t columns);

/// Returns `text` on one line, with `?` in place of every character that a terminal interprets, except tabs.
std::string printable(std::string_view text);

/// Returns `text` with the same replacements as `printable`, but keeps line feeds.
std::string printable_lines(std::string_view text);

}  // namespace grafverif
