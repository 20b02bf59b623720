// SPDX-License-Identifier: MIT
// Sort checking of terms, which every `verify` uses: a term without type errors has a sort (Boolean, integer or
// duration). The owner of the table defines the allowed leaves and their sorts.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/type.hpp"

namespace grafverif {

enum class Sort : std::uint8_t {
    None,  ///< the term is not in the table, or contains an operand or leaf that is not allowed
    Boolean,
    Integer,
    Duration,  ///< a duration, a sum of durations, or the product of an integer and a duration; only in components
};

inline Sort sort_of(Type type) { return type.boolean ? Sort::Boolean : Sort::Integer; }

/// The sorts of the terms of one table, each computed once.
class Sorts {
public:
    /// `leaf` returns the sort of a leaf, an edge (Rise, Fall) or a duration, or None if the owner of the table does
    /// not allow this term. `leaf` is called for an edge only if the operand is Boolean. `exprs` must outlive this
    /// object.
    Sorts(const Exprs& exprs, std::function<Sort(const Expr&)> leaf) : exprs_(&exprs), leaf_(std::move(leaf)) {}

    /// Returns the sort of `term`; None if the term is not in the table.
    Sort operator()(Id<Expr> term);

    /// Returns true if `term` has the sort `wanted`; otherwise adds a fault to `faults`. `what` names the term.
    bool check(Id<Expr> term, Sort wanted, const std::string& what, std::vector<std::string>& faults);

private:
    bool all(Id<Expr> term, Sort sort);
    Sort of(Id<Expr> term);

    const Exprs* exprs_;
    std::function<Sort(const Expr&)> leaf_;
    std::unordered_map<std::uint32_t, Sort> known_ = {};
};

}  // namespace grafverif
