// SPDX-License-Identifier: MIT
// Computes the order and positions of the nodes, the lanes of parallel links and the directions of loops.
#include "emit/layout/skeleton.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

namespace grafverif::layout {
namespace {

using Pair = std::pair<std::size_t, std::size_t>;

constexpr double pi = std::numbers::pi;
constexpr std::size_t longest_line = 6;   // maximum number of nodes on a line; a longer path is drawn as a ring
constexpr std::size_t fully_ordered = 8;  // maximum number of nodes for which every order on the ring is tried
constexpr std::size_t somewhat_ordered = 30;
constexpr double lane_offset = 16;
constexpr double label_gap = 6;

std::set<Pair> connections(const Graph& graph) {
    std::set<Pair> pairs;
    for (const auto& [from, to, label] : graph.links)
        if (from != to) pairs.insert(std::minmax(from, to));
    return pairs;
}

/// Returns the neighbours of each node.
std::vector<std::vector<std::size_t>> neighbours(std::size_t nodes, const std::set<Pair>& pairs) {
    std::vector<std::vector<std::size_t>> next(nodes);
    for (const auto& [a, b] : pairs) {
        next[a].push_back(b);
        next[b].push_back(a);
    }
    return next;
}

/// Returns the nodes from one end of the path to the other, or an empty list if the links do not form a path over all
/// nodes.
std::vector<std::size_t> path_order(std::size_t nodes, const std::set<Pair>& pairs) {
    if (nodes == 0 || nodes > longest_line || pairs.size() + 1 != nodes) return {};
    const std::vector<std::vector<std::size_t>> next = neighbours(nodes, pairs);
    if (std::ranges::any_of(next, [](const auto& list) { return list.size() > 2; })) return {};
    const auto end = std::ranges::find_if(next, [](const auto& list) { return list.size() < 2; });
    std::vector<std::size_t> order = {static_cast<std::size_t>(end - next.begin())};
    std::vector<bool> seen(nodes);
    seen[order.back()] = true;
    for (bool grown = true; grown;) {
        grown = false;
        for (const std::size_t node : next[order.back()]) {
            if (seen[node]) continue;
            seen[node] = grown = true;
            order.push_back(node);
            break;
        }
    }
    return order.size() == nodes ? order : std::vector<std::size_t>{};
}

/// Returns the sum of the squared distances of linked nodes on the ring. The squares penalize long links.
std::size_t spread(const std::vector<std::size_t>& order, const std::set<Pair>& pairs) {
    std::vector<std::size_t> place(*std::ranges::max_element(order) + 1);
    for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
    std::size_t sum = 0;
    for (const auto& [a, b] : pairs) {
        const std::size_t apart = place[a] > place[b] ? place[a] - place[b] : place[b] - place[a];
        const std::size_t around = std::min(apart, order.size() - apart);
        sum += around * around;
    }
    return sum;
}

/// Returns the order of nodes on the ring: the given order, unless another order has shorter links.
std::vector<std::size_t> ring_order(std::vector<std::size_t> best, const std::set<Pair>& pairs) {
    const std::size_t nodes = best.size();
    if (nodes <= 3) return best;
    std::size_t least = spread(best, pairs);
    const auto consider = [&](const std::vector<std::size_t>& order) {
        const std::size_t sum = spread(order, pairs);
        if (sum < least) {
            least = sum;
            best = order;
        }
    };
    if (nodes <= fully_ordered) {
        std::vector<std::size_t> order = best;
        while (std::next_permutation(order.begin() + 1, order.end())) consider(order);
    } else if (nodes <= somewhat_ordered) {
        for (std::size_t before = least + 1; least < before;) {
            before = least;
            for (std::size_t i = 1; i < nodes; ++i) {
                for (std::size_t j = i + 1; j < nodes; ++j) {
                    std::vector<std::size_t> order = best;
                    std::swap(order[i], order[j]);
                    consider(order);
                }
            }
        }
    }
    return best;
}

/// Returns an arrangement in which the nodes with only one neighbour are outside of the ring of all other nodes.
Arrangement ring_with_pendants(std::size_t nodes, const std::set<Pair>& pairs) {
    const std::vector<std::vector<std::size_t>> next = neighbours(nodes, pairs);
    const auto is_pendant = [&](std::size_t node) {
        return next[node].size() == 1 && next[next[node].front()].size() > 1;
    };
    Arrangement ring;
    std::vector<std::size_t> others;
    for (std::size_t node = 0; node < nodes; ++node) {
        if (is_pendant(node)) ring.pendants.push_back({node, next[node].front()});
        else others.push_back(node);
    }
    std::set<Pair> inner = pairs;
    for (const auto& [node, anchor] : ring.pendants) inner.erase(std::minmax(node, anchor));
    ring.order = ring_order(std::move(others), inner);
    return ring;
}

int widest(const Graph& graph) {
    int width = 0;
    for (const Graph::Link& link : graph.links) width = std::max(width, link.label.width);
    return width;
}

std::vector<Vector> on_line(const Graph& graph, const std::vector<std::size_t>& order, double scale) {
    std::map<Pair, int> width;
    for (const auto& [from, to, label] : graph.links) {
        int& most = width[std::minmax(from, to)];
        most = std::max(most, label.width);
    }
    std::vector<Vector> places(graph.nodes.size());
    double x = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i > 0) x += scale * std::max(130, width[std::minmax(order[i - 1], order[i])] + 70);
        places[order[i]] = {x, 0};
    }
    return places;
}

