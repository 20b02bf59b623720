// SPDX-License-Identifier: MIT
// Texts as editors count them: a line ends in `\n`, `\r\n` or `\r`, a character is a unit of UTF-16 (LSP 3.17, "Position").
// We count bytes; nobody else converts between the two.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif::lsp {

/// Both from 0.
struct Position {
    std::uint32_t line = 0;
    std::uint32_t character = 0;  ///< in UTF-16 units; past the end of a line: its end
    auto operator<=>(const Position&) const = default;
};
/// From the first position to the one past the last.
struct Range {
    Position start = {}, end = {};
    auto operator<=>(const Range&) const = default;
};

/// A text that does not change. A conversion takes logarithmic time, also in a long line.
class Text {
public:
    explicit Text(std::string bytes);

    const std::string& bytes() const { return bytes_; }
    /// Of byte `offset`; one past the end is the end.
    Position position(std::size_t offset) const;
    /// The byte at `position`; what lies behind the end of the line, or of the text, is that end.
    std::uint32_t offset(Position position) const;
    Range range(std::size_t begin, std::size_t end) const { return {position(begin), position(end)}; }
    std::size_t lines() const { return anchors_.back().position.line + std::size_t{1}; }

private:
    /// The beginning of a line; within a long line, of a character of every so many bytes, so that no conversion walks along
    /// the line.
    struct Anchor {
        std::uint32_t offset = 0;
        Position position = {};
    };

    std::string bytes_;
    std::vector<Anchor> anchors_ = {{}};
};

/// What `change` leaves of a text: without a range all is new.
struct Change {
    std::optional<Range> range = {};
    std::string text = {};
};
std::string changed(const Text& before, const Change& change);

/// `file:///a%20b` as a path; of other schemes the address itself.
std::string path_of_uri(std::string_view uri);
/// The other way; what has no place on the disk, such as a component of the library, is of the scheme `grafverif`.
std::string uri_of_path(std::string_view path);

}  // namespace grafverif::lsp
