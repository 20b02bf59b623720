// SPDX-License-Identifier: MIT
// What can stand at the cursor: names with how they are declared and what their comments say, and the words of the
// language that have a place there.
#pragma once

#include <string>
#include <vector>

#include "lsp/names.hpp"

namespace grafverif::lsp {

/// LSP 3.17, "CompletionItemKind".
enum class ProposalKind {
    Function = 3,
    Field = 5,
    Variable = 6,
    Class = 7,
    Module = 9,
    Property = 10,
    Keyword = 14,
    EnumMember = 20,
    Constant = 21,
    Event = 23
};

struct Proposal {
    std::string label = {};
    ProposalKind kind = ProposalKind::Keyword;
    std::string detail = {}, documentation = {};
    std::string snippet = {};  ///< with places to fill in; empty: the label
};

std::vector<Proposal> proposals(const Names& names, const Parsed& file, std::size_t cursor);

}  // namespace grafverif::lsp
