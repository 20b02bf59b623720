// SPDX-License-Identifier: MIT
// formats: a file of any known format -> tree. The format is told from what is written, never from the file's name, so
// that every verb takes every format and a .grafcet file may include any.
//
// Trees from other formats keep the places of their file: name resolution and type checks report faults there. What a
// format says and our language cannot is an error, or, with `lossy`, a warning and a comment in the text.
#pragma once

#include <string_view>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

enum class FileFormat {
    Unknown,         ///< what begins like none of those below, an empty file too; read as our own language
    Grafcet,         ///< our own language
    Xml,             ///< AGRAFE GRAFCET or PLCopen TC6 XML: its root tells
    StructuredText,  ///< IEC 61131-3: the textual form of Sequential Function Charts
};

FileFormat format_of(std::string_view text);

struct ImportOptions {
    bool lossy = false;
};

/// The declarations of `source`; broken after an error. A source in another encoding is rewritten as UTF-8.
tree::File read_any(Id<Source> source, Sources& sources, const ImportOptions& options, Diagnostics& diagnostics);

/// The tree of a file of another format in the order of our text, its comments between the declarations they are about:
/// what `format` prints.
tree::File laid_out(tree::File file);

}  // namespace grafverif
