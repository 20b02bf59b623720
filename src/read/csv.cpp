// SPDX-License-Identifier: MIT
#include "read/csv.hpp"

#include <algorithm>
#include <utility>

#include "syntax/language/readable.hpp"

namespace grafverif {

namespace {

constexpr std::string_view blanks = " \t", line_ends = "\r\n";

std::string_view first_line(std::string_view text) {
    return text.substr(0, std::min(text.find_first_of(line_ends), text.size()));
}

bool is_blank(const CsvRow& row) {
    return std::ranges::all_of(row, [](const CsvField& field) { return field.text.empty(); });
}

}  // namespace

char csv_separator(std::string_view line) {
    return line.find(',') == std::string_view::npos && line.find(';') != std::string_view::npos ? ';' : ',';
}

CsvScanner::Field CsvScanner::field() {
    while (at_blank()) ++at_;
    Field made;
    made.begin = at_;
    if (at("\"")) made.text = quoted();
    made.end = at_;
    for (; !at_end() && text_[at_] != separator_ && !at(line_ends); ++at_) {
        made.text += text_[at_];
        if (!at_blank()) made.end = at_ + 1;
    }
    made.text.resize(made.text.find_last_not_of(blanks) + 1);  // blank text becomes empty: npos + 1 is 0
    return made;
}

/// Returns the text up to the closing quote; without a closing quote, returns the rest of the text.
std::string CsvScanner::quoted() {
    std::string inside;
    for (++at_; !at_end(); ++at_) {
        if (text_[at_] != '"') inside += text_[at_];
        else if (text_.substr(at_ + 1).starts_with('"')) inside += text_[at_++];
        else break;
    }
    if (!at_end()) ++at_;
    return inside;
}

void CsvScanner::skip_line_ends() {
    while (at(line_ends)) ++at_;
}

CsvRows::CsvRows(Id<Source> source, const Sources& sources, char comment, Diagnostics& diagnostics)
    : source_(source), scanner_(""), comment_(comment) {
    const std::string_view text = sources[source].text;
    Span whole{source, 0, static_cast<std::uint32_t>(text.size())};
    if (!is_readable(whole, sources, diagnostics)) return;
    std::size_t begin = without_mark(whole, sources).begin;
    for (std::size_t at = begin; at < text.size();) {
        const std::string_view line = first_line(text.substr(at));
        const bool hint = line.starts_with("sep=") && line.size() == 5;
        at += line.size() + 1;
        if (hint) begin = std::min(at, text.size());
        const std::size_t first = line.find_first_not_of(blanks);
        if (hint || first == std::string_view::npos || (comment != '\0' && line[first] == comment)) continue;
        scanner_ = CsvScanner(text, csv_separator(line), begin);
        return;
    }
    scanner_ = CsvScanner(text, ',', begin);
}

bool CsvRows::next(CsvRow& row) {
    while (!scanner_.at_end()) {
        row = {field()};
        while (scanner_.separator()) row.push_back(field());
        scanner_.skip_line_ends();
        const bool comment = comment_ != '\0' && row.front().text.starts_with(comment_);
        if (!comment && !is_blank(row)) return true;
    }
    return false;
}

CsvField CsvRows::field() {
    CsvScanner::Field read = scanner_.field();
    return {std::move(read.text),
            {source_, static_cast<std::uint32_t>(read.begin), static_cast<std::uint32_t>(read.end)}};
}

}  // namespace grafverif
