// SPDX-License-Identifier: MIT
// Traverses a syntax tree: collects its declarations and the uses of names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lsp/names.hpp"

namespace grafverif::lsp {

/// Adds the declarations of the file to `names`. The variables of its plants are declared after all other declarations.
void declare_all(const Parsed& file, Names& names);
void declare_plant(const Parsed& file, Names& names);
/// Returns the uses of names, sorted by position.
std::vector<Use> uses_in(const Parsed& file, const Names& names);

/// Returns the element that a term's `name` denotes in `owner`, a chart, component or loop, and its partial chart, or
/// an empty string if there is none.
std::string term_key(const Names& names, const Declaration& owner, std::string_view partial, std::string_view name);

}  // namespace grafverif::lsp
