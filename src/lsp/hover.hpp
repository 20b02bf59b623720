// SPDX-License-Identifier: MIT
// Creates the hover text of a declared element.
#pragma once

#include <string>

#include "grafverif/grafverif.hpp"
#include "lsp/names.hpp"

namespace grafverif::lsp {

/// Returns the declaration of the element, its comment and, if the model has no errors, its equation, as Markdown.
/// `model` is a model of a file that includes the element's file, or null.
std::string hover_text(const Names& names, const Declaration& element, const Model* model);

}  // namespace grafverif::lsp
