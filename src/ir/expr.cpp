// SPDX-License-Identifier: MIT
#include "grafverif/ir/expr.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <initializer_list>
#include <unordered_set>

#include "ir/integer_operators.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

namespace {

std::size_t hash_of(Op op, std::int64_t value, std::span<const Id<Expr>> operands) {
    std::uint64_t hash = 0x9E3779B97F4A7C15ULL ^ static_cast<std::uint64_t>(op);
    const auto mix = [&hash](std::uint64_t part) {
        hash ^= part + 0x9E3779B97F4A7C15ULL + (hash << 6U) + (hash >> 2U);
        hash *= 0xFF51AFD7ED558CCDULL;
        hash ^= hash >> 32U;
    };
    mix(static_cast<std::uint64_t>(value));
    for (const Id<Expr> operand : operands) mix(operand.index);
    return static_cast<std::size_t>(hash);
}

}  // namespace

std::optional<std::int64_t> combine(Op op, std::int64_t left, std::int64_t right) {
    std::int64_t result = 0;
    switch (op) {
    case Op::Equal: return left == right;
    case Op::NotEqual: return left != right;
    case Op::Less: return left < right;
    case Op::LessEqual: return left <= right;
    case Op::Greater: return left > right;
    case Op::GreaterEqual: return left >= right;
    case Op::Plus:
        if (__builtin_add_overflow(left, right, &result)) return {};
        return result;
    case Op::Minus:
        if (__builtin_sub_overflow(left, right, &result)) return {};
        return result;
    case Op::Times:
        if (__builtin_mul_overflow(left, right, &result)) return {};
        return result;
    case Op::Divide:
        if (right == 0 || (right == -1 && left == INT64_MIN)) return {};
        return left / right;
    case Op::Modulo:
        if (right == 0 || (right == -1 && left == INT64_MIN)) return {};
        return left % right;
    case Op::False:
    case Op::True:
    case Op::Integer:
    case Op::Duration:
    case Op::Variable:
    case Op::Step:
    case Op::Timed:
    case Op::Parameter:
    case Op::At:
    case Op::Not:
    case Op::And:
    case Op::Or:
    case Op::Rise:
    case Op::Fall:
    case Op::Negate:
    case Op::Conditional: break;
    }
    unreachable();
}

bool is_constant(Op op) { return op <= Op::Duration; }
bool is_leaf(Op op) { return op >= Op::Variable && op <= Op::At; }
bool is_comparison(Op op) { return op >= Op::Equal && op <= Op::GreaterEqual; }
bool is_arithmetic(Op op) { return op >= Op::Negate && op <= Op::Modulo; }
bool is_true(const Exprs& exprs, Id<Expr> id) { return exprs[id].op == Op::True; }
bool is_false(const Exprs& exprs, Id<Expr> id) { return exprs[id].op == Op::False; }

std::uint32_t at_process(const Expr& node) {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(node.value) >> 32U);
}
std::uint32_t at_location(const Expr& node) {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(node.value));
}

bool Exprs::operator==(const Exprs& other) const {
    if (nodes_.size() != other.nodes_.size() || operands_ != other.operands_) return false;
    return std::ranges::equal(nodes_, other.nodes_, [](const Expr& left, const Expr& right) {
        return left.op == right.op && left.value == right.value && left.first == right.first &&
               left.count == right.count;
    });
}

void Exprs::grow() {
    slots_.assign(std::max<std::size_t>(64, slots_.size() * 2), 0);
    for (std::uint32_t index = 0; index < nodes_.size(); ++index) {
        const Expr& node = nodes_[index];
        std::size_t slot = hash_of(node.op, node.value, operands(Id<Expr>{index})) & (slots_.size() - 1);
        while (slots_[slot] != 0) slot = (slot + 1) & (slots_.size() - 1);
        slots_[slot] = index + 1;
    }
}

Id<Expr> Exprs::intern(Op op, std::int64_t value, std::span<const Id<Expr>> operands) {
    if (2 * (nodes_.size() + 1) > slots_.size()) grow();
    std::size_t slot = hash_of(op, value, operands) & (slots_.size() - 1);
    for (; slots_[slot] != 0; slot = (slot + 1) & (slots_.size() - 1)) {
        const Id<Expr> found{slots_[slot] - 1};
        const Expr& node = nodes_[found.index];
        if (node.op == op && node.value == value && std::ranges::equal(this->operands(found), operands)) return found;
    }
    const Expr node{op, value, static_cast<std::uint32_t>(operands_.size()),
                    static_cast<std::uint32_t>(operands.size())};
    // `operands` may be a view into operands_, which is invalidated when operands_ grows.
    const std::vector<Id<Expr>> copy(operands.begin(), operands.end());
    operands_.insert(operands_.end(), copy.begin(), copy.end());
    nodes_.push_back(node);
    slots_[slot] = static_cast<std::uint32_t>(nodes_.size());
    return Id<Expr>{static_cast<std::uint32_t>(nodes_.size() - 1)};
}

