// SPDX-License-Identifier: MIT
// Represents the bits of an Expr of any IR by functions of the variables of a BddSpace (see ir/bit_terms.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "bdd/bdd.hpp"
#include "grafverif/ir/type.hpp"
#include "ir/bit_terms.hpp"

namespace grafverif {

using BddTerm = BitTerm<Bdd>;
using BddTerms = BitTerms<Bdd>;

inline BddTerm bdd_boolean(const Bdd& value) { return boolean_term(value); }
inline BddTerm bdd_integer(std::int64_t value) { return integer_term<Bdd>(value); }

/// A variable of `type` as bits of a space: the unsigned offset of the value from type.low, least significant bit
/// first, with as many bits as the range requires (none for a single value). A Boolean has one bit.
struct BddWord {
    Type type = {};
    std::vector<std::uint32_t> bits = {};
};

/// Returns the word as a term. For assignments outside `in_range`, the value exceeds type.high.
BddTerm term_of(const BddSpace& space, const BddWord& word);
/// True for assignments for which the word has a value of its type.
Bdd in_range(const BddSpace& space, const BddWord& word);
/// True for assignments for which the word has the value `value`, which must be in the range of its type.
Bdd equals(const BddSpace& space, const BddWord& word, std::int64_t value);
/// Returns the value of the word under an assignment to all its bits; Booleans are 0 and 1.
std::int64_t value_of(const BddWord& word, const std::vector<bool>& assignment);

/// Returns the bits of a word of `type` with the value of the term, which must be in the range of the type.
std::vector<Bdd> word_bits(const BddTerm& term, Type type);

/// Returns the value of a term under an assignment to all variables on which it depends. Requires that the term has a
/// value under this assignment.
std::int64_t value_of(const BddTerm& term, const std::vector<bool>& assignment);

extern template class BitTerms<Bdd>;

}  // namespace grafverif
