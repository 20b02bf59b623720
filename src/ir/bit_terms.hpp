// SPDX-License-Identifier: MIT
// Terms as Boolean functions: translates an Expr of any IR to bits. A bit is any representation of a Boolean function
// (see ir/bit_integers.hpp), such as a decision diagram or a gate.
//
// A Boolean is one bit. An integer is a two's complement number, least significant bit first, with as many bits as
// necessary: results of sums and products have more bits than the operands, so no overflow occurs. Each bit is a
// function of the assignment to the Boolean variables; therefore, an integer is a function from assignments to numbers.
//
// Under each assignment, a term has a value if and only if `evaluate` (ir/expr.hpp) returns a value, and the two values
// are equal. `undefined` is true for assignments for which the term has no value, because of a division by zero or a
// result outside 64 bits. As in `evaluate`, `undefined` ignores the operands of an `and` or `or` after the first
// operand that determines the result. `undefined` also ignores the branch that a conditional does not select.
#pragma once

#include <cassert>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/type.hpp"
#include "ir/bit_integers.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

/// The value of a term as a function of Boolean variables.
template <class Bit>
struct BitTerm {
    bool boolean = true;
    /// One bit for a Boolean; at least one bit for an integer, whose last bit is the sign.
    std::vector<Bit> bits = {};
    Bit undefined = {};  ///< true for assignments for which the term has no value; the bits are then unspecified

    bool operator==(const BitTerm&) const = default;
};

/// Number of bits needed to encode the values of `type`.
inline std::size_t bit_count(Type type) {
    if (type.boolean) return 1;
    std::size_t bits = 0;
    for (auto span = static_cast<std::uint64_t>(type.high) - static_cast<std::uint64_t>(type.low); span != 0;
         span >>= 1U)
        ++bits;
    return bits;
}

template <class Bit>
BitTerm<Bit> boolean_term(const Bit& value) {
    return {true, {value}, {}};
}
template <class Bit>
BitTerm<Bit> integer_term(std::int64_t value) {
    return {false, bits::constant<Bit>(value), {}};
}

/// True for assignments under which both terms are defined and have the same value. Requires that both operands are
/// Boolean or both are integers.
template <class Bit>
Bit equal(const BitTerm<Bit>& left, const BitTerm<Bit>& right) {
    assert(left.boolean == right.boolean);
    return bits::equal(left.bits, right.bits) & ~(left.undefined | right.undefined);
}
/// True for assignments under which the term has the value `value`, which is 0 or 1 for a Boolean.
template <class Bit>
Bit equals(const BitTerm<Bit>& term, std::int64_t value) {
    return equal(term, term.boolean ? boolean_term(Bit::constant(value != 0)) : integer_term<Bit>(value));
}
/// True for assignments under which an integer term has a value in [low, high], or a Boolean term is defined.
template <class Bit>
Bit within(const BitTerm<Bit>& term, std::int64_t low, std::int64_t high) {
    if (term.boolean) return ~term.undefined;
    const Bit outside =
        bits::less(term.bits, bits::constant<Bit>(low)) | bits::less(bits::constant<Bit>(high), term.bits);
    return ~(outside | term.undefined);
}
/// Selects one of two terms. Requires that `condition` is Boolean, and that both branches are Boolean or both are
/// integers.
template <class Bit>
BitTerm<Bit> conditional(const BitTerm<Bit>& condition, const BitTerm<Bit>& then, const BitTerm<Bit>& otherwise) {
    assert(condition.boolean && then.boolean == otherwise.boolean);
    const Bit& chosen = condition.bits.front();
    return {then.boolean, bits::choice(chosen, then.bits, otherwise.bits),
            condition.undefined | ite(chosen, then.undefined, otherwise.undefined)};
}

/// Translates the terms of one table to functions; each subterm is translated once.
template <class Bit>
class BitTerms {
public:
    /// `leaf` translates a leaf (see is_leaf). `exprs`, and all objects that `leaf` uses, must outlive this object.
    BitTerms(const Exprs& exprs, std::function<BitTerm<Bit>(const Expr&)> leaf)
        : exprs_(exprs), leaf_(std::move(leaf)) {}

    const BitTerm<Bit>& operator()(Id<Expr> term) {
        std::vector<Id<Expr>> open{term};  // iterative, because terms can be arbitrarily deep
        while (!open.empty()) {
            const Id<Expr> next = open.back();
            bool ready = true;
            if (!known_.contains(next.index))
                for (const Id<Expr> operand : exprs_.operands(next))
                    if (!known_.contains(operand.index)) {
                        open.push_back(operand);
                        ready = false;
                    }
            if (!ready) continue;
            open.pop_back();
            if (!known_.contains(next.index)) known_.emplace(next.index, built(next));
        }
        return known_.at(term.index);
    }

private:
    using Term = BitTerm<Bit>;

