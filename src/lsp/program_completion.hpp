// SPDX-License-Identifier: MIT
// Computes completion proposals in Structured Text and textual Sequential Function Charts.
#pragma once

#include <vector>

#include "lsp/completion.hpp"

namespace grafverif::lsp {

/// Returns the proposals at the offset `cursor`: members after `Instance.`, types after `:`, and parameters in a call.
/// At any other position, returns all names that are valid in the unit, functions and keywords.
std::vector<Proposal> program_proposals(const Names& names, const Parsed& file, std::size_t cursor);

}  // namespace grafverif::lsp
