// SPDX-License-Identifier: MIT
// Terms as Boolean functions: what an Expr of any IR means, bit by bit, over the variables of a BddSpace.
//
// A Boolean is one bit. An integer is a number in two's complement, least significant bit first, as many bits as it
// needs: sums and products grow, so nothing wraps around. Bits are functions, hence an integer is a function from
// assignments to numbers.
//
// A term has a value wherever `evaluate` (ir/expr.hpp) gives it one, and the same; `undefined` tells where it has none:
// division by zero, or a result outside 64 bits. Like `evaluate`, `and` and `or` stop at the first operand that
// decides, and a conditional looks at one branch only.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "bdd/bdd.hpp"
#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/type.hpp"

namespace grafverif {

/// A value that depends on the variables of a space.
struct BddTerm {
    bool boolean = true;
    std::vector<Bdd> bits = {};  ///< of a Boolean one; of an integer one or more, the last its sign
    Bdd undefined = {};          ///< where it has no value; its bits mean nothing there

    bool operator==(const BddTerm&) const = default;
};

BddTerm bdd_boolean(const Bdd& value);
BddTerm bdd_integer(std::int64_t value);

/// A variable of `type` as bits of a space: value - type.low, unsigned, least significant first; as many as the range
/// needs, none where it holds one value only. A Boolean is one bit.
struct BddWord {
    Type type = {};
    std::vector<std::uint32_t> bits = {};
};

/// The number of bits of a variable of `type`.
std::size_t bit_count(Type type);
/// The word as a term. Outside `in_range` its value is above type.high.
BddTerm term_of(const BddSpace& space, const BddWord& word);
/// Where the word holds a value of its type.
Bdd in_range(const BddSpace& space, const BddWord& word);
/// Where it holds `value`, which is one of its type.
Bdd equals(const BddSpace& space, const BddWord& word, std::int64_t value);
/// The value of the word under an assignment to all its bits; Booleans 0 and 1.
std::int64_t value_of(const BddWord& word, const std::vector<bool>& assignment);

/// The bits of a word of `type` that holds the term, whose value is in the range of the type.
std::vector<Bdd> word_bits(const BddTerm& term, Type type);

/// Where two terms of one kind have the same value, both being defined.
Bdd equal(const BddTerm& left, const BddTerm& right);
/// Where the term has that value; of a Boolean one: 0 or 1.
Bdd equals(const BddTerm& term, std::int64_t value);
/// The value of a term under an assignment to all variables that it depends on, where it has one.
std::int64_t value_of(const BddTerm& term, const std::vector<bool>& assignment);
/// Where the integer has a value in [low, high]; of a Boolean: where it is defined.
Bdd within(const BddTerm& term, std::int64_t low, std::int64_t high);
/// `condition` is Boolean, the others are of one kind.
BddTerm conditional(const BddTerm& condition, const BddTerm& then, const BddTerm& otherwise);

/// The terms of one table as functions; each subterm is translated once.
class BddTerms {
public:
    /// `leaf` says what a leaf is (is_leaf; not an edge). Both arguments outlive this.
    BddTerms(const Exprs& exprs, std::function<BddTerm(const Expr&)> leaf);

    const BddTerm& operator()(Id<Expr> term);

private:
    BddTerm built(Id<Expr> term) const;

    const Exprs& exprs_;
    std::function<BddTerm(const Expr&)> leaf_ = {};
    std::unordered_map<std::uint32_t, BddTerm> known_ = {};
};

}  // namespace grafverif
