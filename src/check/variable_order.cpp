// SPDX-License-Identifier: MIT
// FORCE (Aloul, Markov, Sakallah 2003): a hyperedge for each operator with its operands, and for each variable with its
// next value; in turn every hyperedge moves to the mean place of its members and every member to the mean place of its
// hyperedges, until the total span of the hyperedges shrinks no more. Terms take part as members of their own, so a
// wide disjunction does not weld all that it reads into one block.
#include "check/variable_order.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace grafverif::symbolic {

namespace {

constexpr int most_rounds = 100, patience = 8;

class Force {
public:
    explicit Force(const FlatSystem& flat) : flat_(flat), variables_(flat.variables.size()) {
        vertex_.assign(flat.exprs.size(), none);
        for (const FlatSystem::Variable& variable : flat.variables)
            for (const auto& term : {variable.initial, variable.next})
                if (term) add(*term);
        for (const auto* terms : {&flat.invariants, &flat.transitions})
            for (const Id<Expr> term : *terms) add(term);
        for (const Id<FlatSystem::Variable> id : flat.variables.ids())
            if (const auto& next = flat.variables[id].next; next && !is_constant(flat.exprs[*next].op))
                edges_.push_back({id.index, vertex_[next->index]});
        edges_of_.resize(vertices_);
        for (std::uint32_t edge = 0; edge < edges_.size(); ++edge)
            for (const std::uint32_t vertex : edges_[edge]) edges_of_[vertex].push_back(edge);
    }

    std::vector<Id<FlatSystem::Variable>> order() {
        place_.resize(vertices_);
        std::iota(place_.begin(), place_.end(), 0.0);
        std::vector<double> best = place_;
        double least = std::numeric_limits<double>::max();
        int idle = 0;
        for (int round = 0; round < most_rounds && idle < patience; ++round) {
            move();
            const double span = total_span();
            idle = span < least ? 0 : idle + 1;
            if (span < least) best = place_;
            least = std::min(span, least);
        }
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

    void move() {
        std::vector<double> centre(edges_.size());
        for (std::size_t edge = 0; edge < edges_.size(); ++edge) {
            for (const std::uint32_t vertex : edges_[edge]) centre[edge] += place_[vertex];
            centre[edge] /= static_cast<double>(edges_[edge].size());
        }
        std::vector<double> wish = place_;
        for (std::size_t vertex = 0; vertex < wish.size(); ++vertex) {
            if (edges_of_[vertex].empty()) continue;
            wish[vertex] = 0;
            for (const std::uint32_t edge : edges_of_[vertex]) wish[vertex] += centre[edge];
            wish[vertex] /= static_cast<double>(edges_of_[vertex].size());
        }
        std::vector<std::uint32_t> sorted(vertices_);
        std::iota(sorted.begin(), sorted.end(), 0U);
        std::ranges::stable_sort(sorted, {}, [&](std::uint32_t vertex) { return wish[vertex]; });
        for (std::size_t i = 0; i < sorted.size(); ++i) place_[sorted[i]] = static_cast<double>(i);
    }

    double total_span() const {
        double span = 0;
        for (const std::vector<std::uint32_t>& edge : edges_) {
            const auto [least, most] = std::ranges::minmax(edge, {}, [&](std::uint32_t vertex) { return place_[vertex]; });
            span += place_[most] - place_[least];
        }
        return span;
    }

    const FlatSystem& flat_;
    std::size_t variables_ = 0;
    std::size_t vertices_ = variables_;
    std::vector<std::uint32_t> vertex_ = {};                  ///< per term
    std::vector<Id<Expr>> operators_ = {};
    std::vector<std::vector<std::uint32_t>> edges_ = {};      ///< vertices
    std::vector<std::vector<std::uint32_t>> edges_of_ = {};   ///< per vertex
    std::vector<double> place_ = {};
};

}  // namespace

std::vector<Id<FlatSystem::Variable>> variable_order(const FlatSystem& flat) { return Force(flat).order(); }

}  // namespace grafverif::symbolic
