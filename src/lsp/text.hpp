// SPDX-License-Identifier: MIT
// Text: converts between byte offsets, which grafverif uses, and positions of an editor. In editor positions, a line
// ends with `\n`, `\r\n` or `\r`, and a character is a UTF-16 code unit (LSP 3.17, "Position").
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif::lsp {

/// A position as an editor counts it. Lines and characters are numbered from 0.
struct Position {
    std::uint32_t line = 0;
    /// In UTF-16 code units; a value beyond the end of the line denotes the end of the line.
    std::uint32_t character = 0;
    auto operator<=>(const Position&) const = default;
};
/// A range from the first position to the position after the last character.
struct Range {
    Position start = {}, end = {};
    auto operator<=>(const Range&) const = default;
};

/// An immutable text. Conversions take logarithmic time, even in a long line.
class Text {
public:
    explicit Text(std::string bytes);

    const std::string& bytes() const { return bytes_; }
    /// Returns the position of byte `offset`. If the offset is beyond the end of the text, returns the position of the
    /// end.
    Position position(std::size_t offset) const;
    /// Returns the offset of `position`. If the position is beyond the end of its line, returns the offset of the end
    /// of the line; if it is beyond the text, returns the length of the text.
    std::uint32_t offset(Position position) const;
    Range range(std::size_t begin, std::size_t end) const { return {position(begin), position(end)}; }
    std::size_t lines() const { return anchors_.back().position.line + std::size_t{1}; }

private:
    /// A known pair of offset and position: the beginning of a line, or a character within a long line. A long line has
    /// an anchor about every 256 bytes, so that no conversion traverses a complete long line.
    struct Anchor {
        std::uint32_t offset = 0;
        Position position = {};
    };

    std::string bytes_;
    std::vector<Anchor> anchors_ = {{}};
};

/// A change of a text in the editor. An edit without a range replaces the complete text.
struct Change {
    std::optional<Range> range = {};
    std::string text = {};
};
std::string changed(const Text& before, const Change& change);

}  // namespace grafverif::lsp
