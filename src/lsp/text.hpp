// SPDX-License-Identifier: MIT
// Text: conversion between byte offsets, which grafverif uses, and positions of editors. For editors, a line ends in
// `\n`, `\r\n` or `\r`, and a character is a UTF-16 unit (LSP 3.17, "Position").
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif::lsp {

/// A position of an editor. Both numbers start at 0.
struct Position {
    std::uint32_t line = 0;
    std::uint32_t character = 0;  ///< in UTF-16 units; beyond the end of a line, it denotes the end
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
    /// Returns the position of byte `offset`; beyond the end of the text, the position of the end.
    Position position(std::size_t offset) const;
    /// Returns the byte at `position`; beyond the end of the line or of the text, the byte at that end.
    std::uint32_t offset(Position position) const;
    Range range(std::size_t begin, std::size_t end) const { return {position(begin), position(end)}; }
    std::size_t lines() const { return anchors_.back().position.line + std::size_t{1}; }

private:
    /// The beginning of a line, or of a character at regular intervals within a long line. Therefore no conversion
    /// traverses a complete line.
    struct Anchor {
        std::uint32_t offset = 0;
        Position position = {};
    };

    std::string bytes_;
    std::vector<Anchor> anchors_ = {{}};
};

/// An edit of a text. Without a range, it replaces the complete text.
struct Change {
    std::optional<Range> range = {};
    std::string text = {};
};
std::string changed(const Text& before, const Change& change);

/// Returns the path of `file:///a%20b`; for other schemes, the address itself.
std::string path_of_uri(std::string_view uri);
/// Returns the address of a path. For files that are not on the disk, such as components of the library, the scheme is
/// `grafverif`.
std::string uri_of_path(std::string_view path);

}  // namespace grafverif::lsp
