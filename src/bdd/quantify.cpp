// SPDX-License-Identifier: MIT
// Quantification, and the relational product, which quantifies during the conjunction (Burch, Clarke and Long 1990).
// A cube (conjunction of variables) represents the set of quantified variables. Variables of the cube above the top
// variables of the operands are skipped. If no variable of the cube remains, the result is the operand, or the
// conjunction of the two operands. If the result of the first branch of a quantified variable is true, the other branch
// is skipped.
#include <algorithm>
#include <utility>

#include "bdd/explicit_stack.hpp"

namespace grafverif::bdd {

namespace {

/// Returns the cube of quantified variables without the variables above `level`.
Edge below(const Kernel& kernel, Edge cube, std::uint32_t level) {
    while (kernel.level(cube) < level) cube = kernel.high(cube);
    return cube;
}

struct Some : Branching {
    static constexpr Operation operation = Operation::Exists;

    static bool terminal_case(const Kernel& kernel, Call& call, Edge& result, bool&) {
        auto& [f, cube, none] = call;
        result = f;
        if (is_constant(f)) return true;
        cube = below(kernel, cube, kernel.level(f));
        return is_constant(cube);
    }

    static std::uint32_t level(const Kernel& kernel, const Call& call) { return kernel.level(call.f); }

    static bool enough(const Kernel& kernel, const Frame& at, Edge& low) {
        if (kernel.level(at.g) != at.level) return false;
        return low == true_edge || low == kernel.high(at.f);
    }

    static Edge join(Kernel& kernel, Frame at, Edge high) {
        return kernel.level(at.g) == at.level ? disjunction(kernel, at.low, high)
                                              : make(kernel, at.level, at.low, high);
    }

    // The low branch of a cube is false; its high branch is the cube of the remaining variables.
    static Call low(const Kernel& kernel, const Frame& at) {
        return {kernel.low(at.f), kernel.high(at.g, at.level), 0};
    }
    static Call high(const Kernel& kernel, const Frame& at) {
        return {kernel.high(at.f), kernel.high(at.g, at.level), 0};
    }
};

struct Product : Branching {
    static constexpr Operation operation = Operation::AndExists;

    static bool terminal_case(Kernel& kernel, Call& call, Edge& result, bool&) {
        auto& [f, g, cube] = call;
        if (f > g) std::swap(f, g);
        if (f == false_edge || (index_of(f) == index_of(g) && f != g)) return result = false_edge, true;
        if (f == true_edge || f == g) return result = quantified(kernel, g, cube), true;
        cube = below(kernel, cube, level(kernel, call));
        if (is_constant(cube)) return result = conjunction(kernel, f, g), true;
        return false;
    }

    static std::uint32_t level(const Kernel& kernel, const Call& call) {
        return std::min(kernel.level(call.f), kernel.level(call.g));
    }

    static bool enough(const Kernel& kernel, const Frame& at, Edge& low) {
        if (kernel.level(at.h) != at.level) return false;
        // If an operand of the high branch equals `low`, the high branch need not be computed: its result implies
        // `low`, because `low` does not depend on quantified variables.
        return low == true_edge || low == kernel.high(at.f, at.level) || low == kernel.high(at.g, at.level);
    }

    static Edge join(Kernel& kernel, Frame at, Edge high) {
        return kernel.level(at.h) == at.level ? disjunction(kernel, at.low, high)
                                              : make(kernel, at.level, at.low, high);
    }

    static Call low(const Kernel& kernel, const Frame& at) {
        return {kernel.low(at.f, at.level), kernel.low(at.g, at.level), kernel.high(at.h, at.level)};
    }
};

}  // namespace

Edge quantified(Kernel& kernel, Edge f, Edge cube) { return run(kernel, Some{}, {f, cube, 0}); }

Edge product_quantified(Kernel& kernel, Edge f, Edge g, Edge cube) { return run(kernel, Product{}, {f, g, cube}); }

}  // namespace grafverif::bdd
