// SPDX-License-Identifier: MIT
// Gates: Boolean functions as an and-inverter graph (Kuehlmann, Paruthi, Krohm and Ganai 2002). Gates are hash-consed
// and simplified with one level of lookahead. Nevertheless, different gates may represent the same function.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace grafverif {

class Gates {
public:
    /// Literal: 2 * node, plus 1 for its complement. Node 0 is the constant false.
    using Literal = std::uint32_t;
    static constexpr Literal no = 0, yes = 1;

    /// An and-gate of two literals of earlier nodes, or a source (an input or latch), whose two literals are `no`.
    struct Node {
        Literal left = no, right = no;
        bool operator==(const Node&) const = default;
    };

    Literal source();
    Literal both(Literal left, Literal right);
    Literal either(Literal left, Literal right) { return both(left ^ 1U, right ^ 1U) ^ 1U; }
    Literal choice(Literal condition, Literal then, Literal otherwise);

    /// Returns the number of nodes, including the constant.
    std::size_t size() const { return nodes_.size(); }
    const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
    bool is_gate(std::uint32_t node) const { return nodes_[node].left != no; }

    bool operator==(const Gates& other) const { return nodes_ == other.nodes_; }

private:
    std::vector<Node> nodes_ = {{}};
    std::unordered_map<std::uint64_t, std::uint32_t> known_ = {};
};

inline std::uint32_t node_of(Gates::Literal literal) { return literal >> 1U; }
inline bool is_inverted(Gates::Literal literal) { return (literal & 1U) != 0; }

/// Returns the nodes on which `roots` depend, including the roots, in increasing order. The constant is never included.
std::vector<std::uint32_t> cone(const Gates& gates, const std::vector<Gates::Literal>& roots);

/// A Boolean function with the operations that the templates of ir/bit_terms.hpp require. Constants do not belong to a
/// graph.
struct Gate {
    Gates* gates = nullptr;
    Gates::Literal literal = Gates::no;

    static Gate constant(bool value) { return {nullptr, value ? Gates::yes : Gates::no}; }
    bool is_false() const { return literal == Gates::no; }
    bool is_constant() const { return literal <= Gates::yes; }
    bool operator==(const Gate& other) const { return literal == other.literal; }
};

inline Gate operator~(const Gate& f) { return {f.gates, f.literal ^ 1U}; }
Gate operator&(const Gate& f, const Gate& g);
inline Gate operator|(const Gate& f, const Gate& g) { return ~(~f & ~g); }
Gate ite(const Gate& condition, const Gate& then, const Gate& otherwise);
inline Gate operator^(const Gate& f, const Gate& g) { return ite(f, ~g, g); }

}  // namespace grafverif
