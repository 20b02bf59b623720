// SPDX-License-Identifier: MIT
// read/text: reads a file of any format (see formats) with its includes to a Model. Files are read only through
// ReadContext::load, and each file is read once. A library component is added if a closed loop refers to it and the
// input does not define it.
#pragma once

#include <atomic>
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
#include "syntax/resolve/references.hpp"

namespace grafverif {

struct LibraryEntry {
    std::string_view name = {};  ///< name of the component
    std::string_view text = {};  ///< text of its file
    std::string_view path = {};  ///< path of its file in diagnostics
};

struct ReadContext {
    /// Returns the text of the file at `path`. The result is empty after an error, with the reason in `why`: not found,
    /// not permitted, too large.
    std::function<std::optional<std::string>(const std::string& path, std::string& why)> load = {};
    std::span<const LibraryEntry> library = {};
    bool lossy = false;  ///< true: omit constructs that a chart cannot represent, with a warning
    /// Returns the identity of the file at `path`. The identity is equal for all paths to one file, and empty if the
    /// file does not exist. If this function is not set, every path is treated as a separate file.
    std::function<std::string(const std::string& path)> identity = {};
    /// Folders in which includes are searched, after the folder of the including file.
    std::span<const std::string> folders = {};
    /// Constants of closed loops set by the user: value by name.
    std::map<std::string, std::string, std::less<>> constants = {};
    /// If not null, receives the declarations and references in files of the input language and in PLC programs,
    /// including declarations with errors and the references in them.
    References* references = nullptr;
    /// Cancellation flag. After `*stop` becomes true, `read_text` soon returns an empty result; ignore its diagnostics.
    const std::atomic<bool>* stop = nullptr;
};

/// Returns the path of the file that the file `from` includes as `written`. The candidates are `written` relative to
/// the folder of `from` and relative to each of `context.folders`. The result is the first candidate that exists; if
/// none exists, the first candidate.
std::string path_of_include(const std::string& from, const std::string& written, const ReadContext& context);

/// Reads the charts, components and loops of `file` and its includes, in order. The result is empty after at least one
/// error. Guarantees verify(model).empty().
std::optional<Model> read_text(Id<Source> file, Sources& sources, const ReadContext& context, Diagnostics& diagnostics);

/// Builds a model from parsed files, without following includes. The result is empty after at least one error, and if a
/// file is `broken`. `files_missing` is true if some files could not be read.
std::optional<Model> model_of(std::span<const tree::File> files, bool files_missing, Sources& sources,
                              const ReadContext& context, Diagnostics& diagnostics);

}  // namespace grafverif
