// SPDX-License-Identifier: MIT
// Source and Span: positions in texts. A Span consists of two byte offsets into one source; `place` computes the line
// and column of an offset.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "grafverif/support/table.hpp"

namespace grafverif {

struct Source {
    std::string name = {};  ///< name in diagnostics: the path as the user gave it
    std::string text = {};  ///< complete contents of the file
};

using Sources = Table<Source>;

struct Span {
    Id<Source> source = {};
    std::uint32_t begin = 0;  ///< byte offset of the first byte
    std::uint32_t end = 0;    ///< byte offset past the last byte

    /// Always true, so that comparisons of IRs ignore positions: the IRs of two texts that differ only in layout are
    /// equal.
    bool operator==(const Span&) const { return true; }
};

/// A position in a source, as printed for users. Lines and columns are counted from 1; columns are in bytes.
struct Place {
    std::uint32_t line = 1;
    std::uint32_t column = 1;
};

/// Returns the position of byte `offset` of `text`.
Place place(std::string_view text, std::uint32_t offset);

/// Returns the file and the line of `where`, such as `file:12`, or an empty string if `where` is invalid.
std::string file_and_line(const Sources& sources, const Span& where);

/// Returns the line of `text` that contains byte `offset`, without its line end.
std::string_view line_at(std::string_view text, std::uint32_t offset);

}  // namespace grafverif
