// SPDX-License-Identifier: MIT
// The values of the literals of IEC 61131-3.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace grafverif::st {

/// `1_000`; empty where it is too large.
std::optional<std::int64_t> integer_of(std::string_view digits, int base);

/// `1h30m`, `2.5s`, `-250ms`: whole milliseconds; empty where it is none of these, or too long to be a duration.
std::optional<std::int64_t> milliseconds_of(std::string_view duration);

}  // namespace grafverif::st
