// SPDX-License-Identifier: MIT
#include "conform/flow.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

namespace grafverif::conform {

namespace {

constexpr std::int64_t unlimited = std::numeric_limits<std::int64_t>::max() / 4;

}  // namespace

std::size_t Flow::add_arc(std::uint32_t from, std::uint32_t to, std::int64_t cost) {
    out_[from].push_back(static_cast<std::uint32_t>(halves_.size()));
    halves_.push_back({to, cost, unlimited});
    out_[to].push_back(static_cast<std::uint32_t>(halves_.size()));
    halves_.push_back({from, -cost, 0});
    return halves_.size() / 2 - 1;
}

std::optional<std::int64_t> Flow::solve() {
    potential_.assign(out_.size(), 0);
    while (std::ranges::any_of(supply_, [](std::int64_t amount) { return amount > 0; })) {
        if (!shortest_paths()) return {};
        saturate();
    }
    return cost_;
}

/// Distances from the nodes with supply, by which the potentials grow (Dijkstra under reduced costs); whether a node
/// with demand is within reach.
bool Flow::shortest_paths() {
    std::vector<std::int64_t> distance(out_.size(), unlimited);
    using Entry = std::pair<std::int64_t, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (std::uint32_t node = 0; node < out_.size(); ++node)
        if (supply_[node] > 0) open.emplace(distance[node] = 0, node);
    std::int64_t nearest = unlimited;   // demand
    while (!open.empty()) {
        const auto [far, node] = open.top();
        open.pop();
        if (far != distance[node]) continue;
        if (supply_[node] < 0) nearest = std::min(nearest, far);
        if (far > nearest) break;
        for (const std::uint32_t index : out_[node]) {
            const Half& half = halves_[index];
            if (half.capacity == 0) continue;
            const std::int64_t reached = far + reduced(node, half);
            if (reached < distance[half.to]) open.emplace(distance[half.to] = reached, half.to);
        }
    }
    if (nearest == unlimited) return false;
    for (std::uint32_t node = 0; node < out_.size(); ++node) potential_[node] += std::min(distance[node], nearest);
    return true;
}

/// Sends as much as goes over arcs of reduced cost zero: rounds of levels and blocking flows (Dinic).
void Flow::saturate() {
    std::vector<std::uint32_t> level(out_.size());
    std::vector<std::size_t> next(out_.size());
    constexpr std::uint32_t unseen = std::numeric_limits<std::uint32_t>::max();
    while (true) {
        std::ranges::fill(level, unseen);
        std::ranges::fill(next, 0);
        std::vector<std::uint32_t> order;
        for (std::uint32_t node = 0; node < out_.size(); ++node)
            if (supply_[node] > 0) level[node] = 0, order.push_back(node);
        bool found = false;
        for (std::size_t k = 0; k < order.size(); ++k) {
            found = found || supply_[order[k]] < 0;
            for (const std::uint32_t index : out_[order[k]]) {
                const Half& half = halves_[index];
                if (half.capacity == 0 || level[half.to] != unseen || reduced(order[k], half) != 0) continue;
                level[half.to] = level[order[k]] + 1;
                order.push_back(half.to);
            }
        }
        if (!found) return;
        for (std::uint32_t source = 0; source < out_.size(); ++source) {
            std::vector<std::uint32_t> path;   // halves
            while (supply_[source] > 0) {
                const std::uint32_t node = path.empty() ? source : halves_[path.back()].to;
                if (supply_[node] < 0) {
                    std::int64_t amount = std::min(supply_[source], -supply_[node]);
                    for (const std::uint32_t index : path) amount = std::min(amount, halves_[index].capacity);
                    for (const std::uint32_t index : path) {
                        halves_[index].capacity -= amount;
                        halves_[index ^ 1U].capacity += amount;
                        cost_ += amount * halves_[index].cost;
                    }
                    supply_[source] -= amount;
                    supply_[node] += amount;
                    path.clear();
                    continue;
                }
                bool advanced = false;
                for (; next[node] < out_[node].size(); ++next[node]) {
                    const std::uint32_t index = out_[node][next[node]];
                    const Half& half = halves_[index];
                    if (half.capacity == 0 || level[half.to] != level[node] + 1 || reduced(node, half) != 0) continue;
                    path.push_back(index);
                    advanced = true;
                    break;
                }
                if (advanced) continue;
                if (path.empty()) break;
                const std::uint32_t before = halves_[path.back() ^ 1U].to;
                path.pop_back();
                ++next[before];
            }
        }
    }
}

}  // namespace grafverif::conform
