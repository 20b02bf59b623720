// SPDX-License-Identifier: MIT
// Names in any script: the default identifiers of UAX #31 (XID_Start, then XID_Continue; `_` is treated as a letter) in
// Normalization Form C. Therefore names that look the same but are encoded differently are one name. The tables are
// those of ICU; they are not used for pure ASCII text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace grafverif {

/// Returns the length of the longest prefix that is a valid identifier: `identifier.size()` if all characters are
/// allowed. Requires UTF-8.
std::size_t identifier_length(std::string_view identifier);

/// Returns `name` in Normalization Form C (UAX #15).
std::string composed(std::string_view name);

/// Returns the ASCII transliteration of `name` by ICU (`Förderer`: `Foerderer`): `Any-Latin`, then `de-ASCII`. ASCII
/// characters are unchanged. Different names may have equal results, and the result may be empty.
std::string in_ascii(std::string_view name);

}  // namespace grafverif
