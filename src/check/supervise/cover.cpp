// SPDX-License-Identifier: MIT
#include "check/supervise/cover.hpp"

#include <algorithm>
#include <utility>

namespace grafverif::supervise {

namespace {

using Products = std::vector<std::vector<BddLiteral>>;

struct Irredundant {
    Products products = {};
    Bdd function = {};
};

/// Computes a sum of products f such that `low` implies f and f implies `high` (Minato 1992, "Fast generation of
/// irredundant sum-of-products forms from binary decision diagrams"). The recursion depth is at most the number of
/// variables.
class Generator {
public:
    Generator(const BddSpace& space, std::size_t most) : space_(space), most_(most) {}

    Irredundant operator()(const Bdd& low, const Bdd& high) {
        if (low.is_false() || overflown_) return {};
        if (high.is_true()) {
            overflown_ = ++made_ > most_;
            return {{{}}, Bdd::constant(true)};
        }
        const std::uint32_t variable = topmost(low, high);
        const auto half = [&](const Bdd& f, bool value) {
            const BddLiteral literal{variable, value};
            return cofactor(f, cube(space_, {&literal, 1}));
        };
        const Bdd low0 = half(low, false), low1 = half(low, true), high0 = half(high, false), high1 = half(high, true);
        Irredundant without = (*this)(low0 & ~high1, high0), with = (*this)(low1 & ~high0, high1);
        Irredundant either = (*this)((low0 & ~without.function) | (low1 & ~with.function), high0 & high1);
        const Bdd here = space_.variable(variable);
        Irredundant all{std::move(either.products),
                        either.function | (here & with.function) | (~here & without.function)};
        for (auto [some, value] : {std::pair(&without, false), std::pair(&with, true)})
            for (std::vector<BddLiteral>& product : some->products) {
                product.push_back({variable, value});
                all.products.push_back(std::move(product));
            }
        return all;
    }
    bool overflown() const { return overflown_; }

private:
    static std::uint32_t topmost(const Bdd& f, const Bdd& g) {
        if (f.is_constant()) return g.top();
        return g.is_constant() ? f.top() : std::min(f.top(), g.top());
    }

    const BddSpace& space_;
    std::size_t most_ = 0, made_ = 0;
    bool overflown_ = false;
};

std::size_t length(const Products& products) {
    std::size_t literals = products.size();
    for (const auto& product : products) literals += product.size();
    return literals;
}

}  // namespace

std::optional<Cover> cover(const BddSpace& space, Bdd on, Bdd off, std::span<const std::uint32_t> variables,
                           std::size_t most) {
    for (const std::uint32_t variable : variables) {
        const Bdd here = space.variable(variable);
        const Bdd wider_on = exists(on, here), wider_off = exists(off, here);
        if (!(wider_on & wider_off).is_false()) continue;
        on = wider_on;
        off = wider_off;
    }
    Generator yes(space, most), no(space, most);
    Cover straight{yes(on, ~off).products, false}, negated{no(off, ~on).products, true};
    if (yes.overflown() && no.overflown()) return {};
    const bool negate = yes.overflown() || (!no.overflown() && length(negated.products) < length(straight.products));
    Cover& best = negate ? negated : straight;
    for (std::vector<BddLiteral>& product : best.products) std::ranges::sort(product, {}, &BddLiteral::variable);
    std::ranges::sort(best.products, [](const auto& left, const auto& right) {
        return std::ranges::lexicographical_compare(left, right, {}, &BddLiteral::variable, &BddLiteral::variable);
    });
    return std::move(best);
}

}  // namespace grafverif::supervise
