// SPDX-License-Identifier: MIT
// formats: reads a file of any supported format to a syntax tree. The content determines the format; the file name is
// irrelevant. Every command accepts every format, and a .grafcet file can include files of every format.
//
// Trees from other formats keep the positions in the imported file, so that later stages report errors at these
// positions. A construct that the .grafcet language cannot represent is an error. With `lossy`, this construct causes
// only a warning, and becomes a comment in the generated text.
#pragma once

#include <atomic>
#include <string_view>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

enum class FileFormat {
    Unknown,         ///< another format, or empty; read as the input language
    Grafcet,         ///< input language
    Xml,             ///< AGRAFE GRAFCET or PLCopen TC6 XML, according to the root element
    StructuredText,  ///< IEC 61131-3: the textual form of Sequential Function Charts
};

FileFormat format_of(std::string_view text);

struct ImportOptions {
    bool lossy = false;
    /// Cancellation flag for texts in the input language: if the flag becomes true, reading ends, and the tree is
    /// incomplete.
    const std::atomic<bool>* stop = nullptr;
};

/// Returns the declarations of `source`; after an error, `broken` of the result is true. Converts a source in another
/// encoding to UTF-8.
tree::File read_any(Id<Source> source, Sources& sources, const ImportOptions& options, Diagnostics& diagnostics);

/// Returns the tree of an imported file with new positions in the order of the input language, so that each comment is
/// next to the related declaration. `format` can print the result.
tree::File laid_out(tree::File file);

}  // namespace grafverif
