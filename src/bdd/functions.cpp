// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cassert>

#include "bdd/space.hpp"

namespace grafverif {

using bdd::guarded;

Bdd operator~(const Bdd& f) { return guarded([&] { return ::bdd_not(f.node()); }); }

namespace {

Bdd apply(const Bdd& f, const Bdd& g, int operation) {
    return guarded([&] { return ::bdd_apply(f.node(), g.node(), operation); });
}

}  // namespace

Bdd operator&(const Bdd& f, const Bdd& g) { return apply(f, g, bddop_and); }
Bdd operator|(const Bdd& f, const Bdd& g) { return apply(f, g, bddop_or); }
Bdd operator^(const Bdd& f, const Bdd& g) { return apply(f, g, bddop_xor); }
Bdd implies(const Bdd& f, const Bdd& g) { return apply(f, g, bddop_imp); }
Bdd iff(const Bdd& f, const Bdd& g) { return apply(f, g, bddop_biimp); }

Bdd ite(const Bdd& condition, const Bdd& then, const Bdd& otherwise) {
    return guarded([&] { return ::bdd_ite(condition.node(), then.node(), otherwise.node()); });
}

Bdd cube(std::span<const BddLiteral> literals) {
    std::vector<BddLiteral> sorted(literals.begin(), literals.end());
    std::ranges::sort(sorted, std::ranges::greater{}, &BddLiteral::variable);
    Bdd result = Bdd::constant(true);   // from the bottom up, so that each step adds one node
    for (const BddLiteral& literal : sorted) {
        const int variable = static_cast<int>(literal.variable);
        const int node = literal.value ? ::bdd_ithvar(variable) : ::bdd_nithvar(variable);
        result = guarded([&] { return ::bdd_apply(node, result.node(), bddop_and); });
    }
    return result;
}

Bdd variable_set(std::span<const std::uint32_t> variables) {
    std::vector<BddLiteral> literals;
    literals.reserve(variables.size());
    for (const std::uint32_t variable : variables) literals.push_back({variable, true});
    return cube(literals);
}

Bdd exists(const Bdd& f, const Bdd& variables) {
    return guarded([&] { return ::bdd_exist(f.node(), variables.node()); });
}

Bdd forall(const Bdd& f, const Bdd& variables) {
    return guarded([&] { return ::bdd_forall(f.node(), variables.node()); });
}

Bdd and_exists(const Bdd& f, const Bdd& g, const Bdd& variables) {
    return guarded([&] { return ::bdd_appex(f.node(), g.node(), bddop_and, variables.node()); });
}

Bdd cofactor(const Bdd& f, const Bdd& cube) {
    return guarded([&] { return ::bdd_restrict(f.node(), cube.node()); });
}

Bdd simplify(const Bdd& f, const Bdd& care) {
    assert(!care.is_false());
    return guarded([&] { return ::bdd_simplify(f.node(), care.node()); });
}

namespace {

bddPair* new_pairs() {
    bddPair* const pairs = ::bdd_newpair();
    if (pairs == nullptr) throw BddExhausted(BddExhausted::Cause::Memory);
    return pairs;
}

}  // namespace

BddRenaming::BddRenaming(std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs) : pairs_(new_pairs()) {
    for (const auto& [from, to] : pairs)
        ::bdd_setpair(bdd::pairs_of(pairs_), static_cast<int>(from), static_cast<int>(to));
}

BddRenaming::~BddRenaming() { ::bdd_freepair(bdd::pairs_of(pairs_)); }

Bdd BddRenaming::operator()(const Bdd& f) const {
    return guarded([&] { return ::bdd_replace(f.node(), bdd::pairs_of(pairs_)); });
}

BddSubstitution::BddSubstitution(std::span<const std::pair<std::uint32_t, Bdd>> values) : pairs_(new_pairs()) {
    for (const auto& [variable, value] : values)
        ::bdd_setbddpair(bdd::pairs_of(pairs_), static_cast<int>(variable), value.node());
}

BddSubstitution::~BddSubstitution() { ::bdd_freepair(bdd::pairs_of(pairs_)); }

Bdd BddSubstitution::operator()(const Bdd& f) const {
    return guarded([&] { return ::bdd_veccompose(f.node(), bdd::pairs_of(pairs_)); });
}

}  // namespace grafverif