    Term built(Id<Expr> term) const {
        const Expr& node = exprs_[term];
        std::vector<const Term*> operands;
        for (const Id<Expr> operand : exprs_.operands(term)) operands.push_back(&known_.at(operand.index));
        switch (node.op) {
        case Op::False:
        case Op::True: return boolean_term(Bit::constant(node.op == Op::True));
        case Op::Integer:
        case Op::Duration: return integer_term<Bit>(node.value);
        case Op::Variable:
        case Op::Step:
        case Op::Timed:
        case Op::Parameter:
        case Op::At: return leaf_(node);
        case Op::Not: return {true, {~operands[0]->bits.front()}, operands[0]->undefined};
        case Op::And:
        case Op::Or: return joined(node.op == Op::Or, operands);
        case Op::Negate: return negative(*operands[0]);
        case Op::Conditional: return conditional(*operands[0], *operands[1], *operands[2]);
        case Op::Equal:
        case Op::NotEqual:
        case Op::Less:
        case Op::LessEqual:
        case Op::Greater:
        case Op::GreaterEqual: return compared(node.op, *operands[0], *operands[1]);
        case Op::Plus:
        case Op::Minus:
        case Op::Times:
        case Op::Divide:
        case Op::Modulo: return calculated(node.op, *operands[0], *operands[1]);
        case Op::Rise:
        case Op::Fall: unreachable();  // `derive` has already replaced all edge operators
        }
        unreachable();
    }

    /// Returns the value of an And or Or. Operands after the first operand that determines the result are ignored, even
    /// if they are undefined.
    static Term joined(bool disjunction, std::span<const Term* const> operands) {
        Bit value = Bit::constant(!disjunction), undefined;
        for (const Term* operand : operands) {
            const Bit evaluates_next = disjunction ? ~value : value;
            if (!operand->undefined.is_false()) undefined = undefined | (evaluates_next & operand->undefined);
            value = disjunction ? value | operand->bits.front() : value & operand->bits.front();
        }
        return {true, {value}, undefined};
    }

    static Term compared(Op op, const Term& left, const Term& right) {
        const auto with = [&](const Bit& value) { return Term{true, {value}, left.undefined | right.undefined}; };
        switch (op) {
        case Op::Equal: return with(bits::equal(left.bits, right.bits));
        case Op::NotEqual: return with(~bits::equal(left.bits, right.bits));
        case Op::Less: return with(bits::less(left.bits, right.bits));
        case Op::LessEqual: return with(~bits::less(right.bits, left.bits));
        case Op::Greater: return with(bits::less(right.bits, left.bits));
        case Op::GreaterEqual: return with(~bits::less(left.bits, right.bits));
        default: unreachable();
        }
    }

    static Term calculated(Op op, const Term& left, const Term& right) {
        Bit undefined = left.undefined | right.undefined;
        bits::Integer<Bit> result;
        switch (op) {
        case Op::Plus: result = bits::sum(left.bits, right.bits); break;
        case Op::Minus: result = bits::difference(left.bits, right.bits); break;
        case Op::Times: result = bits::product(left.bits, right.bits); break;
        case Op::Divide:
        case Op::Modulo: {
            undefined = undefined | bits::is_zero(right.bits);
            // As in `evaluate`: if -2^63 is divided by -1, both the quotient and the remainder are undefined.
            undefined =
                undefined | (bits::equal(left.bits, bits::constant<Bit>(std::numeric_limits<std::int64_t>::min())) &
                             bits::equal(right.bits, bits::constant<Bit>(-1)));
            bits::Division<Bit> both = bits::division(left.bits, right.bits);
            result = op == Op::Divide ? std::move(both.quotient) : std::move(both.remainder);
            break;
        }
        default: unreachable();
        }
        undefined = undefined | bits::cut_to_64_bits(result);
        return {false, std::move(result), undefined};
    }

    static Term negative(const Term& operand) {
        bits::Integer<Bit> result = bits::negated(operand.bits);
        const Bit undefined = operand.undefined | bits::cut_to_64_bits(result);
        return {false, std::move(result), undefined};
    }

    const Exprs& exprs_;
    std::function<Term(const Expr&)> leaf_ = {};
    std::unordered_map<std::uint32_t, Term> known_ = {};
};

}  // namespace grafverif
