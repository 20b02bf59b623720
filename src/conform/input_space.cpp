// SPDX-License-Identifier: MIT
#include "conform/input_space.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "support/messages.hpp"

namespace grafverif::conform {

Diagnostic limit_reached(const BddExhausted& exhausted, Span origin, const std::atomic<bool>* stop) {
    return exhausted.cause() == BddExhausted::Cause::Memory
               ? messages::automaton_too_large(origin)
               : messages::stopped(origin, stop != nullptr && stop->load());
}

InputSpace::InputSpace(std::vector<NamedInput> inputs, const BddLimits& limits)
    : named_(std::move(inputs)), space_(limits) {
    for (const NamedInput& input : named_) {
        BddWord word{input.type, {}};
        const std::size_t count = bit_count(input.type);
        const std::uint32_t first = space_.add_variables(count);
        for (std::size_t place = count; place-- > 0;) word.bits.push_back(first + static_cast<std::uint32_t>(place));
        for (std::size_t place = 0; place < count; ++place) bits_.push_back(first + static_cast<std::uint32_t>(place));
        words_.push_back(std::move(word));
    }
    for (const BddWord& word : words_)
        if (!word.type.boolean) assumed_ &= in_range(space_, word);
}

std::vector<bool> InputSpace::assignment(const Bdd& set) const {
    std::vector<bool> assignment(space_.variables());
    const std::optional<std::vector<BddLiteral>> literals = one_cube(set);
    for (const BddLiteral literal : *literals) assignment[literal.variable] = literal.value;
    return assignment;
}

std::vector<std::int64_t> InputSpace::witness(const Bdd& set) const {
    const std::vector<bool> found = assignment(set);
    std::vector<std::int64_t> values;
    for (const BddWord& word : words_) values.push_back(value_of(word, found));
    return values;
}

std::string InputSpace::witness_text(const Bdd& set) const {
    const std::vector<std::int64_t> values = witness(set);
    std::string text;
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (!text.empty()) text += ", ";
        if (!named_[k].type.boolean) text += named_[k].name + " = " + std::to_string(values[k]);
        else text += values[k] != 0 ? named_[k].name : "not " + named_[k].name;
    }
    return text;
}

Id<Expr> Conditions::term(const Bdd& function) {
    if (function.is_constant()) return exprs_.constant(function.is_true());
    if (const auto found = known_.find(function); found != known_.end()) return found->second;
    const Id<Expr> result = written(function);
    known_.emplace(function, result);
    return result;
}

Id<Expr> Conditions::written(const Bdd& function) {
    const std::vector<std::uint32_t> used = support(function);
    for (std::size_t input = 0; input < space_.inputs(); ++input) {
        const BddWord& word = space_.word(input);
        const bool read =
            std::ranges::any_of(word.bits, [&](std::uint32_t bit) { return std::ranges::binary_search(used, bit); });
        if (!word.type.boolean && read) return by_values(function, input);
    }
    return sum_of_products(function);
}

/// Returns `function` as a disjunction of cases, one for each value of the integer input `input`. Values for which the
/// remaining function is equal are merged.
Id<Expr> Conditions::by_values(const Bdd& function, std::size_t input) {
    struct Case {
        Bdd rest = {};
        std::vector<std::int64_t> values = {};
    };
    const BddWord& word = space_.word(input);
    std::vector<Case> cases;
    for (std::int64_t value = word.type.low; value <= word.type.high; ++value) {
        const Bdd rest = cofactor(function, equals(space_.space(), word, value));
        const auto found = std::ranges::find(cases, rest, &Case::rest);
        if (found != cases.end()) found->values.push_back(value);
        else cases.push_back({rest, {value}});
    }
    std::vector<Id<Expr>> terms;
    for (const Case& one : cases)
        if (!one.rest.is_false()) terms.push_back(exprs_.conjunction(one_of(input, one.values), term(one.rest)));
    return exprs_.disjunction(terms);
}

