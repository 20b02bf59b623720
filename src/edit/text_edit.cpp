// SPDX-License-Identifier: MIT
#include "edit/text_edit.hpp"

#include <algorithm>
#include <utility>

#include "support/text/encoding.hpp"

namespace grafverif::edit {

void sort(std::vector<TextEdit>& edits) {
    std::ranges::stable_sort(edits, {}, [](const TextEdit& edit) { return std::pair(edit.begin, edit.end); });
}

std::string applied(std::string_view text, const std::vector<TextEdit>& edits) {
    std::string result;
    std::size_t done = 0;
    for (const TextEdit& edit : edits) {
        result += text.substr(done, edit.begin - done);
        result += edit.replacement;
        done = edit.end;
    }
    return result += text.substr(done);
}

std::vector<TextEdit> inverse(std::string_view text, const std::vector<TextEdit>& edits) {
    std::vector<TextEdit> inverses;
    std::uint32_t grown = 0;  // length added by the previous edits, modulo 2^32
    for (const TextEdit& edit : edits) {
        const auto size = static_cast<std::uint32_t>(edit.replacement.size());
        const std::uint32_t begin = edit.begin + grown;
        inverses.push_back({begin, begin + size, std::string(text.substr(edit.begin, edit.end - edit.begin))});
        grown += size - (edit.end - edit.begin);
    }
    return inverses;
}

TextEdit difference(std::string_view before, std::string_view after) {
    const std::size_t shorter = std::min(before.size(), after.size());
    std::size_t begin = 0, tail = 0;
    while (begin < shorter && before[begin] == after[begin]) ++begin;
    const auto inside = [](std::string_view text, std::size_t at) {
        return at < text.size() && continues_character(text[at]);
    };
    while (begin > 0 && (inside(before, begin) || inside(after, begin))) --begin;
    while (tail < shorter - begin && before[before.size() - tail - 1] == after[after.size() - tail - 1]) ++tail;
    while (tail > 0 && (inside(before, before.size() - tail) || inside(after, after.size() - tail))) --tail;
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(before.size() - tail),
            std::string(after.substr(begin, after.size() - tail - begin))};
}

}  // namespace grafverif::edit
