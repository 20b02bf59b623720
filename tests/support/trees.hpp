// SPDX-License-Identifier: MIT
// Trees builds the syntax tree of a generated text for printers of an IR, and `format` prints it. The locations are
// artificial: each declaration follows the previous one, and a blank line precedes the first declaration of a group.
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
    /// Returns the location of the next declaration.
    Span next(bool begins_group = false);
    void end(Span& block) { block.end = position_++; }

    Id<tree::Expr> number(std::int64_t value);
    Id<tree::Expr> duration(std::int64_t milliseconds);
    Id<tree::Expr> path(std::string_view text);  ///< returns the expression `a.b.c`

    /// Converts `root`, with leaves from `leaf`.
    Id<tree::Expr> expression(const Exprs& exprs, Id<Expr> root,
                              const std::function<Id<tree::Expr>(const Expr&)>& leaf);
    Id<tree::Expr> node(tree::Op op, std::initializer_list<Id<tree::Expr>> operands);

private:
    tree::File* file_;
    tree::Words words_;
    std::uint32_t position_ = 1;
};

}  // namespace grafverif
