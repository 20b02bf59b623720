// SPDX-License-Identifier: MIT
// Represents the inputs of a chart as variables of decision diagrams, and functions of inputs as readable terms.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "bdd/bdd.hpp"
#include "bdd/terms.hpp"
#include "grafverif/ir/expr.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif::conform {

/// Returns the error message for a search that ended because of the memory limit of decision diagrams, the deadline or
/// the flag `stop`.
Diagnostic limit_reached(const BddExhausted& exhausted, Span origin, const std::atomic<bool>* stop);

/// Throws BddExhausted if the deadline has passed or the stop flag is set.
template <class Options>
void stop_if_requested(const Options& options) {
    const bool late = options.deadline && std::chrono::steady_clock::now() >= *options.deadline;
    if (late || (options.stop != nullptr && options.stop->load())) throw BddExhausted(BddExhausted::Cause::Stopped);
}

struct NamedInput {
    std::string name = {};
    Type type = {};
};

template <class Inputs>
std::vector<NamedInput> named(const Inputs& inputs) {
    std::vector<NamedInput> all;
    for (const auto& input : inputs) all.push_back({input.name, input.type});
    return all;
}

/// InputSpace: represents the inputs of a chart by variables of decision diagrams. Input k is represented by word k.
/// The bits of a word are adjacent in the variable order, and the most significant bit is the topmost bit.
class InputSpace {
public:
    InputSpace(std::vector<NamedInput> inputs, const BddLimits& limits);

    std::size_t inputs() const { return words_.size(); }
    BddTerm term(std::size_t input) const { return term_of(space_, words_[input]); }
    const BddWord& word(std::size_t input) const { return words_[input]; }
    const std::vector<std::uint32_t>& bits() const { return bits_; }
    const BddSpace& space() const { return space_; }

    /// Returns the considered input combinations: all combinations of values within the ranges of the inputs that
    /// satisfy the conditions passed to `assume`.
    const Bdd& assumed() const { return assumed_; }
    void assume(const Bdd& condition) { assumed_ &= condition; }

    /// Returns an assignment to all variables of the space for which `set` is true. Requires that `set` is not false.
    std::vector<bool> assignment(const Bdd& set) const;
    /// Returns an input combination (one value per input) for which `set` is true. Requires that `set` is not false.
    std::vector<std::int64_t> witness(const Bdd& set) const;
    /// Returns `witness(set)` as text, such as `s, not h1, level = 3`.
    std::string witness_text(const Bdd& set) const;

private:
    std::vector<NamedInput> named_;
    BddSpace space_;
    std::vector<BddWord> words_ = {};
    std::vector<std::uint32_t> bits_ = {};  ///< bits of all inputs
    Bdd assumed_ = Bdd::constant(true);
};

/// Translates Boolean terms whose Variable leaves are inputs to sets of input combinations.
class InputSets {
public:
    /// `exprs` and `space` must outlive this object.
    InputSets(const Exprs& exprs, const InputSpace& space)
        : terms_(exprs, [&space](const Expr& leaf) { return space.term(static_cast<std::size_t>(leaf.value)); }) {}

    /// Returns the input combinations for which the term is defined and true.
    Bdd operator()(Id<Expr> term) {
        const BddTerm& found = terms_(term);
        return found.bits.front() & ~found.undefined;
    }

private:
    BddTerms terms_;
};

/// Translates functions of inputs to terms of an Exprs whose Variable leaves are the inputs. Each term is an
/// irredundant sum of products (Minato 1993), and has the same value as the function for all assumed inputs. A function
/// that occurs several times is translated only once.
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
