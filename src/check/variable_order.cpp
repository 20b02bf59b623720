// SPDX-License-Identifier: MIT
// FORCE with a hyperedge for each operator with its operands, and for each variable with its next value. Terms take part
// as members of their own, so a wide disjunction does not weld all that it reads into one block.
#include "check/variable_order.hpp"

#include <algorithm>
#include <limits>

#include "support/force.hpp"

namespace grafverif::symbolic {

namespace {

class Edges {
public:
    explicit Edges(const FlatSystem& flat) : flat_(flat), variables_(flat.variables.size()) {
        vertex_.assign(flat.exprs.size(), none);
        for (const FlatSystem::Variable& variable : flat.variables)
            for (const auto& term : {variable.initial, variable.next})
                if (term) add(*term);
        for (const auto* terms : {&flat.invariants, &flat.transitions})
            for (const Id<Expr> term : *terms) add(term);
        for (const Id<FlatSystem::Variable> id : flat.variables.ids())
            if (const auto& next = flat.variables[id].next; next && !is_constant(flat.exprs[*next].op))
                edges_.push_back({id.index, vertex_[next->index]});
    }

    std::vector<Id<FlatSystem::Variable>> order() {
        const std::vector<double> best = force_places(vertices_, edges_);
        std::vector<Id<FlatSystem::Variable>> result;
        for (const Id<FlatSystem::Variable> id : flat_.variables.ids()) result.push_back(id);
        std::ranges::stable_sort(result, {}, [&](Id<FlatSystem::Variable> id) { return best[id.index]; });
        return result;
    }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    /// A vertex for each term below `root`, a hyperedge for each operator. Variables are the first vertices.
    void add(Id<Expr> root) {
        std::vector<Id<Expr>> open{root};
        while (!open.empty()) {
            const Id<Expr> term = open.back();
            open.pop_back();
            const Expr& node = flat_.exprs[term];
            if (is_constant(node.op) || vertex_[term.index] != none) continue;
            vertex_[term.index] =
                node.op == Op::Variable ? static_cast<std::uint32_t>(node.value) : static_cast<std::uint32_t>(vertices_++);
            for (const Id<Expr> operand : flat_.exprs.operands(term)) open.push_back(operand);
            if (node.op != Op::Variable) operators_.push_back(term);
        }
        for (; !operators_.empty(); operators_.pop_back()) {
            std::vector<std::uint32_t> edge{vertex_[operators_.back().index]};
            for (const Id<Expr> operand : flat_.exprs.operands(operators_.back()))
                if (vertex_[operand.index] != none) edge.push_back(vertex_[operand.index]);
            edges_.push_back(std::move(edge));
        }
    }

    const FlatSystem& flat_;
    std::size_t variables_ = 0;
    std::size_t vertices_ = variables_;
    std::vector<std::uint32_t> vertex_ = {};   ///< per term
    std::vector<Id<Expr>> operators_ = {};
    std::vector<ForceEdge> edges_ = {};
};

}  // namespace

std::vector<Id<FlatSystem::Variable>> variable_order(const FlatSystem& flat) { return Edges(flat).order(); }

}  // namespace grafverif::symbolic
