// SPDX-License-Identifier: MIT
#include "conform/tour.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace grafverif::conform {

namespace {

// Computes a minimum-cost flow on arcs with unlimited capacity by the primal-dual method. This method alternately
// computes shortest distances under reduced costs and a maximum flow along arcs of reduced cost zero.

class Flow {
public:
    explicit Flow(std::size_t nodes) : out_(nodes), supply_(nodes) {}

    /// Adds an arc with unlimited capacity and returns its index. Requires `cost` >= 0.
    std::size_t add_arc(std::uint32_t from, std::uint32_t to, std::int64_t cost);
    /// Adds supply at `node`; a negative supply is a demand. The sum of all supplies must be 0.
    void add_supply(std::uint32_t node, std::int64_t amount) { supply_[node] += amount; }

    /// Computes a flow of minimal cost that satisfies the supplies as far as possible.
    void solve();
    /// Returns the flow on arc `arc`, after solve().
    std::int64_t flow(std::size_t arc) const { return halves_[2 * arc + 1].capacity; }

private:
    /// An arc in forward direction (even index) or backward direction (odd index).
    struct Half {
        std::uint32_t to = 0;
        std::int64_t cost = 0;
        std::int64_t capacity = 0;
    };

    bool shortest_paths();
    void saturate();
    std::optional<std::vector<std::uint32_t>> levels_to_demand() const;
    void drain(std::uint32_t source, const std::vector<std::uint32_t>& level, std::vector<std::size_t>& next);
    void send(std::uint32_t source, std::uint32_t target, const std::vector<std::uint32_t>& path);
    std::int64_t reduced(std::uint32_t from, const Half& half) const {
        return half.cost + potential_[from] - potential_[half.to];
    }

