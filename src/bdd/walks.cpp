// SPDX-License-Identifier: MIT
// Traversals of the nodes of a function. The traversals do not create nodes. A traversal marks visited nodes, and
// clears the marks at its end.
#include <algorithm>
#include <cassert>
#include <new>

#include "bdd/kernel.hpp"

namespace grafverif {

namespace bdd {

namespace {

/// The visited nodes of a traversal.
struct VisitedNodes {
    explicit VisitedNodes(NodeTable& all) : table(all) {}
    VisitedNodes(const VisitedNodes&) = delete;
    VisitedNodes& operator=(const VisitedNodes&) = delete;
    ~VisitedNodes() {
        for (const std::uint32_t n : nodes) table.unmark(n);
    }

    NodeTable& table;
    std::vector<std::uint32_t> nodes = {};
};

}  // namespace

std::vector<std::uint32_t> nodes_of(Kernel& kernel, Edge root) {
    NodeTable& table = kernel.table;
    if (table.sweeping) relink(kernel);  // an interrupted sweep, which still needs the marks, is completed first
    VisitedNodes met(table);
    const auto meet = [&](Edge edge) {
        const std::uint32_t n = index_of(edge);
        if (n == 0 || table.marked(n)) return;
        met.nodes.push_back(n);
        table.mark(n);
    };
    try {
        meet(root);
        for (std::size_t next = 0; next < met.nodes.size(); ++next) {
            kernel.watch.step();
            const Node& node = table.nodes[met.nodes[next]];
            meet(node.low);
            meet(node.high);
        }
        std::vector<std::uint32_t> found = met.nodes;
        std::ranges::sort(found, [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(table.nodes[b].level, b) < std::pair(table.nodes[a].level, a);
        });
        return found;
    } catch (const std::bad_alloc&) {
        throw BddExhausted(BddExhausted::Cause::Memory);
    }
}

}  // namespace bdd

std::vector<std::uint32_t> support(const Bdd& f) {
    std::vector<std::uint32_t> variables;
    if (f.is_constant()) return variables;
    std::uint32_t last = bdd::constant_level;
    for (const std::uint32_t n : bdd::nodes_of(*f.kernel(), f.edge())) {
        const std::uint32_t level = f.kernel()->table.nodes[n].level;
        if (level != last) variables.push_back(f.kernel()->order.variable_at[level]);
        last = level;
    }
    std::ranges::sort(variables);
    return variables;
}

std::size_t size(const Bdd& f) { return f.is_constant() ? 0 : bdd::nodes_of(*f.kernel(), f.edge()).size(); }

bool evaluate(const Bdd& f, const std::vector<bool>& values) {
    bdd::Edge edge = f.edge();
    while (!bdd::is_constant(edge)) {
        const bdd::Kernel& kernel = *f.kernel();
        const std::size_t variable = kernel.order.variable_at[kernel.level(edge)];
        assert(variable < values.size());
        edge = values[variable] ? kernel.high(edge) : kernel.low(edge);
    }
    return edge == bdd::true_edge;
}

std::optional<std::vector<BddLiteral>> one_cube(const Bdd& f) {
    if (f.is_false()) return {};
    std::vector<BddLiteral> literals;
    for (bdd::Edge edge = f.edge(); !bdd::is_constant(edge);) {
        const bdd::Kernel& kernel = *f.kernel();
        const bool value = kernel.low(edge) == bdd::false_edge;
        literals.push_back({kernel.order.variable_at[kernel.level(edge)], value});
        edge = value ? kernel.high(edge) : kernel.low(edge);
    }
    std::ranges::sort(literals, {}, &BddLiteral::variable);
    return literals;
}

void for_each_cube(const Bdd& f, const std::function<bool(std::span<const BddLiteral>)>& visit) {
    struct Branch {
        /// Cofactor of the function for the literals of the path; stored as a handle, because `visit` may use the
        /// space.
        Bdd function = {};
        std::size_t depth = 0;    ///< number of literals on the path
        BddLiteral literal = {};  ///< last literal of the path
    };
    std::vector<Branch> open{{f, 0, {}}};
    std::vector<BddLiteral> literals;
    while (!open.empty()) {
        const Branch branch = std::move(open.back());
        open.pop_back();
        if (branch.depth > 0) {
            literals.resize(branch.depth - 1);
            literals.push_back(branch.literal);
        }
        if (branch.function.is_false()) continue;
        if (branch.function.is_true()) {
            if (!visit(literals)) return;
            continue;
        }
        branch.function.kernel()->watch.step();
        const std::uint32_t variable = branch.function.top();
        open.push_back({branch.function.high(), branch.depth + 1, {variable, true}});
        open.push_back({branch.function.low(), branch.depth + 1, {variable, false}});
    }
}

}  // namespace grafverif
