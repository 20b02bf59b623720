// SPDX-License-Identifier: MIT
// Workspace: texts as they are now. What is open in the editor stands for the file on the disk, for itself and for all
// that include it; all other files are read from the disk, and again when they change there.
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
#include "pipeline/watch.hpp"
#include "read/text.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif::lsp {

struct OpenText {
    std::string uri = {}, path = {};
    std::string identity = {};  ///< of the file on the disk, if there is one
    std::int64_t version = 0;
    std::shared_ptr<const Text> text = {};
    bool out_of_step = false;  ///< a change was lost: the text is not that of the editor
};

/// A text on its own: whatever is wrong with it, a tree of what is not. Of other formats than ours the tree is empty.
struct Parsed {
    std::string path = {};
    std::shared_ptr<const Text> text = {};
    tree::File tree = {};
    bool broken = false;

    std::string_view bytes(Span where) const {
        return std::string_view(text->bytes()).substr(where.begin, where.end - where.begin);
    }
};
using Files = std::vector<std::shared_ptr<const Parsed>>;

/// The texts a reading was made of; it holds while they are the same.
using Inputs = std::vector<std::pair<std::string, std::shared_ptr<const Text>>>;

class Workspace {
public:
    /// `stop`, if any, ends looking through folders.
    explicit Workspace(std::vector<std::string> include_folders, const std::atomic<bool>* stop = nullptr)
        : include_folders_(std::move(include_folders)), stop_(stop) {}

    /// Files below it are looked through for those that include what is open.
    void add_folder(const std::string& path) { folders_.push_back(path), scanned_ = false; }

    void open(const std::string& uri, std::int64_t version, std::string text);
    void change(const std::string& uri, std::int64_t version, const std::vector<Change>& changes);
    void close(const std::string& uri);
    const OpenText* find(const std::string& uri) const;
    const OpenText* open_at(const std::string& path) const;
    /// The address under which the editor has the file open, or else one made of the path.
    std::string uri_of(const std::string& path) const;
    /// The path of the file as the editor has it, where it is open; else the same.
    std::string shown(const std::string& path) const;
    std::vector<OpenText> open_texts() const;

    /// Looks whether files have changed on the disk since they were read.
    bool refresh();
    /// Null: there is none.
    std::shared_ptr<const Text> text(const std::string& path);
    std::shared_ptr<const Parsed> parsed(const std::string& path);
    /// The file and all that it includes.
    Files closure(const std::string& path);
    /// The file and all that include it.
    std::vector<std::string> roots(const std::string& path);
    /// All files that can name what `path` declares, or declare what it names: those of all its roots.
    Files related(const std::string& path);
    /// Whether the workspace was too large to look through: there may be other roots.
    bool cut_short() const { return cut_short_; }

    /// What is read of the file and all that it includes.
    Reading reading(const std::string& path, Inputs& inputs);
    bool holds(const Inputs& inputs);

private:
    std::string key(const std::string& path) const;
    std::vector<std::string> includes(const Parsed& file);
    void scan();

    std::vector<std::string> include_folders_, folders_ = {};
    const std::atomic<bool>* stop_;
    std::map<std::string, OpenText> open_ = {};  ///< by address
    Watch watch_ = {};
    std::map<std::string, std::shared_ptr<const Text>> disk_ = {};      ///< by path; null: it cannot be read
    std::map<std::string, std::shared_ptr<const Parsed>> parsed_ = {};  ///< by path
    std::vector<std::string> files_ = {};                               ///< of the folders
    bool scanned_ = false, cut_short_ = false;
};

}  // namespace grafverif::lsp
