// SPDX-License-Identifier: MIT
// Completion: computes proposals for the text at the cursor. Proposals are names, with their declarations and comments,
// and the keywords that are valid at the cursor.
#pragma once

#include <string>
#include <vector>

#include "lsp/names.hpp"

namespace grafverif::lsp {

/// The kind of a proposal, with its number in LSP 3.17 ("CompletionItemKind").
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
    std::string snippet = {};  ///< text with placeholders; if empty, the label is inserted
};

ProposalKind kind_of(DeclarationKind kind);

/// Returns the proposals at the offset `cursor` of a file.
std::vector<Proposal> proposals(const Names& names, const Parsed& file, std::size_t cursor);

}  // namespace grafverif::lsp