std::vector<Vector> on_ring(const Graph& graph, const std::vector<std::size_t>& order, double scale) {
    if (order.size() == 1) return std::vector<Vector>(graph.nodes.size());
    const auto count = static_cast<double>(order.size());
    const double side = scale * std::clamp(0.75 * widest(graph), 170.0, 320.0);
    const double radius = side / (2 * std::sin(pi / count));
    // A ring with an even number of nodes has a flat top.
    const double start = -pi / 2 - (order.size() % 2 == 0 ? pi / count : 0);
    std::vector<Vector> places(graph.nodes.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Vector towards = direction(start + 2 * pi * static_cast<double>(i) / count);
        places[order[i]] = {1.3 * radius * towards.x, 0.9 * radius * towards.y};
    }
    return places;
}

/// Places pendant nodes next to their neighbours, in the direction away from the centre. Several pendants of one
/// neighbour are arranged as a fan.
void place_pendants(const Graph& graph, const std::vector<Arrangement::Pendant>& pendants, double scale,
                    std::vector<Vector>& places) {
    constexpr double fan = 0.7;
    std::map<std::size_t, int> placed;
    for (const auto& [node, anchor] : pendants) {
        Size label = {60, 40};
        for (const Graph::Link& link : graph.links) {
            if (link.from != node && link.to != node) continue;
            label = {std::max(label.width, link.label.width), std::max(label.height, link.label.height)};
        }
        const Vector at = places[anchor];
        const double away = std::abs(at.x) < 1 ? (at.y < 0 ? -pi / 2 : pi / 2) : (at.x < 0 ? pi : 0);
        const int ordinal = placed[anchor]++;
        const double angle = away + fan * (ordinal % 2 == 0 ? ordinal / 2 : -(ordinal + 1) / 2);
        places[node] = at + std::sqrt(scale) * (2 * reach(label, direction(angle)) + 70) * direction(angle);
    }
}

/// Returns the positions of the nodes, on a grid of eight pixels.
std::vector<Vector> places(const Graph& graph, const Arrangement& arrangement, double scale) {
    std::vector<Vector> list =
        arrangement.line ? on_line(graph, arrangement.order, scale) : on_ring(graph, arrangement.order, scale);
    place_pendants(graph, arrangement.pendants, scale, list);
    for (Vector& place : list) place = {8 * std::round(place.x / 8), 8 * std::round(place.y / 8)};
    return list;
}

