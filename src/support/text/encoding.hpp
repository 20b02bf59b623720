// SPDX-License-Identifier: MIT
// Detects encodings other than UTF-8, and converts them to UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace grafverif {

/// True if the byte belongs to a UTF-8 character but is not its first byte.
inline bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// True if `text` has the byte order mark of UTF-16, or if exactly one of its first two bytes is 0.
bool is_utf16(std::string_view text);

/// Converts UTF-16. Requires `is_utf16(text)`. The byte order mark is removed, and lone surrogates become U+FFFD.
std::string utf8_of_utf16(std::string_view text);

/// Converts Windows-1252, which differs from Latin-1 only in the control characters 0x80 to 0x9F.
std::string utf8_of_latin(std::string_view text);

/// True if `text` is not UTF-8 but may be Latin-1: it contains bytes above 127, none of which is part of a UTF-8
/// character.
bool is_latin(std::string_view text);

}  // namespace grafverif
