// SPDX-License-Identifier: MIT
// What the wordings of diagnostics share.
#pragma once

#include <string>
#include <string_view>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif::messages {

inline Diagnostic error(std::string_view code, Span where, std::string message) {
    return {Severity::Error, std::string(code), where, std::move(message), {}};
}

inline Diagnostic warning(std::string_view code, Span where, std::string message) {
    return {Severity::Warning, std::string(code), where, std::move(message), {}};
}

inline Diagnostic note(Span where, std::string message) { return {Severity::Note, {}, where, std::move(message), {}}; }

/// A name as shown in a message: long ones are cut at a character.
inline std::string clipped(std::string_view name) {
    constexpr std::size_t longest = 60;
    if (name.size() <= longest) return std::string(name);
    std::size_t length = longest;
    while (length > 0 && (static_cast<unsigned char>(name[length]) & 0xC0U) == 0x80U) --length;
    return std::string(name.substr(0, length)) + "...";
}

}  // namespace grafverif::messages