    std::vector<Half> halves_ = {};
    std::vector<std::vector<std::uint32_t>> out_ = {};  ///< indices of the half arcs from each node
    std::vector<std::int64_t> supply_ = {};             ///< remaining supply of each node; a negative value is a demand
    std::vector<std::int64_t> potential_ = {};
};

constexpr std::int64_t unlimited = std::numeric_limits<std::int64_t>::max() / 4;

std::size_t Flow::add_arc(std::uint32_t from, std::uint32_t to, std::int64_t cost) {
    out_[from].push_back(static_cast<std::uint32_t>(halves_.size()));
    halves_.push_back({to, cost, unlimited});
    out_[to].push_back(static_cast<std::uint32_t>(halves_.size()));
    halves_.push_back({from, -cost, 0});
    return halves_.size() / 2 - 1;
}

void Flow::solve() {
    potential_.assign(out_.size(), 0);
    while (std::ranges::any_of(supply_, [](std::int64_t amount) { return amount > 0; }) && shortest_paths()) saturate();
}

/// Computes distances from the nodes with supply and adds them to the potentials (Dijkstra under reduced costs).
/// Returns true if a node with demand is reachable.
bool Flow::shortest_paths() {
    std::vector<std::int64_t> distance(out_.size(), unlimited);
    using Entry = std::pair<std::int64_t, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (std::uint32_t node = 0; node < out_.size(); ++node)
        if (supply_[node] > 0) open.emplace(distance[node] = 0, node);
    std::int64_t nearest = unlimited;  // smallest distance of a node with demand
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

/// Computes a maximum flow along arcs of reduced cost zero by level graphs and blocking flows (Dinic).
void Flow::saturate() {
    while (const std::optional<std::vector<std::uint32_t>> levels = levels_to_demand()) {
        std::vector<std::size_t> next(out_.size());
        for (std::uint32_t source = 0; source < out_.size(); ++source) drain(source, *levels, next);
    }
}

/// Returns the distance of each node from the nodes with supply, in arcs of reduced cost zero, or nothing if no node
/// with demand is reachable.
std::optional<std::vector<std::uint32_t>> Flow::levels_to_demand() const {
    constexpr std::uint32_t unseen = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> level(out_.size(), unseen), order;
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
    return found ? std::optional(std::move(level)) : std::nullopt;
}

/// Sends the supply of `source` along the level graph as far as possible. `next` contains, per node, the first half arc
/// that is not exhausted.
void Flow::drain(std::uint32_t source, const std::vector<std::uint32_t>& level, std::vector<std::size_t>& next) {
    std::vector<std::uint32_t> path;  // current path from `source`; its elements are indices of half arcs
    while (supply_[source] > 0) {
        const std::uint32_t node = path.empty() ? source : halves_[path.back()].to;
        if (supply_[node] < 0) {
            send(source, node, path);
            path.clear();
            continue;
        }
        const auto leads_on = [&](std::uint32_t index) {
            const Half& half = halves_[index];
            return half.capacity != 0 && level[half.to] == level[node] + 1 && reduced(node, half) == 0;
        };
        while (next[node] < out_[node].size() && !leads_on(out_[node][next[node]])) ++next[node];
        if (next[node] < out_[node].size()) {
            path.push_back(out_[node][next[node]]);
            continue;
        }
        if (path.empty()) return;
        ++next[halves_[path.back() ^ 1U].to];
        path.pop_back();
    }
}

/// Increases the flow along `path` by the minimum of the supply of `source`, the demand of `target` and the capacity of
/// the path.
void Flow::send(std::uint32_t source, std::uint32_t target, const std::vector<std::uint32_t>& path) {
    std::int64_t amount = std::min(supply_[source], -supply_[target]);
    for (const std::uint32_t index : path) amount = std::min(amount, halves_[index].capacity);
    for (const std::uint32_t index : path) {
        halves_[index].capacity -= amount;
        halves_[index ^ 1U].capacity += amount;
    }
    supply_[source] -= amount;
    supply_[target] += amount;
}

constexpr std::uint32_t none = 0xFFFFFFFFU;

/// The arcs, grouped by source node. The arcs of node n are order[first[n]] to order[first[n + 1] - 1].
struct Leaving {
    std::vector<std::uint32_t> first = {}, order = {};

    Leaving(std::uint32_t nodes, const std::vector<TourArc>& arcs) : first(nodes + 1), order(arcs.size()) {
        for (const TourArc& arc : arcs) ++first[arc.from + 1];
        std::partial_sum(first.begin(), first.end(), first.begin());
        std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
        for (std::uint32_t arc = 0; arc < arcs.size(); ++arc) order[next[arcs[arc].from]++] = arc;
    }
};

/// Returns one arc for each pair of different nodes that are connected: the first arc without a waiting time, or the
/// first arc if all arcs of the pair have a waiting time.
std::vector<std::uint32_t> distinct_arcs(const std::vector<TourArc>& arcs) {
    std::vector<std::uint32_t> all;
    for (std::uint32_t arc = 0; arc < arcs.size(); ++arc)
        if (arcs[arc].from != arcs[arc].to) all.push_back(arc);
    const auto key = [&](std::uint32_t arc) {
        return std::tuple(arcs[arc].from, arcs[arc].to, arcs[arc].wait_ms != 0, arc);
    };
    std::ranges::sort(all, {}, key);
    const auto same = [&](std::uint32_t a, std::uint32_t b) {
        return arcs[a].from == arcs[b].from && arcs[a].to == arcs[b].to;
    };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    return all;
}

/// True if the graph is strongly connected. Requires that every node is reachable from `start`.
bool strongly_connected(std::uint32_t nodes, std::uint32_t start, const std::vector<TourArc>& arcs,
                        const std::vector<std::uint32_t>& distinct) {
    std::vector<std::vector<std::uint32_t>> before(nodes);
    for (const std::uint32_t arc : distinct) before[arcs[arc].to].push_back(arcs[arc].from);
    std::vector<bool> seen(nodes);
    std::vector<std::uint32_t> open{start};
    seen[start] = true;
    std::uint32_t count = 1;
    while (!open.empty()) {
        const std::uint32_t node = open.back();
        open.pop_back();
        for (const std::uint32_t earlier : before[node])
            if (!seen[earlier]) seen[earlier] = true, ++count, open.push_back(earlier);
    }
    return count == nodes;
}

/// The number of times that a tour traverses each arc and ends in each node.
struct Crossings {
    std::vector<std::uint32_t> arcs = {};
    std::vector<std::int64_t> ends = {};  ///< for each node: number of sequences that end in the node (power cycles)
    std::int64_t starts = 1;
};

/// Balances the incoming and outgoing arcs of each node at minimum cost. The additional node with the index `nodes`
/// represents the controller without power, in which sequences start and end.
Crossings balanced(std::uint32_t nodes, std::uint32_t start, const std::vector<TourArc>& arcs) {
    const std::vector<std::uint32_t> distinct = distinct_arcs(arcs);
    const bool several = !strongly_connected(nodes, start, arcs, distinct);
    // The number of sequences is minimized only among tours of minimum length.
    const std::int64_t step_cost = several ? std::int64_t{1} << 32U : 1;
    Flow flow(nodes + 1);
    for (const TourArc& arc : arcs) {
        flow.add_supply(arc.to, 1);
        flow.add_supply(arc.from, -1);
    }
    flow.add_supply(start, 1);
    flow.add_supply(nodes, -1);
    for (const std::uint32_t arc : distinct) flow.add_arc(arcs[arc].from, arcs[arc].to, step_cost);
    for (std::uint32_t node = 0; node < nodes; ++node) flow.add_arc(node, nodes, 0);
    if (several) flow.add_arc(nodes, start, 1);
    flow.solve();
    Crossings crossings{std::vector<std::uint32_t>(arcs.size(), 1), {}, 1};
    for (std::size_t k = 0; k < distinct.size(); ++k)
        crossings.arcs[distinct[k]] += static_cast<std::uint32_t>(flow.flow(k));
    for (std::uint32_t node = 0; node < nodes; ++node) crossings.ends.push_back(flow.flow(distinct.size() + node));
    if (several) crossings.starts += flow.flow(distinct.size() + nodes);
    return crossings;
}

/// Computes an Eulerian circuit that traverses each arc as often as `crossings` states, and begins in the node that
/// represents the controller without power (Hierholzer 1873). If possible, a wait directly follows a step with the same
/// inputs.
class Circuit {
public:
    Circuit(std::uint32_t nodes, std::uint32_t start, const std::vector<TourArc>& arcs, Crossings crossings)
        : nodes_(nodes),
          start_(start),
          arcs_(arcs),
          left_(std::move(crossings)),
          leaving_(nodes, arcs),
          next_(leaving_.first) {
        for (std::uint32_t arc = 0; arc < arcs.size(); ++arc)
            if (arcs[arc].wait_ms != 0) waits_.emplace(key(arcs[arc].from, arcs[arc].inputs), arc);
    }

    std::vector<std::vector<std::uint32_t>> sequences() {
        std::vector<Visit> path{{nodes_, none}};
        std::vector<std::uint32_t> reversed;  // arcs in reverse order; `none` at power-on
        while (!path.empty()) {
            const Visit here = path.back();
            if (const std::uint32_t arc = onwards(here); arc != none) {
                path.push_back({arcs_[arc].to, arc});
            } else if (here.node == nodes_ && left_.starts > 0) {
                --left_.starts;
                path.push_back({start_, none});
            } else if (here.node != nodes_ && left_.ends[here.node] > 0) {
                --left_.ends[here.node];
                path.push_back({nodes_, none});
            } else {
                if (here.node != nodes_) reversed.push_back(here.arc);
                path.pop_back();
            }
        }
        std::vector<std::vector<std::uint32_t>> result;
        for (std::size_t k = reversed.size(); k-- > 0;) {
            if (reversed[k] == none) result.emplace_back();
            else result.back().push_back(reversed[k]);
        }
        return result;
    }

private:
    struct Visit {
        std::uint32_t node = 0;
        std::uint32_t arc = none;  ///< index of the incoming arc
    };

    static std::uint64_t key(std::uint32_t node, std::uint32_t inputs) { return (std::uint64_t{node} << 32U) | inputs; }

    std::uint32_t onwards(const Visit& here) {
        if (here.node == nodes_) return none;
        if (here.arc != none && !waits_.empty()) {
            const auto wait = waits_.find(key(here.node, arcs_[here.arc].inputs));
            if (wait != waits_.end() && left_.arcs[wait->second] > 0) return --left_.arcs[wait->second], wait->second;
        }
        for (std::uint32_t& place = next_[here.node]; place < leaving_.first[here.node + 1]; ++place) {
            const std::uint32_t arc = leaving_.order[place];
            if (left_.arcs[arc] > 0) return --left_.arcs[arc], arc;
        }
        return none;
    }

    std::uint32_t nodes_, start_;
    const std::vector<TourArc>& arcs_;
    Crossings left_;
    Leaving leaving_;
    /// For each node: the first outgoing arc for which traversals may remain.
    std::vector<std::uint32_t> next_;
    std::unordered_map<std::uint64_t, std::uint32_t> waits_ = {};
};

}  // namespace

Tour least_tour(std::uint32_t nodes, std::uint32_t start, const std::vector<TourArc>& arcs) {
    Tour tour;
    tour.sequences = Circuit(nodes, start, arcs, balanced(nodes, start, arcs)).sequences();
    for (const auto& sequence : tour.sequences) tour.length += sequence.size();
    return tour;
}

namespace {

/// Finds the nearest node in a set by breadth-first search.
class NearestSearch {
public:
    NearestSearch(std::uint32_t nodes, const std::vector<TourArc>& arcs)
        : arcs_(arcs), leaving_(nodes, arcs), seen_in_(nodes), by_(nodes) {}

