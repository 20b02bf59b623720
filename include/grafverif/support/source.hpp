// SPDX-License-Identifier: MIT
// Source and Span: positions in texts. A span is two byte offsets into one source; line and column are computed on use.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "grafverif/support/table.hpp"

namespace grafverif {

struct Source {
    std::string name = {};  ///< as shown in diagnostics: the path as the user gave it
    std::string text = {};  ///< the complete file, bytes as read
};

using Sources = Table<Source>;

struct Span {
    Id<Source> source = {};
    std::uint32_t begin = 0;  ///< byte offset of the first byte
    std::uint32_t end = 0;    ///< byte offset past the last byte

    /// Positions are ignored in comparisons: two IRs read from differently laid out texts are equal.
    bool operator==(const Span&) const { return true; }
};

/// A position in a source as shown to users: both counted from 1, the column in bytes.
struct Place {
    std::uint32_t line = 1;
    std::uint32_t column = 1;
};

/// The position of byte `offset` of `text`.
Place place(std::string_view text, std::uint32_t offset);

/// `file:12`; empty if `where` is invalid.
std::string file_and_line(const Sources& sources, const Span& where);

/// The line of `text` that contains byte `offset`, without its line end.
std::string_view line_at(std::string_view text, std::uint32_t offset);

}  // namespace grafverif
