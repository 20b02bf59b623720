// SPDX-License-Identifier: MIT
// Tables in CSV by RFC 4180: fields in quotes where they hold a separator or a quote, which is doubled. Fields are
// separated by commas, or by semicolons as spreadsheets write them where the comma is the decimal sign; the first row
// tells. Rows without any text are none, and a byte order mark, blanks around fields and Excel's `sep=;` go unnoticed.
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

/// The rows of a table, one after the other.
class CsvRows {
public:
    /// No rows, after an error, of a file that is not UTF-8 text. Rows that begin with `comment` are none; '\0': none
    /// does.
    CsvRows(Id<Source> source, const Sources& sources, char comment, Diagnostics& diagnostics);

    /// False at the end.
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
