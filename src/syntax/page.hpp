// SPDX-License-Identifier: MIT
// Page: the lines of a text under way, and the comments and blank lines that go between them. Everything is placed by
// position: before a thing is written, the comments that stand before it are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "grafverif/syntax/tree.hpp"

namespace grafverif {

class Page {
public:
    explicit Page(const tree::File& file) : file_(&file) {}

    /// What was written at `begin` follows: its comments, and a blank line if there was one. `apart`: in any case.
    void before(std::uint32_t begin, bool apart = false);
    /// Comments that stand inside something without lines of its own.
    void within(std::uint32_t end);
    void line(std::string text);
    /// The comments behind what ended at `end`, on its line; those at `limit` and after it belong to what follows.
    void behind(std::uint32_t limit);
    /// Comments up to the end of a block or of the file.
    void remaining(std::uint32_t end);

    void indent() { ++depth_; fresh_ = true; }
    void outdent() { --depth_; fresh_ = false; }
    std::size_t column() const { return 4 * depth_; }
    bool has_comment_before(std::uint32_t end) const;

    void write(std::ostream& out) const;

private:
    struct Line {
        std::string text = {};
        std::string comment = {};
    };

    void own_line(const tree::Comment& comment);
    bool gap_at(std::uint32_t position) const;

    const tree::File* file_;
    std::vector<Line> lines_ = {};
    std::size_t next_ = 0;       ///< comment to be placed
    std::size_t depth_ = 0;
    bool fresh_ = true;          ///< at the start of a block or of the file: no blank line
};

}  // namespace grafverif
