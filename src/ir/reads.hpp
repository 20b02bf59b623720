// SPDX-License-Identifier: MIT
// Determines which variables the terms of the equations read.
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/ir/expr.hpp"

namespace grafverif {

/// Calls `visit` with the index of each variable that a term reads. Each shared subterm is visited once per traversal.
class Reads {
public:
    explicit Reads(const Exprs& exprs) : exprs_(exprs), seen_(exprs.size(), 0) {}

    /// Starts a new traversal. The new traversal also visits subterms that earlier traversals visited.
    void start() { ++generation_; }

    template <class Visit>
    void each(Id<Expr> root, const Visit& visit) {
        if (seen_[root.index] == generation_) return;
        seen_[root.index] = generation_;
        if (exprs_[root].op == Op::Variable) visit(static_cast<std::uint32_t>(exprs_[root].value));
        for (const Id<Expr> operand : exprs_.operands(root)) each(operand, visit);
    }

private:
    const Exprs& exprs_;
    std::vector<std::uint32_t> seen_;
    std::uint32_t generation_ = 1;
};

}  // namespace grafverif