Id<Expr> Exprs::constant(bool value) { return intern(value ? Op::True : Op::False, 0, {}); }
Id<Expr> Exprs::integer(std::int64_t value) { return intern(Op::Integer, value, {}); }
Id<Expr> Exprs::duration(std::int64_t milliseconds) { return intern(Op::Duration, milliseconds, {}); }

Id<Expr> Exprs::leaf(Op op, std::uint32_t index) {
    assert(is_leaf(op) && op != Op::At);
    return intern(op, index, {});
}

Id<Expr> Exprs::at(std::uint32_t process, std::uint32_t location) {
    return intern(Op::At, static_cast<std::int64_t>((static_cast<std::uint64_t>(process) << 32U) | location), {});
}

Id<Expr> Exprs::negation(Id<Expr> operand) {
    const Op op = nodes_[operand.index].op;
    if (op == Op::True || op == Op::False) return constant(op == Op::False);
    if (op == Op::Not) return operands(operand)[0];
    return intern(Op::Not, 0, std::array{operand});
}

Id<Expr> Exprs::conjunction(Id<Expr> left, Id<Expr> right) { return conjunction(std::array{left, right}); }
Id<Expr> Exprs::disjunction(Id<Expr> left, Id<Expr> right) { return disjunction(std::array{left, right}); }

namespace {

/// Returns the operands of an And or Or in order. Nested operands of the same operator are flattened; neutral and
/// repeated operands are removed. The result is empty if one operand determines the value of the term (`false` for And,
/// `true` for Or).
std::optional<std::vector<Id<Expr>>> flattened(const Exprs& exprs, Op op, std::span<const Id<Expr>> operands) {
    const Op neutral = op == Op::And ? Op::True : Op::False;
    const Op absorbing = op == Op::And ? Op::False : Op::True;
    std::vector<Id<Expr>> flat;
    flat.reserve(operands.size());
    bool absorbed = false;
    const auto take = [&](Id<Expr> operand) {
        const Op kind = exprs[operand].op;
        absorbed = absorbed || kind == absorbing;
        if (kind != neutral) flat.push_back(operand);
    };
    for (const Id<Expr> operand : operands) {
        if (exprs[operand].op != op) take(operand);
        else
            for (const Id<Expr> inner : exprs.operands(operand)) take(inner);
    }
    if (absorbed) return {};
    if (flat.size() == 2 && flat[0] == flat[1]) flat.pop_back();
    if (flat.size() <= 2) return flat;

    std::vector<std::size_t> order(flat.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(flat[i].index, i); });
    std::vector<bool> repeated(flat.size());
    for (std::size_t i = 1; i < order.size(); ++i) repeated[order[i]] = flat[order[i]] == flat[order[i - 1]];
    std::vector<Id<Expr>> distinct;
    for (std::size_t i = 0; i < flat.size(); ++i)
        if (!repeated[i]) distinct.push_back(flat[i]);
    return distinct;
}

}  // namespace

Id<Expr> Exprs::conjunction(std::span<const Id<Expr>> operands) {
    const auto flat = flattened(*this, Op::And, operands);
    if (!flat) return constant(false);
    if (flat->empty()) return constant(true);
    return flat->size() == 1 ? flat->front() : intern(Op::And, 0, *flat);
}

Id<Expr> Exprs::disjunction(std::span<const Id<Expr>> operands) {
    const auto flat = flattened(*this, Op::Or, operands);
    if (!flat) return constant(true);
    if (flat->empty()) return constant(false);
    return flat->size() == 1 ? flat->front() : intern(Op::Or, 0, *flat);
}

Id<Expr> Exprs::conditional(Id<Expr> condition, Id<Expr> then, Id<Expr> otherwise) {
    if (is_true(*this, condition) || then == otherwise) return then;
    if (is_false(*this, condition)) return otherwise;
    return intern(Op::Conditional, 0, std::array{condition, then, otherwise});
}

Id<Expr> Exprs::apply(Op op, Id<Expr> left, Id<Expr> right) { return apply(op, std::array{left, right}); }

Id<Expr> Exprs::apply(Op op, std::span<const Id<Expr>> operands) {
    if (op == Op::And) return conjunction(operands);
    if (op == Op::Or) return disjunction(operands);
    if (op == Op::Not) return negation(operands[0]);
    if (op == Op::Conditional) return conditional(operands[0], operands[1], operands[2]);
    const auto number = [this](Id<Expr> id) -> std::optional<std::int64_t> {
        const Expr& node = nodes_[id.index];
        if (node.op == Op::Integer) return node.value;
        if (node.op == Op::True || node.op == Op::False) return node.op == Op::True;
        return {};
    };
    if (op == Op::Negate) {
        const auto value = number(operands[0]);
        if (value && *value != INT64_MIN) return integer(-*value);
    }
    if (is_comparison(op) || (is_arithmetic(op) && op != Op::Negate)) {
        const auto left = number(operands[0]);
        const auto right = number(operands[1]);
        const auto value = left && right ? combine(op, *left, *right) : std::nullopt;
        if (value) return is_comparison(op) ? constant(*value != 0) : integer(*value);
    }
    if (op == Op::Equal || op == Op::NotEqual)
        for (const auto& [truth, other] : {std::pair(operands[1], operands[0]), std::pair(operands[0], operands[1])})
            if (is_true(*this, truth) || is_false(*this, truth))
                return is_true(*this, truth) == (op == Op::Equal) ? other : negation(other);
    return intern(op, 0, operands);
}

