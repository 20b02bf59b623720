// SPDX-License-Identifier: MIT
// Computes conjunction, exclusive or and if-then-else. Complement edges provide all other connectives: a disjunction is
// a complemented conjunction of complements, and an equivalence is a complemented exclusive or. Connectives that are
// computed by the same operation share the cache entries of this operation. Calls are normalized first, so that
// equivalent calls have one cache entry.
#include <algorithm>
#include <utility>

#include "bdd/explicit_stack.hpp"

namespace grafverif::bdd {

namespace {

struct Conjunction : Branching {
    static constexpr Operation operation = Operation::And;

    static bool terminal_case(const Kernel&, Call& call, Edge& result, bool&) {
        auto& [f, g, h] = call;
        if (f > g) std::swap(f, g);
        if (is_constant(f)) {
            result = f == true_edge ? g : false_edge;
            return true;
        }
        if (index_of(f) == index_of(g)) {
            result = f == g ? f : false_edge;
            return true;
        }
        return false;
    }

    static std::uint32_t level(const Kernel& kernel, const Call& call) {
        return std::min(kernel.level(call.f), kernel.level(call.g));
    }
    static std::uint32_t third(const Call&) { return 0; }
    static Call low(const Kernel& kernel, const Frame& at) {
        return {kernel.low(at.f, at.level), kernel.low(at.g, at.level), 0};
    }
    static Call high(const Kernel& kernel, const Frame& at) {
        return {kernel.high(at.f, at.level), kernel.high(at.g, at.level), 0};
    }
};

struct Exclusive : Conjunction {
    static constexpr Operation operation = Operation::Xor;

    static bool terminal_case(const Kernel&, Call& call, Edge& result, bool& flip) {
        auto& [f, g, h] = call;
        flip = complement_bit(f ^ g) != 0;
        f &= ~1U;
        g &= ~1U;
        if (f > g) std::swap(f, g);
        if (f != false_edge && f != g) return false;
        result = f == g ? false_edge : g;
        return true;
    }
};

struct Choice : Branching {
    static constexpr Operation operation = Operation::Ite;

    static bool terminal_case(Kernel& kernel, Call& call, Edge& result, bool& flip) {
        auto& [f, g, h] = call;
        if (is_constant(f) || g == h) {
            result = f == true_edge ? g : h;
            return true;
        }
        if (index_of(f) == index_of(g)) g = f == g ? true_edge : false_edge;
        if (index_of(f) == index_of(h)) h = f == h ? false_edge : true_edge;
        if (g == h) return result = g, true;
        if (g == false_edge) return result = conjunction(kernel, f ^ 1U, h), true;
        if (g == true_edge) return result = disjunction(kernel, f, h), true;
        if (h == false_edge) return result = conjunction(kernel, f, g), true;
        if (h == true_edge) return result = disjunction(kernel, f ^ 1U, g), true;
        if (index_of(g) == index_of(h)) return result = exclusive(kernel, f, h), true;
        if (complement_bit(f) != 0) {
            f ^= 1U;
            std::swap(g, h);
        }
        flip = complement_bit(g) != 0;
        g ^= static_cast<Edge>(flip);
        h ^= static_cast<Edge>(flip);
        return false;
    }

    static std::uint32_t level(const Kernel& kernel, const Call& call) {
        return std::min({kernel.level(call.f), kernel.level(call.g), kernel.level(call.h)});
    }
};

}  // namespace

Edge conjunction(Kernel& kernel, Edge f, Edge g) { return run(kernel, Conjunction{}, {f, g, 0}); }
Edge exclusive(Kernel& kernel, Edge f, Edge g) { return run(kernel, Exclusive{}, {f, g, 0}); }
Edge if_then_else(Kernel& kernel, Edge f, Edge g, Edge h) { return run(kernel, Choice{}, {f, g, h}); }

}  // namespace grafverif::bdd
