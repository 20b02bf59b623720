// SPDX-License-Identifier: MIT
// formats: a file of any supported format -> tree. The format is detected from the contents, never from the file name,
// so every command accepts every format and a .grafcet file can include any.
//
// Trees from other formats keep the positions of their file, so later stages report errors there. A construct that
// cannot be represented in the input language is an error, or with `lossy` a warning and a comment in the text.
#pragma once

#include <atomic>
#include <string_view>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

enum class FileFormat {
    Unknown,         ///< matches none of the formats below, or empty; read as the input language
    Grafcet,         ///< input language
    Xml,             ///< AGRAFE GRAFCET or PLCopen TC6 XML, according to the root element
    StructuredText,  ///< IEC 61131-3: the textual form of Sequential Function Charts
};

FileFormat format_of(std::string_view text);

struct ImportOptions {
    bool lossy = false;
    const std::atomic<bool>* stop = nullptr;  ///< ends the reading of a text in our own language, incomplete
};

/// The declarations of `source`; `broken` after an error. A source in another encoding is converted to UTF-8.
tree::File read_any(Id<Source> source, Sources& sources, const ImportOptions& options, Diagnostics& diagnostics);

/// The tree of an imported file in the order of the input language, with its comments between the related declarations:
/// the input of `format`.
tree::File laid_out(tree::File file);

}  // namespace grafverif
