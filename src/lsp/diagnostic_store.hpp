// SPDX-License-Identifier: MIT
// Diagnostic store: the current diagnostics of every open document and of every file that includes an open document.
// Each file is parsed separately, as by `check`, and is parsed again when one of its sources changes.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "lsp/diagnostics.hpp"
#include "lsp/workspace.hpp"

namespace grafverif::lsp {

/// A file that was parsed with its includes; immutable.
struct Root {
    std::string path = {};
    std::uint64_t number = 0;  ///< unique number of the parse
    Inputs inputs = {};
    ParseResult reading = {};
    References references = {};  ///< recorded names of all sources
    std::shared_ptr<const Places> places = {};
    std::vector<LspDiagnostic> typed = {};  ///< the diagnostics that parsing produced
};

class DiagnosticStore {
public:
    /// Parses changed roots again, and returns the new parses. If a root cannot be read, the read error is its only
    /// diagnostic, and the next call tries to read the root again.
    std::vector<std::shared_ptr<const Root>> look(Workspace& workspace);
    /// Parses a file. If the file cannot be read, the read error is the only diagnostic of the result.
    std::shared_ptr<const Root> read(const std::string& path, Workspace& workspace);
    std::shared_ptr<const Root> root(const std::string& path) const;
    std::vector<std::shared_ptr<const Root>> roots() const;
    bool is_current(const Root& root) const;

    /// Adds further diagnostics of a root. The added diagnostics are discarded when the root is parsed again.
    void add(const Root& root, const std::string& source, std::vector<LspDiagnostic> source_diagnostics);

    /// Returns all diagnostics by path, sorted by position, without duplicates.
    std::map<std::string, std::vector<LspDiagnostic>> all() const;

private:
    struct Entry {
        std::shared_ptr<const Root> root = {};
        std::map<std::string, std::vector<LspDiagnostic>> added = {};
    };

    std::map<std::string, Entry> entries_ = {};  ///< entries by path; their pointers to roots are never null
    std::uint64_t readings_ = 0;
};

}  // namespace grafverif::lsp