/// True if no two nodes are too close together.
bool has_clearance(const std::vector<Vector>& places) {
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (length(places[i] - places[j]) < 100) return false;
    return true;
}

/// The links between two nodes, grouped by the side of the straight line on which they are drawn.
struct Bundle {
    std::vector<std::size_t> outer = {}, inner = {};
};

/// Distributes the links of each pair of nodes over the two sides of the straight line between the nodes. Links that
/// lead forward in the order of the nodes are on the outer side, and backward links are on the inner side. If all links
/// have the same direction, they are distributed over both sides.
std::map<Pair, Bundle> bundles(const Graph& graph, const Arrangement& arrangement) {
    std::vector<std::size_t> place(graph.nodes.size());
    for (std::size_t i = 0; i < arrangement.order.size(); ++i) place[arrangement.order[i]] = i;
    for (std::size_t i = 0; i < arrangement.pendants.size(); ++i)
        place[arrangement.pendants[i].node] = arrangement.order.size() + i;
    std::map<Pair, Bundle> all;
    for (std::size_t i = 0; i < graph.links.size(); ++i) {
        const auto& [from, to, label] = graph.links[i];
        if (from == to) continue;
        const bool forward = place[from] < place[to];
        Bundle& bundle = all[forward ? Pair(from, to) : Pair(to, from)];
        (forward ? bundle.outer : bundle.inner).push_back(i);
    }
    for (auto& [pair, bundle] : all) {
        auto& [outer, inner] = bundle;
        if (outer.empty()) std::swap(outer, inner);
        if (!inner.empty() || outer.size() == 1) continue;
        const auto half = outer.begin() + static_cast<std::ptrdiff_t>((outer.size() + 1) / 2);
        inner.assign(half, outer.end());
        outer.erase(half, outer.end());
    }
    return all;
}

class Router {
public:
    Router(const Graph& graph, Skeleton& skeleton) : graph_(graph), skeleton_(skeleton), angles_(graph.nodes.size()) {}

    void route_bundles(const std::map<Pair, Bundle>& bundles) {
        Vector sum;
        for (const Vector place : skeleton_.nodes) sum = sum + place;
        centre_ = (1 / static_cast<double>(skeleton_.nodes.size())) * sum;
        for (const auto& [pair, bundle] : bundles) {
            const bool single = bundle.outer.size() + bundle.inner.size() == 1;
            const Vector out = outward(pair);
            route_lanes(bundle.outer, pair, out, single ? 0 : lane_offset);
            route_lanes(bundle.inner, pair, -1 * out, lane_offset);
        }
    }

    void route_loops(double scale) {
        std::vector<std::vector<std::size_t>> loops(graph_.nodes.size());
        for (std::size_t i = 0; i < graph_.links.size(); ++i)
            if (graph_.links[i].from == graph_.links[i].to) loops[graph_.links[i].from].push_back(i);
        for (std::size_t node = 0; node < loops.size(); ++node) {
            const auto count = static_cast<double>(loops[node].size());
            const double spread = std::min(0.36, 0.7 * pi / std::max(1.0, count));
            const bool alone = angles_[node].empty();
            for (std::size_t i = 0; i < loops[node].size(); ++i) {
                const double even = -pi / 2 + 2 * pi * static_cast<double>(i) / count;
                route_loop(loops[node][i], node, 46 * scale, alone ? even : widest_gap(angles_[node]), spread);
            }
        }
    }

private:
    /// Returns the normal of the straight line between a pair of nodes. The normal points away from the centre, or
    /// upwards if the line intersects the centre.
    Vector outward(const Pair& pair) const {
        const Vector a = skeleton_.nodes[pair.first], b = skeleton_.nodes[pair.second];
        const Vector across = unit(normal(b - a));
        const Vector away = 0.5 * (a + b) - centre_;
        const double side = across.x * away.x + across.y * away.y;
        const bool keep = std::abs(side) < 1 ? across.y < 0 : side > 0;
        return keep ? across : -1 * across;
    }

