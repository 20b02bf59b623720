// SPDX-License-Identifier: MIT
// Workspace: the current texts of all files. A document that is open in the editor replaces the file on the disk, also
// if another file includes this file. All other files are read from the disk, and read again when they change.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/grafverif.hpp"
#include "lsp/text.hpp"
#include "pipeline/file_watcher.hpp"
#include "pipeline/files.hpp"
#include "read/text.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif::lsp {

struct OpenText {
    std::string uri = {}, path = {};
    std::string identity = {};  ///< identity of the file on the disk; empty if the file does not exist
    std::int64_t version = 0;
    std::shared_ptr<const Text> text = {};
    /// True if an edit could not be applied, so that this text differs from the text in the editor.
    bool out_of_step = false;
};

enum class TextLanguage {
    Grafcet,         ///< the input language, or an unknown format
    StructuredText,  ///< Structured Text and textual Sequential Function Charts (IEC 61131-3)
    Other,           ///< other formats that grafverif imports
};

/// A text with the syntax tree of its valid parts. For files in other languages, the tree contains only the comments of
/// Structured Text.
struct Parsed {
    std::string path = {};
    std::shared_ptr<const Text> text = {};
    tree::File tree = {};
    TextLanguage language = TextLanguage::Grafcet;
    bool broken = false;
    bool is_renamable = false;  ///< false for files in other formats and of the component library

    std::string_view bytes(Span where) const {
        return std::string_view(text->bytes()).substr(where.begin, where.end - where.begin);
    }
};
using Files = std::vector<std::shared_ptr<const Parsed>>;

/// Returns the language of a text. `path` determines the language of a text that does not identify its language.
TextLanguage language_of(const std::string& path, std::string_view text);

/// The input texts of a parse, by path. The parse is valid while these texts are unchanged.
using Inputs = std::vector<std::pair<std::string, std::shared_ptr<const Text>>>;

class Workspace {
public:
    /// If `within` is not empty, only files below these folders are read from the disk. If `stop` is not null, it is a
    /// flag that cancels searches in folders.
    explicit Workspace(std::vector<std::string> include_folders, const std::vector<std::string>& within = {},
                       const std::atomic<bool>* stop = nullptr)
        : include_folders_(std::move(include_folders)), within_(within), stop_(stop) {}

    /// Adds a folder to search for files that include open documents.
    void add_folder(const std::string& path) { folders_.push_back(path), scanned_ = false; }

    /// Opens a document. If the memory for the text of the document cannot be allocated, the document is open, but
    /// `out_of_step` is true.
    void open(const std::string& uri, std::int64_t version, const std::string& text);
    void change(const std::string& uri, std::int64_t version, const std::vector<Change>& changes);
    void close(const std::string& uri);
    const OpenText* find(const std::string& uri) const;
    const OpenText* open_at(const std::string& path) const;
    /// Returns the address under which the file is open in the editor. If the file is not open, returns an address
    /// derived from the path.
    std::string uri_of(const std::string& path) const;
    /// Returns the path under which the file is open in the editor. If the file is not open, returns `path`.
    std::string shown(const std::string& path) const;
    std::vector<OpenText> open_texts() const;

    /// True if files on the disk have changed since they were read. If files have changed, the function discards the
    /// stored texts, so that the files are read again.
    bool refresh();
    /// Returns the text of a file, or null if it does not exist.
    std::shared_ptr<const Text> text(const std::string& path);
    std::shared_ptr<const Parsed> parsed(const std::string& path);
    /// Returns the paths of the file and of all files that include it or declare it as a program.
    std::vector<std::string> roots(const std::string& path);
    /// True if the workspace was too large for a complete search, so that further roots may exist.
    bool cut_short() const { return cut_short_; }

    /// Parses the file with its includes, and records its names in `references`. The result has no model if the file is
    /// a PLC program.
    ParseResult reading(const std::string& path, Inputs& inputs, References& references);
    bool holds(const Inputs& inputs);

    /// Returns a text that identifies a file. The text is equal for all paths to the same file.
    std::string key(const std::string& path) const;

private:
    std::vector<std::string> includes(const Parsed& file);
    void scan();

    std::vector<std::string> include_folders_, folders_ = {};
    PermittedFolders within_;
    const std::atomic<bool>* stop_;
    std::map<std::string, OpenText> open_ = {};  ///< open documents by address
    FileWatcher watch_ = {};
    std::map<std::string, std::shared_ptr<const Text>> disk_ = {};  ///< texts by path; null if the file cannot be read
    std::map<std::string, std::shared_ptr<const Parsed>> parsed_ = {};  ///< parsed files by path

    /// Paths of the files in the folders of the workspace.
    std::vector<std::string> files_ = {};
    bool scanned_ = false, cut_short_ = false;
};

}  // namespace grafverif::lsp
