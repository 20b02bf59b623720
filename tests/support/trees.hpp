// SPDX-License-Identifier: MIT
// Trees: builds the tree of a text that nobody wrote: what printers of an IR make, and `format` prints. Places are made
// up: each declaration stands after the one before it, and a blank line goes before those that begin a group.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string_view>

#include "grafverif/ir/expr.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

class Trees {
public:
    explicit Trees(tree::File& file) : file_(&file), words_(file.words) {}

    tree::Name name(std::string_view text) { return {words_.intern(text), {}}; }
    /// The place of the next declaration.
    Span next(bool begins_group = false);
    void end(Span& block) { block.end = position_++; }

    Id<tree::Expr> number(std::int64_t value);
    Id<tree::Expr> duration(std::int64_t milliseconds);
    Id<tree::Expr> path(std::string_view text);  ///< `a.b.c`
    /// `root` with its leaves as `leaf` writes them.
    Id<tree::Expr> expression(const Exprs& exprs, Id<Expr> root,
                              const std::function<Id<tree::Expr>(const Expr&)>& leaf);
    Id<tree::Expr> node(tree::Op op, std::initializer_list<Id<tree::Expr>> operands);

private:
    tree::File* file_;
    tree::Words words_;
    std::uint32_t position_ = 1;
};

}  // namespace grafverif
