// SPDX-License-Identifier: MIT
// read/text: a file of any format (see formats) with its includes -> Model. Files are read through `load` alone, each once; components of
// the library are taken in where a closed loop names them and the input has none of that name.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

struct LibraryEntry {
    std::string_view name = {};  ///< of the component
    std::string_view text = {};  ///< of its file
    std::string_view path = {};  ///< as shown in diagnostics
};

struct ReadContext {
    /// The text of the file at `path` (the including file's folder, or one of `folders`, joined with what is written
    /// there), or empty with `why`: not found, out of reach, too large.
    std::function<std::optional<std::string>(const std::string& path, std::string& why)> load = {};
    std::span<const LibraryEntry> library = {};
    bool lossy = false;  ///< what a file of another format says and a chart cannot is left out, with a warning
    /// What tells the file at `path` from others, the same for every path to it; empty: nothing is there. Without this
    /// function every path is a file of its own.
    std::function<std::string(const std::string& path)> identity = {};
    std::span<const std::string> folders = {};  ///< looked in for includes, after the folder of the including file
    std::map<std::string, std::string, std::less<>> constants = {};  ///< of closed loops, set from outside: name, value
};

/// The file that `written` means in the file named `from`: the first that is there, or else the first looked for.
std::string path_of_include(const std::string& from, const std::string& written, const ReadContext& context);

/// Charts, components and loops of `file` and what it includes, in order; empty after at least one error.
/// Guarantees verify(model).empty().
std::optional<Model> read_text(Id<Source> file, Sources& sources, const ReadContext& context, Diagnostics& diagnostics);

/// The same of files that are parsed already, whatever they include; empty also where one of them is broken.
/// `files_missing`: some could not be read.
std::optional<Model> model_of(std::span<const tree::File> files, bool files_missing, Sources& sources,
                              const ReadContext& context, Diagnostics& diagnostics);

}  // namespace grafverif
