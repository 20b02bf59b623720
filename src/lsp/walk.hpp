// SPDX-License-Identifier: MIT
// Traverses a syntax tree: collects its declarations and the uses of names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lsp/names.hpp"

namespace grafverif::lsp {

/// Adds the declarations of the file to `names`, except plant variables.
void declare_all(const Parsed& file, Names& names);
/// Adds the plant variables of the loops of the file. Call it after `declare_all` of all files.
void declare_plant(const Parsed& file, Names& names);
/// Returns the uses of names, sorted by position.
std::vector<Use> uses_in(const Parsed& file, const Names& names);

/// Returns the key of the element that `name` denotes in a term of `owner` (a chart, component or loop) and its partial
/// chart `partial`. Returns an empty string if there is no such element.
std::string term_key(const Names& names, const Declaration& owner, std::string_view partial, std::string_view name);

}  // namespace grafverif::lsp
