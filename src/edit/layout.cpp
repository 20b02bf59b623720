// SPDX-License-Identifier: MIT
#include "edit/layout.hpp"

#include <algorithm>

#include "lsp/scan.hpp"

namespace grafverif::edit {

namespace {

bool is_blank(char byte) { return byte == ' ' || byte == '\t'; }

}  // namespace

bool Layout::has_comment(std::uint32_t begin, std::uint32_t end) const {
    const auto next = std::ranges::lower_bound(file_.comments, begin, {},
                                               [](const tree::Comment& comment) { return comment.where.begin; });
    return next != file_.comments.end() && next->where.begin < end;
}

Span Layout::condition(const tree::Transition& transition) const {
    if (!transition.condition.valid()) return {transition.where.source, transition.where.end, transition.where.end};
    const tree::Expr& expr = file_.exprs[transition.condition];
    const bool may_have_indices = expr.op == tree::Op::Name || expr.op == tree::Op::Member || expr.op == tree::Op::In;
    return may_have_indices ? with_indices(expr.where) : expr.where;
}

Span Layout::with_indices(Span where) const {
    for (std::uint32_t at = next(where.end); at < text_.size() && text_[at] == '['; at = next(where.end)) {
        for (int depth = 0; at < text_.size(); at = next(at + 1)) {
            if (text_[at] == '[') ++depth;
            if (text_[at] == ']' && --depth == 0) break;
        }
        where.end = at + 1;
    }
    return where;
}

std::uint32_t Layout::next(std::uint32_t offset) const {
    auto comment = std::ranges::lower_bound(file_.comments, offset, {},
                                            [](const tree::Comment& each) { return each.where.begin; });
    while (offset < text_.size()) {
        if (comment != file_.comments.end() && comment->where.begin == offset) offset = (comment++)->where.end;
        else if (is_blank(text_[offset]) || text_[offset] == '\r' || text_[offset] == '\n') ++offset;
        else break;
    }
    return offset;
}

std::uint32_t Layout::line_begin(std::uint32_t offset) const {
    while (offset > 0 && text_[offset - 1] != '\n') --offset;
    return offset;
}

bool Layout::begins_line(std::uint32_t offset) const {
    while (offset > 0 && is_blank(text_[offset - 1])) --offset;
    return offset == 0 || text_[offset - 1] == '\n';
}

std::uint32_t Layout::line_end(std::uint32_t offset) const {
    while (offset < text_.size() && text_[offset] != '\n') ++offset;
    return offset > 0 && offset < text_.size() && text_[offset - 1] == '\r' ? offset - 1 : offset;
}

bool Layout::ends_line(std::uint32_t offset) const {
    const std::uint32_t end = line_end(offset);
    auto comment = std::ranges::lower_bound(file_.comments, offset, {},
                                            [](const tree::Comment& each) { return each.where.begin; });
    while (offset < end) {
        if (is_blank(text_[offset])) {
            ++offset;
            continue;
        }
        if (comment == file_.comments.end() || comment->where.begin != offset) return false;
        if (comment->where.end > end + (end < text_.size() && text_[end] == '\r' ? 1 : 0)) return false;
        offset = comment->where.end;
        ++comment;
    }
    return true;
}

TextEdit Layout::added_after(Span where, const std::string& declaration) const {
    return added_lines_after(where, {declaration});
}

TextEdit Layout::added_lines_after(Span where, const std::vector<std::string>& lines) const {
    std::string joined;
    if (!begins_line(where.begin) || !ends_line(where.end)) {
        for (const std::string& each : lines)
            if (!each.empty()) joined += ' ' + each.substr(each.find_first_not_of(' '));
        return {where.end, where.end, joined};
    }
    const std::uint32_t first = line_begin(where.begin), end = line_end(where.end);
    for (const std::string& each : lines) {
        joined += text_.substr(end, 2) == "\r\n" ? "\r\n" : "\n";
        if (!each.empty()) joined.append(text_.substr(first, where.begin - first)).append(each);
    }
    return {end, end, joined};
}

TextEdit Layout::removed(Span where) const {
    std::uint32_t begin = where.begin, end = where.end;
    if (begins_line(begin) && ends_line(end)) {
        begin = line_begin(begin);
        end = line_end(end);
        if (end < text_.size()) end += text_[end] == '\r' ? 2U : 1U;
        else if (begin > 0) --begin;  // the last line has no line end
    } else if (begins_line(begin)) {
        while (end < text_.size() && is_blank(text_[end])) ++end;
    } else {
        while (begin > 0 && is_blank(text_[begin - 1])) --begin;
    }
    return {begin, end, ""};
}

std::vector<TextEdit> Layout::removed_name(const std::vector<Span>& places, std::size_t index) const {
    const Span& name = places[index];
    if (places.size() == 1) {
        const bool blank = name.begin > 0 && is_blank(text_[name.begin - 1]) && is_blank(text_[name.end]);
        return {{name.begin, blank ? name.end + 1 : name.end, ""}};
    }
    const bool first = index == 0;
    const std::uint32_t begin = first ? name.end : places[index - 1].end, end = first ? places[1].begin : name.begin;
    if (!has_comment(begin, end)) return {first ? TextEdit{name.begin, end, ""} : TextEdit{begin, name.end, ""}};
    std::uint32_t comma = begin;
    for (const lsp::Word& word : lsp::words_of(text_.substr(begin, end - begin)))
        if (word.kind == lsp::Word::Kind::Sign && text_[begin + word.begin] == ',') comma = begin + word.begin;
    std::vector<TextEdit> edits = {{comma, comma + 1, ""}, {name.begin, name.end, ""}};
    sort(edits);
    return edits;
}

std::uint32_t Layout::arrow(Span where) const {
    for (const lsp::Word& word : lsp::words_of(text(where)))
        if (text_.substr(where.begin + word.begin, word.end - word.begin) == "->") return where.begin + word.begin;
    return where.begin;
}

}  // namespace grafverif::edit
