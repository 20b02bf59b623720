// SPDX-License-Identifier: MIT
// Computes a variable order by quadratic placement on a line. Each variable and each term has a position on the line.
// The placement minimizes the sum of the squared distances between an operator and its operands, and between a variable
// and the term of its next value (Hall 1970: "An r-dimensional quadratic placement algorithm"; Fiedler 1973). The
// weight of an operator decreases with its number of operands, so that a disjunction with many operands does not force
// all its variables into one block. Because terms also have positions, the variables of a large term need not be
// adjacent.
//
// The vector of all positions is the second eigenvector of the transition matrix of a random walk over the terms. Power
// iteration computes this eigenvector: beginning with initial positions, it repeatedly moves each vertex to the mean
// position of its neighbours and subtracts the weighted mean of all positions.
#include "check/symbolic/order.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ranges>

namespace grafverif::symbolic {

namespace {

constexpr int rounds = 500;

class Line {
public:
    explicit Line(const FlatSystem& flat) : flat_(flat) {
        vertex_.assign(flat.exprs.size(), none);
        for (const FlatSystem::Variable& variable : flat.variables)
            for (const auto& term : {variable.initial, variable.next})
                if (term) add(*term);
        for (const auto* terms : {&flat.invariants, &flat.transitions})
            for (const Id<Expr> term : *terms) add(term);
        for (const Id<FlatSystem::Variable> id : flat.variables.ids())
            if (const auto& next = flat.variables[id].next; next && vertex_[next->index] != none)
                tie({id.index, vertex_[next->index]});
    }

    std::vector<double> places() const {
        std::vector<double> place = first_guess(), centre(ties_.size());
        for (int round = 0; round < rounds; ++round) {
            centred(place);
            for (std::size_t tie = 0; tie < ties_.size(); ++tie) {
                centre[tie] = 0;
                for (const std::uint32_t vertex : ties_[tie]) centre[tie] += place[vertex];
                centre[tie] /= static_cast<double>(ties_[tie].size());
            }
            std::vector<double> next(place.size());
            for (std::size_t tie = 0; tie < ties_.size(); ++tie)
                for (const std::uint32_t vertex : ties_[tie]) next[vertex] += weight(tie) * centre[tie];
            for (std::size_t vertex = 0; vertex < place.size(); ++vertex)
                if (weights_[vertex] > 0) place[vertex] = next[vertex] / weights_[vertex];
        }
        return place;
    }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    double weight(std::size_t tie) const { return 1 / static_cast<double>(ties_[tie].size() - 1); }

    /// Adds a vertex for each operator in the term, connected to the vertices of its operands. The vertices with the
    /// smallest indices represent the variables.
    void add(Id<Expr> root) {
        std::vector<Id<Expr>> open{root}, operators;
        while (!open.empty()) {
            const Id<Expr> term = open.back();
            open.pop_back();
            const Expr& node = flat_.exprs[term];
            if (is_constant(node.op) || vertex_[term.index] != none) continue;
            if (node.op == Op::Variable) {
                vertex_[term.index] = static_cast<std::uint32_t>(node.value);
                continue;
            }
            vertex_[term.index] = static_cast<std::uint32_t>(weights_.size());
            weights_.push_back(0);
            for (const Id<Expr> operand : flat_.exprs.operands(term)) open.push_back(operand);
            operators.push_back(term);
        }
        for (const Id<Expr> term : operators | std::views::reverse) {
            std::vector<std::uint32_t> members{vertex_[term.index]};
            for (const Id<Expr> operand : flat_.exprs.operands(term))
                if (vertex_[operand.index] != none) members.push_back(vertex_[operand.index]);
            tie(std::move(members));
        }
    }

    void tie(std::vector<std::uint32_t> members) {
        if (members.size() < 2) return;
        ties_.push_back(std::move(members));
        for (const std::uint32_t vertex : ties_.back()) weights_[vertex] += weight(ties_.size() - 1);
    }

    /// Returns the initial positions. The variables are placed in the order in which the system declares them, and each
    /// term is placed at the mean position of its operands. One pass suffices, because operands precede the terms that
    /// contain them in the table of terms.
    std::vector<double> first_guess() const {
        std::vector<double> place(weights_.size());
        for (std::size_t vertex = 0; vertex < flat_.variables.size(); ++vertex)
            place[vertex] = static_cast<double>(vertex);
        for (std::uint32_t term = 0; term < vertex_.size(); ++term) {
            if (vertex_[term] == none || vertex_[term] < flat_.variables.size()) continue;
            double sum = 0, count = 0;
            for (const Id<Expr> operand : flat_.exprs.operands({term}))
                if (vertex_[operand.index] != none) sum += place[vertex_[operand.index]], ++count;
            place[vertex_[term]] = count > 0 ? sum / count : 0;
        }
        return place;
    }

    /// Shifts and scales the positions so that their weighted mean is 0 and the greatest distance from 0 is 1.
    void centred(std::vector<double>& place) const {
        double sum = 0, all = 0, farthest = 0;
        for (std::size_t vertex = 0; vertex < place.size(); ++vertex) {
            sum += weights_[vertex] * place[vertex];
            all += weights_[vertex];
        }
        const double mean = all > 0 ? sum / all : 0;
        for (double& each : place) {
            each -= mean;
            farthest = std::max(farthest, std::abs(each));
        }
        if (farthest > 0)
            for (double& each : place) each /= farthest;
    }

    const FlatSystem& flat_;
    /// For each vertex: total weight of its connections.
    std::vector<double> weights_ = std::vector<double>(flat_.variables.size());
    std::vector<std::uint32_t> vertex_ = {};  ///< index of the vertex of each term
    std::vector<std::vector<std::uint32_t>> ties_ = {};
};

}  // namespace

std::vector<Id<FlatSystem::Variable>> variable_order(const FlatSystem& flat) {
    const std::vector<double> places = Line(flat).places();
    std::vector<Id<FlatSystem::Variable>> order;
    for (const Id<FlatSystem::Variable> id : flat.variables.ids()) order.push_back(id);
    std::ranges::stable_sort(order, {}, [&](Id<FlatSystem::Variable> id) { return places[id.index]; });
    return order;
}

}  // namespace grafverif::symbolic
