// SPDX-License-Identifier: MIT
#include "support/force.hpp"

#include <algorithm>
#include <numeric>

namespace grafverif {

namespace {

constexpr int most_rounds = 100, longest_idle = 8;

class Force {
public:
    Force(std::size_t vertices, const std::vector<ForceEdge>& edges)
        : edges_(edges), edges_of_(vertices), place_(vertices) {
        for (std::uint32_t edge = 0; edge < edges_.size(); ++edge)
            for (const std::uint32_t vertex : edges_[edge]) edges_of_[vertex].push_back(edge);
        std::iota(place_.begin(), place_.end(), 0.0);
    }

    std::vector<double> places() {
        std::vector<double> best = place_;
        double least = total_span();
        int idle = 0;
        for (int round = 0; round < most_rounds && idle < longest_idle; ++round) {
            move();
            const double span = total_span();
            idle = span < least ? 0 : idle + 1;
            if (span < least) best = place_;
            least = std::min(span, least);
        }
        return best;
    }

private:
    void move() {
        std::vector<double> centre(edges_.size());
        for (std::size_t edge = 0; edge < edges_.size(); ++edge) {
            for (const std::uint32_t vertex : edges_[edge]) centre[edge] += place_[vertex];
            centre[edge] /= static_cast<double>(edges_[edge].size());
        }
        std::vector<double> barycentre = place_;
        for (std::size_t vertex = 0; vertex < barycentre.size(); ++vertex) {
            if (edges_of_[vertex].empty()) continue;
            barycentre[vertex] = 0;
            for (const std::uint32_t edge : edges_of_[vertex]) barycentre[vertex] += centre[edge];
            barycentre[vertex] /= static_cast<double>(edges_of_[vertex].size());
        }
        std::vector<std::uint32_t> sorted(place_.size());
        std::iota(sorted.begin(), sorted.end(), 0U);
        std::ranges::stable_sort(sorted, {}, [&](std::uint32_t vertex) { return barycentre[vertex]; });
        for (std::size_t i = 0; i < sorted.size(); ++i) place_[sorted[i]] = static_cast<double>(i);
    }

    double total_span() const {
        double span = 0;
        for (const ForceEdge& edge : edges_) {
            const auto [least, most] =
                std::ranges::minmax(edge, {}, [&](std::uint32_t vertex) { return place_[vertex]; });
            span += place_[most] - place_[least];
        }
        return span;
    }

    const std::vector<ForceEdge>& edges_;
    std::vector<std::vector<std::uint32_t>> edges_of_;  ///< indices of the hyperedges of each vertex
    std::vector<double> place_;
};

}  // namespace

std::vector<double> force_places(std::size_t vertices, const std::vector<ForceEdge>& edges) {
    return Force(vertices, edges).places();
}

}  // namespace grafverif
