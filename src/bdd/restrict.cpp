// SPDX-License-Identifier: MIT
// Simplifies functions under an assumption. `restricted` sets variables to constants (exact cofactor). `simplified`
// applies a care set, outside of which the result is arbitrary (restrict of Coudert and Madre, 1990). Variables on
// which only the care set depends are quantified in the care set. If the care set is false for one value of a variable,
// the result does not depend on this variable and is computed for its other value.
#include <algorithm>

#include "bdd/explicit_stack.hpp"

namespace grafverif::bdd {

namespace {

/// Removes the complement bit of `f`, and returns true if the bit was set, so that a function and its complement share
/// cache entries. Removing the bit is correct, because both operations commute with complementation.
bool made_regular(Edge& f) {
    const bool flip = complement_bit(f) != 0;
    f &= ~1U;
    return flip;
}

struct Restriction : Branching {
    static constexpr Operation operation = Operation::Cofactor;

    static bool terminal_case(const Kernel& kernel, Call& call, Edge& result, bool& flip) {
        auto& [f, cube, none] = call;
        while (!is_constant(f) && !is_constant(cube)) {
            const std::uint32_t at = kernel.level(f), literal = kernel.level(cube);
            if (at < literal) break;
            const bool positive = kernel.low(cube) == false_edge;
            if (at == literal) f = positive ? kernel.high(f) : kernel.low(f);
            cube = positive ? kernel.high(cube) : kernel.low(cube);
        }
        flip = made_regular(f);
        result = f;
        return is_constant(f) || is_constant(cube);
    }

    static std::uint32_t level(const Kernel& kernel, const Call& call) { return kernel.level(call.f); }
    static Call low(const Kernel& kernel, const Frame& at) { return {kernel.low(at.f), at.g, 0}; }
    static Call high(const Kernel& kernel, const Frame& at) { return {kernel.high(at.f), at.g, 0}; }
};

struct Simplification : Branching {
    static constexpr Operation operation = Operation::Simplify;

    static bool terminal_case(Kernel& kernel, Call& call, Edge& result, bool& flip) {
        auto& [f, care, none] = call;
        while (!is_constant(f) && !is_constant(care) && index_of(f) != index_of(care)) {
            const std::uint32_t at = kernel.level(f), cared = kernel.level(care);
            if (at < cared) break;
            const Edge low = kernel.low(care), high = kernel.high(care);
            if (at > cared) {
                care = disjunction(kernel, low, high);
            } else if (low == false_edge) {
                f = kernel.high(f);
                care = high;
            } else if (high == false_edge) {
                f = kernel.low(f);
                care = low;
            } else {
                break;
            }
        }
        if (!is_constant(care) && index_of(f) == index_of(care)) f = f == care ? true_edge : false_edge;
        flip = made_regular(f);
        result = f;
        return is_constant(f) || is_constant(care);
    }

    static std::uint32_t level(const Kernel& kernel, const Call& call) { return kernel.level(call.f); }
};

}  // namespace

Edge restricted(Kernel& kernel, Edge f, Edge cube) { return run(kernel, Restriction{}, {f, cube, 0}); }
Edge simplified(Kernel& kernel, Edge f, Edge care) { return run(kernel, Simplification{}, {f, care, 0}); }

}  // namespace grafverif::bdd
