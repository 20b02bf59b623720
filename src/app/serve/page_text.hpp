// SPDX-License-Identifier: MIT
// The text of a file as a page shows it: a text field replaces each line end by `\n`, and counts UTF-16 units.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif::app {

/// Returns the text as a page shows it.
std::string page_text(std::string_view text);

/// Returns the text of a page, with each line end replaced by that of the first line of `file`.
std::string with_line_ends(std::string_view page, std::string_view file);

/// Returns the text of the file after a user has changed the text of the page to `page`. `before` is the text of the
/// file before this change. All line ends outside of the change are kept; new lines have the line end of the first line
/// of `before`.
std::string text_of_page(std::string_view page, std::string_view before);

/// Converts byte offsets in the text of a file to positions in the text of a page.
class PagePositions {
public:
    explicit PagePositions(std::string_view text);

    std::uint32_t of(std::size_t offset) const { return units_[offset < units_.size() ? offset : units_.size() - 1]; }

private:
    std::vector<std::uint32_t> units_ = {};  ///< for each byte: number of UTF-16 units before it
};

}  // namespace grafverif::app