    /// Returns the arcs of a shortest path from `start` to a node in `wanted`, in reverse order, or an empty list if no
    /// node in `wanted` is reachable.
    std::vector<std::uint32_t> path(std::uint32_t start, const std::vector<bool>& wanted) {
        ++round_;
        std::deque<std::uint32_t> queue{start};
        for (; !queue.empty(); queue.pop_front()) {
            const std::uint32_t node = queue.front();
            for (std::uint32_t place = leaving_.first[node]; place < leaving_.first[node + 1]; ++place) {
                const std::uint32_t arc = leaving_.order[place], to = arcs_[arc].to;
                if (std::exchange(seen_in_[to], round_) == round_) continue;
                by_[to] = arc;
                if (wanted[to]) return back(to, start);
                queue.push_back(to);
            }
        }
        return {};
    }

private:
    std::vector<std::uint32_t> back(std::uint32_t node, std::uint32_t start) const {
        std::vector<std::uint32_t> path;
        do {
            path.push_back(by_[node]);
            node = arcs_[path.back()].from;
        } while (node != start);
        return path;
    }

    const std::vector<TourArc>& arcs_;
    Leaving leaving_;
    std::uint32_t round_ = 0;
    /// For each node: the number of the last search that visited the node (`seen_in_`), and the arc by which this
    /// search reached the node (`by_`).
    std::vector<std::uint32_t> seen_in_, by_;
};

}  // namespace

Tour visiting_tour(std::uint32_t nodes, std::uint32_t start, const std::vector<TourArc>& arcs) {
    NearestSearch search(nodes, arcs);
    std::vector<bool> wanted(nodes);
    for (const TourArc& arc : arcs) wanted[arc.to] = true;
    Tour tour;
    tour.sequences.emplace_back();
    std::uint32_t here = start;
    for (auto open = std::ranges::count(wanted, true); open > 0;) {
        const std::vector<std::uint32_t> path = search.path(here, wanted);
        if (path.empty()) {  // the remaining nodes are reachable only after a power cycle
            here = start;
            tour.sequences.emplace_back();
            continue;
        }
        tour.sequences.back().insert(tour.sequences.back().end(), path.rbegin(), path.rend());
        tour.length += path.size();
        here = arcs[path.front()].to;
        wanted[here] = false;
        --open;
    }
    std::erase_if(tour.sequences, [](const auto& sequence) { return sequence.empty(); });
    return tour;
}

}  // namespace grafverif::conform
