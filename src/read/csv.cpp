// SPDX-License-Identifier: MIT
#include "read/csv.hpp"

#include <algorithm>

#include "syntax/language/readable.hpp"

namespace grafverif {

namespace {

constexpr std::string_view blanks = " \t", line_ends = "\r\n";

std::string_view first_line(std::string_view text) {
    return text.substr(0, std::min(text.find_first_of(line_ends), text.size()));
}

/// Returns the separator. If the first row contains both separators, the result is the comma, because column names
/// contain neither.
char separator_of(std::string_view line) {
    return line.find(',') == std::string_view::npos && line.find(';') != std::string_view::npos ? ';' : ',';
}

bool is_blank(const CsvRow& row) {
    return std::ranges::all_of(row, [](const CsvField& field) { return field.text.empty(); });
}

}  // namespace

CsvRows::CsvRows(Id<Source> source, const Sources& sources, char comment, Diagnostics& diagnostics)
    : source_(source), text_(sources[source].text), comment_(comment) {
    Span whole{source, 0, static_cast<std::uint32_t>(text_.size())};
    if (!is_readable(whole, sources, diagnostics)) text_ = {};
    else at_ = without_mark(whole, sources).begin;
    for (std::size_t at = at_; at < text_.size();) {
        const std::string_view line = first_line(text_.substr(at));
        const bool hint = line.starts_with("sep=") && line.size() == 5;
        at += line.size() + 1;
        if (hint) at_ = std::min(at, text_.size());
        const std::size_t first = line.find_first_not_of(blanks);
        if (hint || first == std::string_view::npos || (comment != '\0' && line[first] == comment)) continue;
        separator_ = separator_of(line);
        return;
    }
}

bool CsvRows::next(CsvRow& row) {
    while (!at_end()) {
        row = {field()};
        while (!at_end() && text_[at_] == separator_) {
            ++at_;
            row.push_back(field());
        }
        while (at(line_ends)) ++at_;
        const bool comment = comment_ != '\0' && row.front().text.starts_with(comment_);
        if (!comment && !is_blank(row)) return true;
    }
    return false;
}

CsvField CsvRows::field() {
    while (at(blanks)) ++at_;
    const std::size_t begin = at_;
    CsvField made;
    if (at("\"")) made.text = quoted();
    std::size_t end = at_;
    for (; !at_end() && text_[at_] != separator_ && !at(line_ends); ++at_) {
        made.text += text_[at_];
        if (!at(blanks)) end = at_ + 1;
    }
    made.text.resize(made.text.find_last_not_of(blanks) + 1);  // empty if the text is blank, because npos + 1 is 0
    made.where = {source_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
    return made;
}

/// Returns the text up to the closing quote, or up to the end if there is none.
std::string CsvRows::quoted() {
    std::string inside;
    for (++at_; !at_end(); ++at_) {
        if (text_[at_] != '"') inside += text_[at_];
        else if (text_.substr(at_ + 1).starts_with('"')) inside += text_[at_++];
        else break;
    }
    if (!at_end()) ++at_;
    return inside;
}

}  // namespace grafverif
