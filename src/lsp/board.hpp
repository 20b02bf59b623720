// SPDX-License-Identifier: MIT
// Board: what is known to be wrong with every text that is open, and with every file that includes one. Each of them is
// read on its own, as `check` would read it, and again when a text that it was made of is another one.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "lsp/told.hpp"
#include "lsp/workspace.hpp"

namespace grafverif::lsp {

/// A file that was read with all it includes. Nobody changes it any more.
struct Root {
    std::string path = {};
    std::uint64_t number = 0;  ///< of the reading; no two have the same
    Inputs inputs = {};
    Reading reading = {};
    std::shared_ptr<const Places> places = {};
    std::vector<Told> typed = {};  ///< what reading it has told
};

class Board {
public:
    /// Reads what has changed; the roots that are new. One that cannot be read has this as its only diagnostic, and is read
    /// again the next time.
    std::vector<std::shared_ptr<const Root>> look(Workspace& workspace);
    std::shared_ptr<const Root> root(const std::string& path) const;
    std::vector<std::shared_ptr<const Root>> roots() const;
    bool is_current(const Root& root) const;

    /// What was found out about a root by more than reading it; forgotten when it is read again.
    void add(const Root& root, const std::string& source, std::vector<Told> told);

    /// By path, in order of place, each once.
    std::map<std::string, std::vector<Told>> all() const;

private:
    struct Entry {
        std::shared_ptr<const Root> root = {};
        std::map<std::string, std::vector<Told>> added = {};
    };
    std::shared_ptr<const Root> read(const std::string& path, Workspace& workspace);

    std::map<std::string, Entry> entries_ = {};  ///< their roots are never null
    std::uint64_t readings_ = 0;
};

}  // namespace grafverif::lsp
