// SPDX-License-Identifier: MIT
// TextEdit: replaces a range of a text. The ranges of all edits in a list refer to the original text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif::edit {

struct TextEdit {
    std::uint32_t begin = 0, end = 0;  ///< byte offsets of the replaced range
    std::string replacement = {};
    bool operator==(const TextEdit&) const = default;
};

/// Sorts edits by position. Insertions at the same position keep their order. Requires disjoint ranges.
void sort(std::vector<TextEdit>& edits);

/// Returns the result of applying `edits`, which must be sorted, to `text`.
std::string applied(std::string_view text, const std::vector<TextEdit>& edits);

/// Returns the edits that restore `text` from the result of `applied(text, edits)`.
std::vector<TextEdit> inverse(std::string_view text, const std::vector<TextEdit>& edits);

/// Returns the smallest edit that converts `before` to `after`: its range excludes the common beginning and end. The
/// edit does not divide a UTF-8 character.
TextEdit difference(std::string_view before, std::string_view after);

}  // namespace grafverif::edit
