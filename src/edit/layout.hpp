// SPDX-License-Identifier: MIT
// Layout: computes edits that add declarations to a text, or remove declarations, without changing comments,
// indentation and line ends of other declarations.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "edit/text_edit.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif::edit {

class Layout {
public:
    Layout(std::string_view text, const tree::File& file) : text_(text), file_(file) {}

    std::string_view text(Span where) const { return text_.substr(where.begin, where.end - where.begin); }
    /// `whole` returns the position of a name with its indices. `condition` returns the position of the condition of a
    /// transition.
    Span whole(const tree::Name& name) const { return name.index.valid() ? with_indices(name.where) : name.where; }
    Span condition(const tree::Transition& transition) const;
    /// True if a comment begins in the range.
    bool has_comment(std::uint32_t begin, std::uint32_t end) const;

    /// Returns the edit that adds `declaration` after the declaration at `where`. If no other
    /// declaration is on its lines, `declaration` is added on a new line with the same indentation, otherwise on the
    /// same line.
    TextEdit added_after(Span where, const std::string& declaration) const;
    /// Returns the edit that adds a declaration with several lines after the declaration at `where`. `lines` contain
    /// only the indentation relative to the first line.
    TextEdit added_lines_after(Span where, const std::vector<std::string>& lines) const;
    /// Returns the edit that removes a declaration. If its lines contain no other declaration, the edit also removes
    /// the lines. A comment at the end of these lines is removed; comments above the declaration are kept.
    TextEdit removed(Span where) const;
    /// Returns the edits that remove the element `index` of the list of names at `places`, with one comma.
    std::vector<TextEdit> removed_name(const std::vector<Span>& places, std::size_t index) const;

    /// Returns the offset of the sign `->` in the range.
    std::uint32_t arrow(Span where) const;

private:
    Span with_indices(Span where) const;
    /// Returns the offset of the next byte that is neither white space nor in a comment.
    std::uint32_t next(std::uint32_t offset) const;
    bool begins_line(std::uint32_t offset) const;
    std::uint32_t line_begin(std::uint32_t offset) const;
    /// Returns the end of the line, before the line end.
    std::uint32_t line_end(std::uint32_t offset) const;
    /// True if `offset` is followed on its line only by white space and comments that end on the line.
    bool ends_line(std::uint32_t offset) const;

    std::string_view text_;
    const tree::File& file_;
};

}  // namespace grafverif::edit
