// SPDX-License-Identifier: MIT
// Renames an element at all its uses. The texts are parsed again with the new name. The renaming is rejected if a name
// then denotes another element than before, or if the texts have other errors than before.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lsp/diagnostic_store.hpp"
#include "lsp/diagnostics.hpp"
#include "lsp/names.hpp"

namespace grafverif::lsp {

/// Returns the names in the texts of `roots`.
std::unique_ptr<const Names> names_of(Workspace& workspace, const std::vector<std::shared_ptr<const Root>>& roots);

struct Renaming {
    std::vector<Edit> edits = {};
    std::string obstacle = {};  ///< reason for rejection; if not empty, there are no edits
};

/// Renames an element of `names`, which are the names of `roots`.
Renaming renamed(const Workspace& workspace, const std::vector<std::shared_ptr<const Root>>& roots, const Names& names,
                 const Declaration& element, const std::string& name);

}  // namespace grafverif::lsp
