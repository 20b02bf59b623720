// SPDX-License-Identifier: MIT
// Completion in Structured Text and textual Sequential Function Charts.
#pragma once

#include <vector>

#include "lsp/completion.hpp"

namespace grafverif::lsp {

/// Returns the proposals at the offset `cursor`: members after `Instance.`, types after `:`, parameters in a call, and
/// otherwise all names that are valid in the unit, functions and keywords.
std::vector<Proposal> program_proposals(const Names& names, const Parsed& file, std::size_t cursor);

}  // namespace grafverif::lsp
