// SPDX-License-Identifier: MIT
// Text in other encodings than UTF-8, as UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace grafverif {

/// Whether `text` has the byte order mark of UTF-16, or begins with a character of two bytes one of which is 0.
bool is_utf16(std::string_view text);

/// Of text in UTF-16, of which `is_utf16` holds; the byte order mark is left out, lone surrogates become U+FFFD.
std::string utf8_of_utf16(std::string_view text);

/// Of text in Windows-1252, which is Latin-1 but for control characters.
std::string utf8_of_latin(std::string_view text);

/// Whether `text` can be no UTF-8 at all, and be Latin-1: bytes beyond ASCII, none of them part of a character of UTF-8.
bool is_latin(std::string_view text);

}  // namespace grafverif
