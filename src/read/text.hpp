// SPDX-License-Identifier: MIT
// read/text: a file of any format (see formats) with its includes -> Model. Files are read only through `load`, each
// once. Components of the library are added if a closed loop refers to them and the input does not define them.
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

namespace grafverif {

struct LibraryEntry {
    std::string_view name = {};  ///< of the component
    std::string_view text = {};  ///< of its file
    std::string_view path = {};  ///< as shown in diagnostics
};

struct ReadContext {
    /// The text of the file at `path` (`written` relative to the folder of the including file, or to one of `folders`).
    /// Empty after an error, with the reason in `why`: not found, not permitted, too large.
    std::function<std::optional<std::string>(const std::string& path, std::string& why)> load = {};
    std::span<const LibraryEntry> library = {};
    bool lossy = false;  ///< constructs of other formats that a chart cannot represent are omitted with a warning
    /// Identity of the file at `path`: equal for all paths to one file; empty if there is no file. Without this
    /// function every path is a separate file.
    std::function<std::string(const std::string& path)> identity = {};
    std::span<const std::string> folders = {};  ///< search path for includes, after the folder of the including file
    std::map<std::string, std::string, std::less<>> constants = {};  ///< constants of closed loops set by the user:
                                                                     ///< name, value
    /// Cancellation flag: once it is set, `read_text` soon returns no model, with arbitrary diagnostics.
    const std::atomic<bool>* stop = nullptr;
};

/// The file that an include of `written` in the file `from` refers to: the first existing candidate, otherwise the
/// first candidate.
std::string path_of_include(const std::string& from, const std::string& written, const ReadContext& context);

/// Charts, components and loops of `file` and its includes, in order; empty after at least one error. Guarantees
/// verify(model).empty().
std::optional<Model> read_text(Id<Source> file, Sources& sources, const ReadContext& context, Diagnostics& diagnostics);

/// The same for parsed files, without following includes; also empty if one of them is `broken`. `files_missing`: some
/// files could not be read.
std::optional<Model> model_of(std::span<const tree::File> files, bool files_missing, Sources& sources,
                              const ReadContext& context, Diagnostics& diagnostics);

}  // namespace grafverif
