// SPDX-License-Identifier: MIT
// CSV reader (RFC 4180): a field that contains a separator or a quote is enclosed in quotes, and quotes in it are
// doubled. The first row determines the separator: the comma or the semicolon (spreadsheets in countries with a decimal
// comma write semicolons). The reader ignores empty rows, a byte order mark, spaces around fields and Excel's `sep=;`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

/// Reads the fields of a text sequentially. A field that begins with a quote may extend over several lines.
class CsvScanner {
public:
    struct Field {
        std::string text = {};
        std::size_t begin = 0, end = 0;  ///< offsets of the field in the text
    };

    explicit CsvScanner(std::string_view text, char separator = ',', std::size_t at = 0)
        : text_(text), separator_(separator), at_(at) {}

    /// Reads a field up to the next separator or line end.
    Field field();
    /// Reads the separator at the current position. Returns false if another character is at this position.
    bool separator() { return at({&separator_, 1}) && ++at_ != 0; }
    void skip_line_ends();
    bool at_end() const { return at_ >= text_.size(); }
    std::size_t place() const { return at_; }

private:
    bool at(std::string_view any) const { return !at_end() && any.find(text_[at_]) != std::string_view::npos; }
    bool at_blank() const { return at(" \t") && text_[at_] != separator_; }
    std::string quoted();

    std::string_view text_;
    char separator_;
    std::size_t at_;
};

/// Returns the separator of a row: the semicolon if the row contains a semicolon but no comma, otherwise the comma.
char csv_separator(std::string_view line);

struct CsvField {
    std::string text = {};
    Span where = {};
};
using CsvRow = std::vector<CsvField>;

/// Reads the rows of a table sequentially.
class CsvRows {
public:
    /// If the file is not UTF-8 text, reports an error; the table then has no rows. Ignores rows that begin with
    /// `comment`, unless `comment` is '\0'.
    CsvRows(Id<Source> source, const Sources& sources, char comment, Diagnostics& diagnostics);

    /// Reads the next row; returns false at the end of the table.
    bool next(CsvRow& row);

    Span here() const {
        const auto place = static_cast<std::uint32_t>(scanner_.place());
        return {source_, place, place};
    }

private:
    CsvField field();

    Id<Source> source_;
    CsvScanner scanner_;
    char comment_;
};

}  // namespace grafverif
