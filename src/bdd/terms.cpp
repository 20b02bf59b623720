// SPDX-License-Identifier: MIT
#include "bdd/terms.hpp"

#include <cassert>
#include <limits>
#include <utility>

#include "bdd/integers.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

BddTerm bdd_boolean(const Bdd& value) { return {true, {value}, {}}; }
BddTerm bdd_integer(std::int64_t value) { return {false, bdd::constant(value), {}}; }

std::size_t bit_count(Type type) {
    if (type.boolean) return 1;
    std::size_t bits = 0;
    for (auto span = static_cast<std::uint64_t>(type.high) - static_cast<std::uint64_t>(type.low); span != 0;
         span >>= 1U)
        ++bits;
    return bits;
}

BddTerm term_of(const BddSpace& space, const BddWord& word) {
    if (word.type.boolean) return bdd_boolean(space.variable(word.bits.front()));
    bdd::Integer offset;
    for (const std::uint32_t bit : word.bits) offset.push_back(space.variable(bit));
    offset.emplace_back();  // it is not negative
    return {false, bdd::sum(offset, bdd::constant(word.type.low)), {}};
}

Bdd in_range(const BddSpace& space, const BddWord& word) {
    return within(term_of(space, word), word.type.low, word.type.high);
}

Bdd equals(const BddSpace& space, const BddWord& word, std::int64_t value) {
    const auto offset =
        static_cast<std::uint64_t>(value) - static_cast<std::uint64_t>(word.type.boolean ? 0 : word.type.low);
    std::vector<BddLiteral> literals;
    for (std::size_t place = 0; place < word.bits.size(); ++place)
        literals.push_back({word.bits[place], ((offset >> place) & 1U) != 0});
    return cube(space, literals);
}

std::int64_t value_of(const BddWord& word, const std::vector<bool>& assignment) {
    std::uint64_t offset = 0;
    for (std::size_t place = 0; place < word.bits.size(); ++place)
        if (assignment[word.bits[place]]) offset |= std::uint64_t{1} << place;
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(word.type.boolean ? 0 : word.type.low) + offset);
}

std::vector<Bdd> word_bits(const BddTerm& term, Type type) {
    if (type.boolean) return term.bits;
    bdd::Integer offset = bdd::difference(term.bits, bdd::constant(type.low));
    offset.resize(bit_count(type), offset.back());
    return offset;
}

Bdd equal(const BddTerm& left, const BddTerm& right) {
    assert(left.boolean == right.boolean);
    return bdd::equal(left.bits, right.bits) & ~(left.undefined | right.undefined);
}

Bdd equals(const BddTerm& term, std::int64_t value) {
    return equal(term, term.boolean ? bdd_boolean(Bdd::constant(value != 0)) : bdd_integer(value));
}

std::int64_t value_of(const BddTerm& term, const std::vector<bool>& assignment) {
    std::int64_t value = 0;
    for (std::size_t bit = term.bits.size(); bit-- > 0;) {
        const bool sign = !term.boolean && bit + 1 == term.bits.size();
        const bool on = evaluate(term.bits[bit], assignment);
        value = 2 * value + (on ? (sign ? -1 : 1) : 0);
    }
    return value;
}

Bdd within(const BddTerm& term, std::int64_t low, std::int64_t high) {
    if (term.boolean) return ~term.undefined;
    const Bdd outside = bdd::less(term.bits, bdd::constant(low)) | bdd::less(bdd::constant(high), term.bits);
    return ~(outside | term.undefined);
}

BddTerm conditional(const BddTerm& condition, const BddTerm& then, const BddTerm& otherwise) {
    assert(condition.boolean && then.boolean == otherwise.boolean);
    const Bdd& chosen = condition.bits.front();
    return {then.boolean, bdd::choice(chosen, then.bits, otherwise.bits),
            condition.undefined | ite(chosen, then.undefined, otherwise.undefined)};
}

namespace {

/// And, Or: the operands after the first that decides are not looked at.
BddTerm joined(bool disjunction, std::span<const BddTerm* const> operands) {
    Bdd value = Bdd::constant(!disjunction), undefined;
    for (const BddTerm* operand : operands) {
        const Bdd looked_at = disjunction ? ~value : value;
        if (!operand->undefined.is_false()) undefined |= looked_at & operand->undefined;
        value = disjunction ? value | operand->bits.front() : value & operand->bits.front();
    }
    return {true, {value}, undefined};
}

BddTerm compared(Op op, const BddTerm& left, const BddTerm& right) {
    const auto with = [&](const Bdd& value) { return BddTerm{true, {value}, left.undefined | right.undefined}; };
    switch (op) {
    case Op::Equal: return with(bdd::equal(left.bits, right.bits));
    case Op::NotEqual: return with(~bdd::equal(left.bits, right.bits));
    case Op::Less: return with(bdd::less(left.bits, right.bits));
    case Op::LessEqual: return with(~bdd::less(right.bits, left.bits));
    case Op::Greater: return with(bdd::less(right.bits, left.bits));
    case Op::GreaterEqual: return with(~bdd::less(left.bits, right.bits));
    default: unreachable();
    }
}

BddTerm calculated(Op op, const BddTerm& left, const BddTerm& right) {
    Bdd undefined = left.undefined | right.undefined;
    bdd::Integer result;
    switch (op) {
    case Op::Plus: result = bdd::sum(left.bits, right.bits); break;
    case Op::Minus: result = bdd::difference(left.bits, right.bits); break;
    case Op::Times: result = bdd::product(left.bits, right.bits); break;
    case Op::Divide:
    case Op::Modulo: {
        undefined |= bdd::is_zero(right.bits);
        // Like the processor, `evaluate` gives the least number divided by -1 no value, and no remainder either.
        undefined |= bdd::equal(left.bits, bdd::constant(std::numeric_limits<std::int64_t>::min())) &
                     bdd::equal(right.bits, bdd::constant(-1));
        bdd::Division both = bdd::division(left.bits, right.bits);
        result = op == Op::Divide ? std::move(both.quotient) : std::move(both.remainder);
        break;
    }
    default: unreachable();
    }
    undefined |= bdd::cut_to_64_bits(result);
    return {false, std::move(result), undefined};
}

BddTerm negative(const BddTerm& operand) {
    bdd::Integer result = bdd::negated(operand.bits);
    const Bdd undefined = operand.undefined | bdd::cut_to_64_bits(result);
    return {false, std::move(result), undefined};
}

}  // namespace

BddTerms::BddTerms(const Exprs& exprs, std::function<BddTerm(const Expr&)> leaf)
    : exprs_(exprs), leaf_(std::move(leaf)) {}

const BddTerm& BddTerms::operator()(Id<Expr> term) {
    std::vector<Id<Expr>> open{term};  // no recursion: terms are as deep as their author likes
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

BddTerm BddTerms::built(Id<Expr> term) const {
    const Expr& node = exprs_[term];
    std::vector<const BddTerm*> operands;
    for (const Id<Expr> operand : exprs_.operands(term)) operands.push_back(&known_.at(operand.index));
    switch (node.op) {
    case Op::False:
    case Op::True: return bdd_boolean(Bdd::constant(node.op == Op::True));
    case Op::Integer:
    case Op::Duration: return bdd_integer(node.value);
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
    case Op::Fall: unreachable();  // edges are gone once a chart is derived
    }
    unreachable();
}

}  // namespace grafverif