namespace {

/// Returns the value of a term. `value(i)` returns the value of operand i.
template <class Value>
std::optional<std::int64_t> value_of(const Exprs& exprs, Id<Expr> root,
                                     const std::function<std::int64_t(const Expr&)>& leaf, const Value& value) {
    const Expr& node = exprs[root];
    switch (node.op) {
    case Op::False: return 0;
    case Op::True: return 1;
    case Op::Integer:
    case Op::Duration: return node.value;
    case Op::Variable:
    case Op::Step:
    case Op::Timed:
    case Op::Parameter:
    case Op::At:
    case Op::Rise:
    case Op::Fall: return leaf(node);
    case Op::Not: {
        const auto operand = value(0);
        return operand ? std::optional<std::int64_t>(*operand == 0) : std::nullopt;
    }
    case Op::And:
    case Op::Or: {
        const bool absorbing = node.op == Op::Or;
        for (std::size_t i = 0; i < node.count; ++i) {
            const auto operand = value(i);
            if (!operand) return {};
            if ((*operand != 0) == absorbing) return absorbing;
        }
        return !absorbing;
    }
    case Op::Negate: {
        const auto operand = value(0);
        if (!operand || *operand == INT64_MIN) return {};
        return -*operand;
    }
    case Op::Conditional: {
        const auto condition = value(0);
        if (!condition) return {};
        return value(*condition != 0 ? 1 : 2);
    }
    case Op::Equal:
    case Op::NotEqual:
    case Op::Less:
    case Op::LessEqual:
    case Op::Greater:
    case Op::GreaterEqual:
    case Op::Plus:
    case Op::Minus:
    case Op::Times:
    case Op::Divide:
    case Op::Modulo: {
        const auto left = value(0);
        const auto right = value(1);
        return left && right ? combine(node.op, *left, *right) : std::nullopt;
    }
    }
    unreachable();
}

}  // namespace

std::optional<std::int64_t> evaluate(const Exprs& exprs, Id<Expr> root,
                                     const std::function<std::int64_t(const Expr&)>& leaf) {
    const std::span<const Id<Expr>> operands = exprs.operands(root);
    return value_of(exprs, root, leaf, [&](std::size_t i) { return evaluate(exprs, operands[i], leaf); });
}

std::vector<std::optional<std::int64_t>> evaluate_all(const Exprs& exprs,
                                                      const std::function<std::int64_t(const Expr&)>& leaf) {
    std::vector<std::optional<std::int64_t>> values;
    values.reserve(exprs.size());
    for (std::uint32_t index = 0; index < exprs.size(); ++index) {
        const std::span<const Id<Expr>> operands = exprs.operands({index});
        values.push_back(value_of(exprs, {index}, leaf, [&](std::size_t i) { return values[operands[i].index]; }));
    }
    return values;
}

// Two traversals of terms: the first copies a term into another table, and the second finds the leaves of a term. Each
// traversal visits a shared subterm only once.

namespace {

void collect(const Exprs& exprs, Id<Expr> root, std::unordered_set<std::uint32_t>& seen, std::vector<Id<Expr>>& found) {
    const Expr& node = exprs[root];
    if (is_constant(node.op) || !seen.insert(root.index).second) return;
    if (is_leaf(node.op)) found.push_back(root);
    for (const Id<Expr> operand : exprs.operands(root)) collect(exprs, operand, seen, found);
}

}  // namespace

Id<Expr> TermCopier::operator()(Id<Expr> root) {
    const Expr node = (*from_)[root];  // copied, because `to` may be `from`, and its nodes move when the table grows
    if (node.op == Op::False || node.op == Op::True) return to_->constant(node.op == Op::True);
    if (node.op == Op::Integer) return to_->integer(node.value);
    if (const auto known = copies_.find(root.index); known != copies_.end()) return known->second;
    std::vector<Id<Expr>> operands(from_->operands(root).begin(), from_->operands(root).end());
    for (Id<Expr>& operand : operands) operand = (*this)(operand);
    const bool is_edge = edge_ && (node.op == Op::Rise || node.op == Op::Fall);
    const Id<Expr> result = operands.empty() ? leaf_(node)
                            : is_edge        ? edge_(node.op, operands[0])
                                             : to_->apply(node.op, operands);
    copies_.emplace(root.index, result);
    return result;
}

Id<Expr> translate(const Exprs& from, Id<Expr> root, Exprs& to, const std::function<Id<Expr>(const Expr&)>& leaf) {
    return TermCopier(from, to, [&](const Expr& node) {
        return node.op == Op::Duration ? to.duration(node.value) : leaf(node);
    })(root);
}

std::vector<Id<Expr>> leaves(const Exprs& exprs, Id<Expr> root) {
    std::unordered_set<std::uint32_t> seen;
    std::vector<Id<Expr>> found;
    collect(exprs, root, seen, found);
    return found;
}

}  // namespace grafverif
