// SPDX-License-Identifier: MIT
// Implements the public operations. Each function handles terminal cases first, so that operations on constants do not
// need a space.
#include <algorithm>
#include <cassert>

#include "bdd/kernel.hpp"

namespace grafverif {

namespace {

using bdd::Edge;
using bdd::Kernel;

/// Returns the kernel of the operands, or null if all operands are constants.
Kernel* kernel_of(std::initializer_list<const Bdd*> operands) {
    Kernel* kernel = nullptr;
    for (const Bdd* operand : operands) {
        assert(kernel == nullptr || operand->kernel() == nullptr || kernel == operand->kernel());
        if (operand->kernel() != nullptr) kernel = operand->kernel();
    }
    return kernel;
}

/// Executes the operation `work`, which creates nodes, and returns a handle of its result.
template <class Work>
Bdd result_of(Kernel* kernel, const Work& work) {
    assert(kernel != nullptr);
    const bdd::Session session(*kernel);
    return {*kernel, work(*kernel)};
}

Bdd conjunction_of(const Bdd& f, const Bdd& g, Edge flip_f, Edge flip_g) {
    const Edge a = f.edge() ^ flip_f, b = g.edge() ^ flip_g;
    Kernel* const kernel = kernel_of({&f, &g});
    if (kernel == nullptr) return Bdd::constant((a & b) != 0);
    return result_of(kernel, [&](Kernel& k) { return bdd::conjunction(k, a, b); });
}

}  // namespace

Bdd operator~(const Bdd& f) {
    if (f.is_constant()) return Bdd::constant(f.is_false());
    return {*f.kernel(), f.edge() ^ 1U};
}

Bdd operator&(const Bdd& f, const Bdd& g) { return conjunction_of(f, g, 0, 0); }
Bdd operator|(const Bdd& f, const Bdd& g) { return ~conjunction_of(f, g, 1, 1); }
Bdd implies(const Bdd& f, const Bdd& g) { return ~conjunction_of(f, g, 0, 1); }
Bdd iff(const Bdd& f, const Bdd& g) { return ~(f ^ g); }

Bdd operator^(const Bdd& f, const Bdd& g) {
    if (f.is_constant()) return f.is_true() ? ~g : g;
    if (g.is_constant()) return g.is_true() ? ~f : f;
    return result_of(kernel_of({&f, &g}), [&](Kernel& k) { return bdd::exclusive(k, f.edge(), g.edge()); });
}

Bdd ite(const Bdd& condition, const Bdd& then, const Bdd& otherwise) {
    if (condition.is_constant()) return condition.is_true() ? then : otherwise;
    return result_of(kernel_of({&condition, &then, &otherwise}),
                     [&](Kernel& k) { return bdd::if_then_else(k, condition.edge(), then.edge(), otherwise.edge()); });
}

Bdd cube(const BddSpace& space, std::span<const BddLiteral> literals) {
    std::vector<std::pair<std::uint32_t, bool>> sorted;
    const bdd::Order& order = space.kernel().order;
    for (const BddLiteral& literal : literals) {
        assert(literal.variable < order.size());
        sorted.emplace_back(order.level_of[literal.variable], literal.value);
    }
    // The cube is built bottom-up, so that each literal adds one node.
    std::ranges::sort(sorted, std::ranges::greater{});
    sorted.erase(std::ranges::unique(sorted).begin(), sorted.end());
    if (sorted.empty()) return Bdd::constant(true);
    return result_of(&space.kernel(), [&](Kernel& k) {
        Edge result = bdd::true_edge;
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            const auto [level, value] = sorted[i];
            // The cube is false if it contains a variable and its negation.
            if (i > 0 && sorted[i - 1].first == level) return bdd::false_edge;
            result =
                value ? bdd::make(k, level, bdd::false_edge, result) : bdd::make(k, level, result, bdd::false_edge);
        }
        return result;
    });
}

Bdd variable_set(const BddSpace& space, std::span<const std::uint32_t> variables) {
    std::vector<BddLiteral> literals;
    literals.reserve(variables.size());
    for (const std::uint32_t variable : variables) literals.push_back({variable, true});
    return cube(space, literals);
}

Bdd exists(const Bdd& f, const Bdd& variables) {
    if (f.is_constant() || variables.is_constant()) return f;
    return result_of(kernel_of({&f, &variables}),
                     [&](Kernel& k) { return bdd::quantified(k, f.edge(), variables.edge()); });
}

Bdd and_exists(const Bdd& f, const Bdd& g, const Bdd& variables) {
    if (f.is_constant() || g.is_constant() || variables.is_constant()) return exists(f & g, variables);
    return result_of(kernel_of({&f, &g, &variables}),
                     [&](Kernel& k) { return bdd::product_quantified(k, f.edge(), g.edge(), variables.edge()); });
}

Bdd cofactor(const Bdd& f, const Bdd& cube) {
    if (f.is_constant() || cube.is_constant()) return f;
    return result_of(kernel_of({&f, &cube}), [&](Kernel& k) { return bdd::restricted(k, f.edge(), cube.edge()); });
}

Bdd simplify(const Bdd& f, const Bdd& care) {
    assert(!care.is_false());
    if (f.is_constant() || care.is_constant()) return f;
    return result_of(kernel_of({&f, &care}), [&](Kernel& k) { return bdd::simplified(k, f.edge(), care.edge()); });
}

}  // namespace grafverif
