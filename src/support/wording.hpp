// SPDX-License-Identifier: MIT
// Helpers for the texts of diagnostics.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif::messages {

inline Diagnostic error(std::string_view code, Span where, std::string message) {
    return {Severity::Error, std::string(code), where, std::move(message), {}, {}};
}

inline Diagnostic warning(std::string_view code, Span where, std::string message) {
    return {Severity::Warning, std::string(code), where, std::move(message), {}, {}};
}

inline Diagnostic note(Span where, std::string message) {
    return {Severity::Note, {}, where, std::move(message), {}, {}};
}

/// Adds an unambiguous fix: the text at `where` is replaced by `replacement`.
inline Diagnostic with_fix(Diagnostic diagnostic, Span where, std::string_view replacement) {
    diagnostic.fix = Fix{where, std::string(replacement)};
    return diagnostic;
}

/// Returns the last `bytes` bytes of a span, for example a name without its qualifier (`X2` in `G2.X2`).
inline Span last_of(Span where, std::size_t bytes) {
    const auto length = static_cast<std::uint32_t>(std::min<std::size_t>(bytes, where.end - where.begin));
    return {where.source, where.end - length, where.end};
}

/// Returns a name as shown in a message. Long names are truncated at a character boundary.
inline std::string clipped(std::string_view name) {
    constexpr std::size_t longest = 60;
    if (name.size() <= longest) return std::string(name);
    std::size_t length = longest;
    while (length > 0 && (static_cast<unsigned char>(name[length]) & 0xC0U) == 0x80U) --length;
    return std::string(name.substr(0, length)) + "...";
}

}  // namespace grafverif::messages