/// Returns the condition that the input has one of `values`, as a disjunction of intervals. `values` must be
/// increasing.
Id<Expr> Conditions::one_of(std::size_t input, const std::vector<std::int64_t>& values) {
    const Type type = space_.word(input).type;
    const Id<Expr> leaf = exprs_.leaf(Op::Variable, static_cast<std::uint32_t>(input));
    std::vector<Id<Expr>> intervals;
    for (std::size_t first = 0; first < values.size();) {
        std::size_t last = first;
        while (last + 1 < values.size() && values[last + 1] == values[last] + 1) ++last;
        const std::int64_t low = values[first], high = values[last];
        const Id<Expr> above =
            low == type.low ? exprs_.constant(true) : exprs_.apply(Op::GreaterEqual, leaf, exprs_.integer(low));
        const Id<Expr> below =
            high == type.high ? exprs_.constant(true) : exprs_.apply(Op::LessEqual, leaf, exprs_.integer(high));
        intervals.push_back(low == high ? exprs_.apply(Op::Equal, leaf, exprs_.integer(low))
                                        : exprs_.conjunction(above, below));
        first = last + 1;
    }
    return exprs_.disjunction(intervals);
}

Id<Expr> Conditions::sum_of_products(const Bdd& function) {
    const Bdd& care = space_.assumed();
    const bool boolean = std::ranges::all_of(support(care), [&](std::uint32_t bit) {
        for (std::size_t input = 0; input < space_.inputs(); ++input)
            if (!space_.word(input).type.boolean &&
                std::ranges::find(space_.word(input).bits, bit) != space_.word(input).bits.end())
                return false;
        return true;
    });
    const Cover found = boolean ? cover(function & care, function | ~care) : cover(function, function);
    std::vector<std::uint32_t> input_of(space_.space().variables());
    for (std::size_t input = 0; input < space_.inputs(); ++input)
        for (const std::uint32_t bit : space_.word(input).bits) input_of[bit] = static_cast<std::uint32_t>(input);
    std::vector<Id<Expr>> products;
    for (const std::vector<BddLiteral>& cube : found.cubes) {
        std::vector<Id<Expr>> literals;
        for (const BddLiteral literal : cube) {
            const Id<Expr> leaf = exprs_.leaf(Op::Variable, input_of[literal.variable]);
            literals.push_back(literal.value ? leaf : exprs_.negation(leaf));
        }
        products.push_back(exprs_.conjunction(literals));
    }
    return exprs_.disjunction(products);
}

/// Returns an irredundant sum of products that `least` implies and that implies `most` (Minato 1993, ISOP). The
/// recursion depth is at most the number of variables. The variables are in the order of their indices, because these
/// spaces are not reordered.
Conditions::Cover Conditions::cover(const Bdd& least, const Bdd& most) {
    if (least.is_false()) return {};
    if (most.is_true()) return {{{}}, Bdd::constant(true)};
    const std::uint32_t variable = std::min(least.is_constant() ? most.top() : least.top(), most.top());
    const auto branch = [&](const Bdd& f, bool value) {
        if (f.is_constant() || f.top() != variable) return f;
        return value ? f.high() : f.low();
    };
    const Bdd least0 = branch(least, false), least1 = branch(least, true);
    const Bdd most0 = branch(most, false), most1 = branch(most, true);
    Cover off = cover(least0 & ~most1, most0);
    Cover on = cover(least1 & ~most0, most1);
    Cover either = cover((least0 & ~off.function) | (least1 & ~on.function), most0 & most1);
    Cover result;
    result.function =
        ite(space_.space().variable(variable), on.function | either.function, off.function | either.function);
    for (std::vector<BddLiteral>& product : on.cubes) {
        product.insert(product.begin(), {variable, true});
        result.cubes.push_back(std::move(product));
    }
    for (std::vector<BddLiteral>& product : off.cubes) {
        product.insert(product.begin(), {variable, false});
        result.cubes.push_back(std::move(product));
    }
    for (std::vector<BddLiteral>& product : either.cubes) result.cubes.push_back(std::move(product));
    return result;
}

}  // namespace grafverif::conform
