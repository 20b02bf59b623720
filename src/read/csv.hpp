// SPDX-License-Identifier: MIT
// CSV reader (RFC 4180): a field that contains a separator or a quote is enclosed in quotes, and quotes in it are
// doubled. The first row determines the separator: the comma, or the semicolon, which spreadsheets with a decimal comma
// use. Empty rows, a byte order mark, spaces around fields and Excel's `sep=;` are ignored.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

struct CsvField {
    std::string text = {};
    Span where = {};
};
using CsvRow = std::vector<CsvField>;

/// Reads the rows of a table sequentially.
class CsvRows {
public:
    /// If the file is not UTF-8 text, an error is reported and there are no rows. Rows that begin with `comment` are
    /// ignored, unless `comment` is '\0'.
    CsvRows(Id<Source> source, const Sources& sources, char comment, Diagnostics& diagnostics);

    /// Reads the next row; returns false at the end of the table.
    bool next(CsvRow& row);

    Span here() const { return {source_, static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(at_)}; }

private:
    bool at_end() const { return at_ >= text_.size(); }
    bool at(std::string_view any) const { return !at_end() && any.find(text_[at_]) != std::string_view::npos; }
    CsvField field();
    std::string quoted();

    Id<Source> source_;
    std::string_view text_;
    char separator_ = ',';
    char comment_;
    std::size_t at_ = 0;
};

}  // namespace grafverif
