// SPDX-License-Identifier: MIT
// Names in any script: the default identifiers of UAX #31 (XID_Start, then XID_Continue; `_` is a letter), in
// Normalization Form C, so that what looks the same and is written with other code points is one name. The tables are
// those of ICU; text in ASCII never asks them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace grafverif {

/// Where the first character stands that no identifier has there: `identifier.size()` where there is none. Requires UTF-8.
std::size_t identifier_length(std::string_view identifier);

/// `name` in Normalization Form C (UAX #15).
std::string composed(std::string_view name);

/// `name` in ASCII, as near to how it reads as ICU knows (`Förderer`: `Foerderer`): by the transliteration `Any-Latin`,
/// then `de-ASCII`. What is ASCII stays. Different names may become one, and of some nothing may be left.
std::string in_ascii(std::string_view name);

}  // namespace grafverif
