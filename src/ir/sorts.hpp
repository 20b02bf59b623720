// SPDX-License-Identifier: MIT
// The sorts of terms, for every `verify`: a term has one, or it is wrongly typed somewhere inside. Which leaves a term
// may read, and of what sort they are, depends on the owner of the table.
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
    None,  ///< of no term: it is missing, or an operand or leaf in it has no place there
    Boolean,
    Integer,
    Duration,  ///< sums of durations, and integers times a duration; of components only
};

inline Sort sort_of(Type type) { return type.boolean ? Sort::Boolean : Sort::Integer; }

/// The sorts of the terms of one table, each found out once.
class Sorts {
public:
    /// `leaf` gives the sort of each leaf, edges (Rise, Fall) and durations; None where it has no place. An edge is
    /// asked for only where its operand is Boolean. `exprs` outlives this.
    Sorts(const Exprs& exprs, std::function<Sort(const Expr&)> leaf) : exprs_(&exprs), leaf_(std::move(leaf)) {}

    /// None of a term that is not in the table.
    Sort operator()(Id<Expr> term);

    /// Adds a fault to `faults` unless `term` is of sort `wanted`; `what` names the term. Whether it is.
    bool check(Id<Expr> term, Sort wanted, const std::string& what, std::vector<std::string>& faults);

private:
    bool all(Id<Expr> term, Sort sort);
    Sort of(Id<Expr> term);

    const Exprs* exprs_;
    std::function<Sort(const Expr&)> leaf_;
    std::unordered_map<std::uint32_t, Sort> known_ = {};
};

}  // namespace grafverif
