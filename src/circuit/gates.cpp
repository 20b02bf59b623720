// SPDX-License-Identifier: MIT
#include "circuit/gates.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace grafverif {

Gates::Literal Gates::source() {
    nodes_.emplace_back();
    return static_cast<Literal>(2 * (nodes_.size() - 1));
}

Gates::Literal Gates::both(Literal left, Literal right) {
    if (left > right) std::swap(left, right);
    if (left == no || left == (right ^ 1U)) return no;
    if (left == yes || left == right) return right;
    // Simplification with one level of lookahead: compares each operand of a gate with the operands of the gate's other
    // operand.
    for (const auto& [one, other] : std::array{std::pair(left, right), std::pair(right, left)}) {
        const Node inner = nodes_[node_of(one)];
        if (inner.left == no) continue;
        const bool has = inner.left == other || inner.right == other;
        const bool lacks = inner.left == (other ^ 1U) || inner.right == (other ^ 1U);
        if (!is_inverted(one) && has) return one;
        if (!is_inverted(one) && lacks) return no;
        if (is_inverted(one) && lacks) return other;
        if (is_inverted(one) && has) return both(other, (inner.left == other ? inner.right : inner.left) ^ 1U);
    }
    const std::uint64_t key = std::uint64_t{left} << 32U | right;
    const auto [place, fresh] = known_.try_emplace(key, static_cast<std::uint32_t>(nodes_.size()));
    if (fresh) nodes_.push_back({left, right});
    return 2 * place->second;
}

Gates::Literal Gates::choice(Literal condition, Literal then, Literal otherwise) {
    if (then == otherwise) return then;
    if (then == yes || then == condition) return either(condition, otherwise);
    if (then == no || then == (condition ^ 1U)) return both(condition ^ 1U, otherwise);
    if (otherwise == no || otherwise == condition) return both(condition, then);
    if (otherwise == yes || otherwise == (condition ^ 1U)) return either(condition ^ 1U, then);
    return either(both(condition, then), both(condition ^ 1U, otherwise));
}

std::vector<std::uint32_t> cone(const Gates& gates, const std::vector<Gates::Literal>& roots) {
    std::vector<bool> in(gates.size());
    std::uint32_t last = 0;
    for (const Gates::Literal root : roots) {
        in[node_of(root)] = true;
        last = std::max(last, node_of(root));
    }
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t node = last; node > 0; --node) {
        if (!in[node]) continue;
        nodes.push_back(node);
        in[node_of(gates[node].left)] = in[node_of(gates[node].right)] = true;
    }
    std::ranges::reverse(nodes);
    return nodes;
}

namespace {

Gates* graph_of(const Gate& f, const Gate& g) { return f.gates != nullptr ? f.gates : g.gates; }

/// Returns the conjunction of two constant Gates. Constants do not belong to a graph.
Gate settled(const Gate& f, const Gate& g) {
    return Gate::constant(f.literal == Gates::yes && g.literal == Gates::yes);
}

}  // namespace

Gate operator&(const Gate& f, const Gate& g) {
    Gates* const gates = graph_of(f, g);
    return gates == nullptr ? settled(f, g) : Gate{gates, gates->both(f.literal, g.literal)};
}

Gate ite(const Gate& condition, const Gate& then, const Gate& otherwise) {
    if (condition.is_constant()) return condition.is_false() ? otherwise : then;
    return {condition.gates, condition.gates->choice(condition.literal, then.literal, otherwise.literal)};
}

}  // namespace grafverif
