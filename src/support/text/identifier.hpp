// SPDX-License-Identifier: MIT
// Names in any script: the default identifiers of UAX #31 (XID_Start, then XID_Continue; `_` counts as a letter) in
// Normalization Form C, so that names that look the same but are encoded differently are one name. The tables are those
// of ICU; pure ASCII text does not use them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace grafverif {

/// Length of the longest valid identifier prefix: `identifier.size()` if all characters are allowed. Requires UTF-8.
std::size_t identifier_length(std::string_view identifier);

/// `name` in Normalization Form C (UAX #15).
std::string composed(std::string_view name);

/// ASCII transliteration of `name` by ICU (`Förderer`: `Foerderer`): `Any-Latin`, then `de-ASCII`. ASCII characters are
/// unchanged. Different names may have equal results, and the result may be empty.
std::string in_ascii(std::string_view name);

}  // namespace grafverif
