// SPDX-License-Identifier: MIT
// Rename: renames an element at all its uses. The texts are parsed again with the new name. If a name then denotes
// another element than before, the renaming is rejected.
#pragma once

#include <string>
#include <vector>

#include "lsp/diagnostics.hpp"
#include "lsp/names.hpp"

namespace grafverif::lsp {

struct Renaming {
    std::vector<Edit> edits = {};
    std::string obstacle = {};  ///< reason for rejection; if not empty, there are no edits
};

Renaming renamed(const Names& names, const std::string& key, const std::string& name);

}  // namespace grafverif::lsp
