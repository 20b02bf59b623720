// SPDX-License-Identifier: MIT
// Walks over the nodes of one function. They create no nodes, so they need no handles.
#include <cassert>

#include "bdd/nodes.hpp"

namespace grafverif {

namespace bdd {

std::vector<int> nodes_of(int root) {
    std::vector<int> found, open;
    std::unordered_set<int> seen;
    const auto meet = [&](int node) {
        if (node >= 2 && seen.insert(node).second) open.push_back(node);
    };
    for (meet(root); !open.empty();) {
        const int node = open.back();
        open.pop_back();
        found.push_back(node);
        meet(::bdd_low(node));
        meet(::bdd_high(node));
    }
    std::ranges::sort(found, [](int a, int b) { return std::pair(-::bdd_var(a), a) < std::pair(-::bdd_var(b), b); });
    return found;
}

}  // namespace bdd

std::vector<std::uint32_t> support(const Bdd& f) {
    std::vector<std::uint32_t> variables;
    for (const int node : bdd::nodes_of(f.node())) variables.push_back(static_cast<std::uint32_t>(::bdd_var(node)));
    std::ranges::reverse(variables);
    const auto repeated = std::ranges::unique(variables);
    variables.erase(repeated.begin(), repeated.end());
    return variables;
}

std::size_t size(const Bdd& f) { return bdd::nodes_of(f.node()).size(); }

bool evaluate(const Bdd& f, const std::vector<bool>& values) {
    int node = f.node();
    while (node >= 2) {
        const auto variable = static_cast<std::size_t>(::bdd_var(node));
        assert(variable < values.size());
        node = values[variable] ? ::bdd_high(node) : ::bdd_low(node);
    }
    return node == 1;
}

std::optional<std::vector<BddLiteral>> one_cube(const Bdd& f) {
    if (f.is_false()) return {};
    std::vector<BddLiteral> literals;
    for (int node = f.node(); node >= 2;) {
        const bool value = ::bdd_low(node) == 0;
        literals.push_back({static_cast<std::uint32_t>(::bdd_var(node)), value});
        node = value ? ::bdd_high(node) : ::bdd_low(node);
    }
    return literals;
}

void for_each_cube(const Bdd& f, const std::function<bool(std::span<const BddLiteral>)>& visit) {
    struct Branch {
        int node = 0;               ///< where to go on
        std::size_t depth = 0;      ///< literals that lead here
        BddLiteral literal = {};    ///< the last of them
    };
    const Bdd held = f;   // `visit` may drop the last other handle
    std::vector<Branch> open{{held.node(), 0, {}}};
    std::vector<BddLiteral> literals;
    while (!open.empty()) {
        const Branch branch = open.back();
        open.pop_back();
        if (branch.depth > 0) {
            literals.resize(branch.depth - 1);
            literals.push_back(branch.literal);
        }
        if (branch.node == 0) continue;
        if (branch.node == 1) {
            if (!visit(literals)) return;
            continue;
        }
        const auto variable = static_cast<std::uint32_t>(::bdd_var(branch.node));
        open.push_back({::bdd_high(branch.node), branch.depth + 1, {variable, true}});
        open.push_back({::bdd_low(branch.node), branch.depth + 1, {variable, false}});
    }
}

}  // namespace grafverif
