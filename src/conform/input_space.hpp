// SPDX-License-Identifier: MIT
// The inputs of a chart as variables of decision diagrams, and functions of them as terms to read.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "bdd/bdd.hpp"
#include "bdd/terms.hpp"
#include "grafverif/ir/expr.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif::conform {

/// The error of a search that decision diagrams stopped: at their memory, at the deadline, or by `stop`.
Diagnostic limit_reached(const BddExhausted& exhausted, Span origin, const std::atomic<bool>* stop);

template <class Inputs>
std::vector<Type> types_of(const Inputs& inputs) {
    std::vector<Type> all;
    for (const auto& input : inputs) all.push_back(input.type);
    return all;
}

/// Input k is word k; its bits are neighbours, the most significant on top.
class InputSpace {
public:
    InputSpace(const std::vector<Type>& types, const BddLimits& limits);

    std::size_t inputs() const { return words_.size(); }
    BddTerm term(std::size_t input) const { return term_of(space_, words_[input]); }
    const BddWord& word(std::size_t input) const { return words_[input]; }
    const std::vector<std::uint32_t>& bits() const { return bits_; }
    const BddSpace& space() const { return space_; }

    /// The combinations looked at: in the ranges of their types, as `assume` left them.
    const Bdd& assumed() const { return assumed_; }
    void assume(const Bdd& condition) { assumed_ &= condition; }

    /// Per variable of the space a value, such that `set`, which is not false, holds.
    std::vector<bool> assignment(const Bdd& set) const;
    /// Per input a value, such that `set`, which is not false, holds.
    std::vector<std::int64_t> witness(const Bdd& set) const;

private:
    BddSpace space_;
    std::vector<BddWord> words_ = {};
    std::vector<std::uint32_t> bits_ = {};   ///< of all inputs
    Bdd assumed_ = Bdd::constant(true);
};

/// Functions of inputs as terms of an Exprs whose Variable leaves are the inputs: irredundant sums of products (Minato
/// 1993), equal to the function wherever the inputs are as assumed. Each function is written once.
class Conditions {
public:
    Conditions(const InputSpace& space, Exprs& exprs) : space_(space), exprs_(exprs) {}

    Id<Expr> term(const Bdd& function);

private:
    struct Cover {
        std::vector<std::vector<BddLiteral>> cubes = {};
        Bdd function = {};
    };
    Id<Expr> written(const Bdd& function);
    Id<Expr> by_values(const Bdd& function, std::size_t input);
    Id<Expr> sum_of_products(const Bdd& function);
    Cover cover(const Bdd& least, const Bdd& most);
    Id<Expr> one_of(std::size_t input, const std::vector<std::int64_t>& values);

    const InputSpace& space_;
    Exprs& exprs_;
    std::unordered_map<Bdd, Id<Expr>> known_ = {};
};

}  // namespace grafverif::conform
