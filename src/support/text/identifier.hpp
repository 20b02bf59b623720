// SPDX-License-Identifier: MIT
// Checks and converts names in any script. Valid names are the default identifiers of UAX #31 (XID_Start, then
// XID_Continue; `_` is treated as a letter). Normalization Form C makes names equal that differ only in the encoding of
// their characters. The tables of the library ICU are used, except for pure ASCII text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace grafverif {

/// Returns the length in bytes of the longest prefix that is a valid identifier. Requires UTF-8.
std::size_t identifier_length(std::string_view identifier);

/// Returns `name` in Normalization Form C (UAX #15).
std::string composed(std::string_view name);

/// Returns the ASCII transliteration of `name` by the library ICU (transforms `Any-Latin` and `de-ASCII`), such as
/// `Foerderer` for `Förderer`. ASCII characters are unchanged. Different names may have the same transliteration, and a
/// transliteration may be empty.
std::string in_ascii(std::string_view name);

}  // namespace grafverif
