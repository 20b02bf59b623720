// SPDX-License-Identifier: MIT
// Defines the dialects of Structured Text. One row per dialect contains all differences from IEC 61131-3.
#pragma once

#include <span>
#include <string_view>

#include "emit/structured_text/structured_text.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif::structured_text {

/// File format of a dialect. Standard: text or PLCopen XML. PouFile: a file of a TwinCAT project. Source: a text file
/// that the vendor's tool imports.
enum class FileForm { Standard, PouFile, Source };

struct DialectRow {
    Dialect dialect = Dialect::Iec;
    FileForm file = FileForm::Standard;
    std::string_view on_delay = "TON", off_delay = "TOF";  ///< names of the timer types

    /// Text before each name of a variable or instance in statements.
    std::string_view prefix = {};
    /// Character that encloses the name of the block in its first line.
    std::string_view quote = {};
    std::string_view attributes = {};  ///< attribute lines after the first line of the block
    std::string_view begin = {};       ///< line before the statements of the block
    grafverif::Dialect spelling = structured_text_spelling;
    /// Reserved words in addition to the reserved words of the standard, in capitals.
    std::span<const std::string_view> reserved = {};
};

const DialectRow& row_of(Dialect dialect);

}  // namespace grafverif::structured_text
