// SPDX-License-Identifier: MIT
// Rename: renames an element at all its uses. The texts are parsed again with the new name. If a name then denotes
// another element than before the renaming, or the texts have other errors than before, the renaming is rejected.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lsp/diagnostic_store.hpp"
#include "lsp/diagnostics.hpp"
#include "lsp/names.hpp"

namespace grafverif::lsp {

/// Returns the names of texts that were parsed.
std::unique_ptr<const Names> names_of(Workspace& workspace, const std::vector<std::shared_ptr<const Root>>& roots);

struct Renaming {
    std::vector<Edit> edits = {};
    std::string obstacle = {};  ///< reason for rejection; if not empty, there are no edits
};

/// Renames an element of `names`, which are the names of `roots`.
Renaming renamed(const Workspace& workspace, const std::vector<std::shared_ptr<const Root>>& roots, const Names& names,
                 const Declaration& element, const std::string& name);

}  // namespace grafverif::lsp
