// SPDX-License-Identifier: MIT
// A thing called otherwise, wherever it is named. The texts are read again with their new names, and every name must
// stand for what it stood for: nothing is renamed that would mean something else then.
#pragma once

#include <string>
#include <vector>

#include "lsp/names.hpp"
#include "lsp/told.hpp"

namespace grafverif::lsp {

struct Renaming {
    std::vector<Edit> edits = {};
    std::string obstacle = {};  ///< not empty: there are no edits
};

Renaming renamed(const Names& names, const std::string& key, const std::string& name);

}  // namespace grafverif::lsp
