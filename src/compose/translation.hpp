// SPDX-License-Identifier: MIT
// Translation: terms of the equations -> terms of the network, under one meaning of the variables. Each term is copied
// once, so that the equations of a large chart cost one pass.
#pragma once

#include <utility>
#include <vector>

#include "grafverif/ir/expr.hpp"

namespace grafverif {

class Translation {
public:
    /// `leaf`: per variable of `from`, what stands for it in `to`.
    Translation(const Exprs& from, Exprs& to, std::vector<Id<Expr>> leaf)
        : from_(from), to_(to), leaf_(std::move(leaf)), copies_(from.size()) {}

    Id<Expr> operator()(Id<Expr> root) {
        if (copies_[root.index].valid()) return copies_[root.index];
        const Id<Expr> result = copied(root);
        copies_[root.index] = result;
        return result;
    }

private:
    Id<Expr> copied(Id<Expr> root) {
        const Expr& node = from_[root];
        if (node.op == Op::Variable) return leaf_[static_cast<std::size_t>(node.value)];
        if (node.op == Op::Integer) return to_.integer(node.value);
        if (node.op == Op::True || node.op == Op::False) return to_.constant(node.op == Op::True);
        std::vector<Id<Expr>> operands;
        operands.reserve(node.count);
        for (const Id<Expr> operand : from_.operands(root)) operands.push_back((*this)(operand));
        return to_.apply(node.op, operands);
    }

    const Exprs& from_;
    Exprs& to_;
    std::vector<Id<Expr>> leaf_;
    std::vector<Id<Expr>> copies_;
};

/// Calls `visit` with the index of each variable that a term reads, shared subterms once per walk.
class Reads {
public:
    explicit Reads(const Exprs& exprs) : exprs_(exprs), seen_(exprs.size(), 0) {}

    void start() { ++walk_; }

    template <class Visit>
    void each(Id<Expr> root, const Visit& visit) {
        if (seen_[root.index] == walk_) return;
        seen_[root.index] = walk_;
        if (exprs_[root].op == Op::Variable) visit(static_cast<std::uint32_t>(exprs_[root].value));
        for (const Id<Expr> operand : exprs_.operands(root)) each(operand, visit);
    }

private:
    const Exprs& exprs_;
    std::vector<std::uint32_t> seen_;
    std::uint32_t walk_ = 0;
};

}  // namespace grafverif
