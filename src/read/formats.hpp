// SPDX-License-Identifier: MIT
// formats: reads a file of any supported format to a tree. The format is detected from the content, never from the file
// name. Therefore, every command accepts every format, and a .grafcet file can include files of every format.
//
// Trees from other formats keep the positions in the imported file, so that later stages report errors at these
// positions. A construct that the language of .grafcet files cannot represent is reported as an error. With `lossy`,
// such a construct is reported as a warning and becomes a comment in the generated text.
#pragma once

#include <atomic>
#include <string_view>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

enum class FileFormat {
    Unknown,         ///< matches none of the formats below, or is empty; read as the input language
    Grafcet,         ///< input language
    Xml,             ///< AGRAFE GRAFCET or PLCopen TC6 XML, according to the root element
    StructuredText,  ///< IEC 61131-3: the textual form of Sequential Function Charts
};

FileFormat format_of(std::string_view text);

struct ImportOptions {
    bool lossy = false;
    /// Cancellation flag: if it is set, reading a text in the input language ends, and the tree is incomplete.
    const std::atomic<bool>* stop = nullptr;
};

/// Returns the declarations of `source`; the file is `broken` after an error. A source in another encoding is converted
/// to UTF-8.
tree::File read_any(Id<Source> source, Sources& sources, const ImportOptions& options, Diagnostics& diagnostics);

/// Returns the tree of an imported file in the order of the input language, with its comments between the related
/// declarations. `format` prints this tree.
tree::File laid_out(tree::File file);

}  // namespace grafverif
