// SPDX-License-Identifier: MIT
#include "syntax/print/constants.hpp"

#include <charconv>

#include "support/overloaded.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

std::string value_text(const NamedConstant& constant) {
    switch (constant.kind) {
    case NamedConstant::Kind::Boolean: return constant.value != 0 ? "true" : "false";
    case NamedConstant::Kind::Integer: return std::to_string(constant.value);
    case NamedConstant::Kind::Duration: return duration_text(constant.value);
    }
    unreachable();
}

std::optional<std::int64_t> value_of(NamedConstant::Kind kind, const std::string& text) {
    if (kind == NamedConstant::Kind::Boolean) {
        if (text == "true" || text == "false") return text == "true";
        return {};
    }
    if (kind == NamedConstant::Kind::Duration) return duration_ms(text);
    std::int64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, failure] = std::from_chars(text.data(), end, number);
    return failure == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

std::string constants_text(const std::vector<NamedConstant>& constants) {
    std::string text;
    for (const NamedConstant& each : constants)
        text += (text.empty() ? "" : ", ") + each.name + " = " + value_text(each) + (each.set ? " (set)" : "");
    return text;
}

}  // namespace grafverif
