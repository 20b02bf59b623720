// SPDX-License-Identifier: MIT
// Represents the bits of an Expr of any intermediate representation by functions of the variables of a BddSpace (see
// ir/bit_terms.hpp).
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

/// Represents a value of `type` by variables of a space. The bits encode the offset of the value from type.low, as an
/// unsigned number with the least significant bit first. The word has as many bits as the range
/// requires (no bits for a range with a single value). A Boolean has one bit.
struct BddWord {
    Type type = {};
    std::vector<std::uint32_t> bits = {};
};

/// Returns a term that has the value of `word`. For assignments for which `in_range` is false, the value of the term
/// exceeds type.high.
BddTerm term_of(const BddSpace& space, const BddWord& word);
/// Returns the function that is true for assignments for which the value of the word is in the range of its type.
Bdd in_range(const BddSpace& space, const BddWord& word);
/// Returns the function that is true for assignments for which the word has the value `value`. Requires that `value` is
/// in the range of its type.
Bdd equals(const BddSpace& space, const BddWord& word, std::int64_t value);
/// Returns the value of the word under an assignment to all its bits; Booleans are 0 and 1.
std::int64_t value_of(const BddWord& word, const std::vector<bool>& assignment);

/// Returns the bits of a word of `type` that has the value of `term`. Requires that this value is in the range of
/// `type`.
std::vector<Bdd> word_bits(const BddTerm& term, Type type);

/// Returns the value of a term under an assignment to all variables on which it depends. Requires that the term has a
/// value under this assignment.
std::int64_t value_of(const BddTerm& term, const std::vector<bool>& assignment);

extern template class BitTerms<Bdd>;

}  // namespace grafverif