    void route_lanes(const std::vector<std::size_t>& links, const Pair& pair, Vector out, double offset) {
        const Vector a = skeleton_.nodes[pair.first], b = skeleton_.nodes[pair.second];
        const Vector along = unit(b - a);
        for (const std::size_t link : links) {
            Route& route = skeleton_.routes[link];
            route.outward = out;
            route.middle = {a, b};
            if (offset > 0) {
                const double slope = std::min(0.35 * length(b - a), 14 + 0.7 * offset);
                route.middle = {a + slope * along + offset * out, b - slope * along + offset * out};
                route.nails = {route.middle.from, route.middle.to};
                if (graph_.links[link].from == pair.second) std::swap(route.nails[0], route.nails[1]);
            }
            note_angle(pair.first, route.nails.empty() ? b : route.middle.from);
            note_angle(pair.second, route.nails.empty() ? a : route.middle.to);
            offset += 2 * reach(graph_.links[link].label, out) + 2 * label_gap + lane_offset / 2;
        }
    }

    void note_angle(std::size_t node, Vector towards) {
        const Vector step = towards - skeleton_.nodes[node];
        angles_[node].push_back(std::atan2(step.y, step.x));
    }

    void route_loop(std::size_t link, std::size_t node, double size, double angle, double spread) {
        const Vector centre = skeleton_.nodes[node];
        const Vector tip = centre + size * std::cos(spread) * direction(angle);
        skeleton_.routes[link] = {
            {centre + size * direction(angle - spread), centre + size * direction(angle + spread)},
            {tip, tip},
            direction(angle)};
        for (const double side : {angle - spread, angle + spread})
            angles_[node].push_back(std::remainder(side, 2 * pi));
    }

    /// Returns the middle of the widest gap between `angles`. If several gaps are equal, the one nearest to the upward
    /// direction is used.
    static double widest_gap(std::vector<double> angles) {
        if (angles.empty()) return -pi / 2;
        std::ranges::sort(angles);
        double best = -pi / 2, width = -1;
        for (std::size_t i = 0; i < angles.size(); ++i) {
            const double next = i + 1 < angles.size() ? angles[i + 1] : angles.front() + 2 * pi;
            const double gap = next - angles[i], middle = (angles[i] + next) / 2;
            const bool wider = gap > width + 0.05;
            const bool upper = gap > width - 0.05 && std::sin(middle) < std::sin(best) - 1e-6;
            if (wider || upper) {
                width = std::max(width, gap);
                best = middle;
            }
        }
        return best;
    }

    const Graph& graph_;
    Skeleton& skeleton_;
    std::vector<std::vector<double>> angles_;  // angles of the links at each node
    Vector centre_ = {};
};

}  // namespace

Arrangement arrangement(const Graph& graph) {
    const std::set<Pair> pairs = connections(graph);
    const std::size_t nodes = graph.nodes.size();
    if (std::vector<std::size_t> line = path_order(nodes, pairs); !line.empty()) return {true, std::move(line), {}};
    if (nodes <= somewhat_ordered) {
        Arrangement ring = ring_with_pendants(nodes, pairs);
        if (has_clearance(places(graph, ring, 1))) return ring;
    }
    std::vector<std::size_t> order(nodes);
    std::iota(order.begin(), order.end(), std::size_t{0});
    return {false, ring_order(std::move(order), pairs), {}};
}

Skeleton skeleton(const Graph& graph, const Arrangement& arrangement, double scale) {
    Skeleton skeleton;
    skeleton.nodes = places(graph, arrangement, scale);
    skeleton.routes.resize(graph.links.size());
    if (graph.nodes.empty()) return skeleton;
    Router router(graph, skeleton);
    router.route_bundles(bundles(graph, arrangement));
    router.route_loops(scale);
    return skeleton;
}

}  // namespace grafverif::layout
