// SPDX-License-Identifier: MIT
// What is said of a thing that one points at.
#pragma once

#include <string>

#include "grafverif/grafverif.hpp"
#include "lsp/names.hpp"

namespace grafverif::lsp {

/// How it is declared, what its comment says and, where there is a model without errors, its equation; as Markdown.
/// `model`: of a file that includes the thing's; or null.
std::string hover_text(const Names& names, const Thing& thing, const Model* model);

}  // namespace grafverif::lsp
