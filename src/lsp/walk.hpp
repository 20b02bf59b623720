// SPDX-License-Identifier: MIT
// The way through a tree: what it declares, and what its names stand for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lsp/names.hpp"

namespace grafverif::lsp {

/// Puts into `names` what the file declares, first; then, when all is declared, the variables of its plants.
void declare_all(const Parsed& file, Names& names);
void declare_plant(const Parsed& file, Names& names);
/// In order of place.
std::vector<Use> uses_in(const Parsed& file, const Names& names);

/// What a term's `name` stands for in `owner`, a chart, component or loop, and in its partial chart `partial`; empty: nothing.
std::string term_key(const Names& names, const Thing& owner, std::string_view partial, std::string_view name);

}  // namespace grafverif::lsp
