// SPDX-License-Identifier: MIT
// Places labels without overlaps, near the labelled elements, and if possible without intersecting a link.
#include "emit/layout/layout.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "emit/layout/plane.hpp"
#include "emit/layout/skeleton.hpp"

namespace grafverif::layout {
namespace {

constexpr std::size_t many_links = 300;  // if a graph has more links, links may cross labels

struct Candidate {
    Box box = {};
    double penalty = 0;
    bool astray = false;  ///< true if the label is too far from the element that it describes
};

Box centred(Vector centre, Size size) {
    return {point({centre.x - size.width / 2.0, centre.y - size.height / 2.0}), size};
}

/// Returns the box, enlarged by a margin.
Box aired(const Box& box) {
    constexpr int air = 4;
    return {{box.at.x - air, box.at.y - air}, {box.size.width + 2 * air, box.size.height + 2 * air}};
}

bool is_empty(Size size) { return size.width == 0 || size.height == 0; }

/// Returns candidate positions around a node: above, below, at the corners and at the sides, followed by positions that
/// are farther away.
std::vector<Candidate> around(Vector node, Size size) {
    static constexpr std::array<Vector, 8> sides = {
        {{0, -1}, {0, 1}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {1, 0}, {-1, 0}}};
    std::vector<Candidate> list;
    double penalty = 0;
    for (const double gap : {4.0, 12.0, 28.0, 50.0}) {
        for (const Vector side : sides) {
            const Vector off = {
                side.x * (size.width / 2.0 + (side.y == 0 ? node_radius + gap : gap)),
                side.y * (size.height / 2.0 + (side.x == 0 ? node_radius + gap : node_radius + gap / 2))};
            list.push_back({centred(node + off, size), penalty, gap > 20});
            penalty += 2;
        }
        penalty += 10;
    }
    return list;
}

/// Returns candidate positions next to the middle of a link, on its outer and inner side.
std::vector<Candidate> along(const Route& route, Size size) {
    std::vector<Candidate> list;
    for (const double gap : {5.0, 14.0, 30.0}) {
        for (const double shift : {0.0, -0.1, 0.1, -0.2, 0.2, -0.3, 0.3}) {
            const Vector at = route.middle.from + (0.5 + shift) * (route.middle.to - route.middle.from);
            for (const double side : {1.0, -1.0}) {
                const Vector off = side * (gap + reach(size, route.outward)) * route.outward;
                list.push_back({centred(at + off, size), std::abs(shift) * 40 + (side < 0 ? 6 : 0) + gap, gap > 20});
            }
        }
    }
    return list;
}

/// Returns candidate positions beyond the tip of a loop.
std::vector<Candidate> beyond(const Route& route, Size size) {
    std::vector<Candidate> list;
    const Vector across = normal(route.outward);
    for (const double gap : {5.0, 14.0, 30.0, 60.0}) {
        for (const double shift : {0.0, -0.25, 0.25, -0.5, 0.5}) {
            const Vector off =
                (gap + reach(size, route.outward)) * route.outward + (2 * shift * reach(size, across)) * across;
            list.push_back({centred(route.middle.from + off, size), std::abs(shift) * 20 + gap, gap > 20});
        }
    }
    return list;
}

/// An attempted layout at one scale.
struct Attempt {
    Drawing drawing = {};
    int crossings = 0, astray = 0;
    std::vector<std::pair<Size, Point*>> homeless = {};
    Plane plane = {};
};

class Placer {
public:
    Placer(const Graph& graph, const Skeleton& skeleton) : graph_(graph), skeleton_(skeleton) {}

    void place(Attempt& attempt) {
        attempt_ = &attempt;
        draw_lines();
        for (std::size_t i = 0; i < graph_.nodes.size(); ++i)
            put(graph_.nodes[i], attempt.drawing.nodes[i].label,
                [&](Size size) { return around(skeleton_.nodes[i], size); });
        for (const bool loops : {true, false}) {
            for (std::size_t i = 0; i < graph_.links.size(); ++i) {
                const Graph::Link& link = graph_.links[i];
                if ((link.from == link.to) != loops) continue;
                const Route& route = skeleton_.routes[i];
                put(link.label, attempt.drawing.links[i].label,
                    [&](Size size) { return loops ? beyond(route, size) : along(route, size); });
            }
        }
    }

private:
    void draw_lines() {
        for (const Vector place : skeleton_.nodes) {
            attempt_->drawing.nodes.push_back({point(place), point(place)});
            attempt_->plane.add(node_box(point(place)));
        }
        for (std::size_t i = 0; i < graph_.links.size(); ++i) {
            const Route& route = skeleton_.routes[i];
            Drawing::Link link;
            Vector last = skeleton_.nodes[graph_.links[i].from];
            for (const Vector nail : route.nails) {
                link.nails.push_back(point(nail));
                add_line(last, nail);
                last = nail;
            }
            add_line(last, skeleton_.nodes[graph_.links[i].to]);
            link.label = point(route.middle.from);
            attempt_->drawing.links.push_back(std::move(link));
        }
    }

    void add_line(Vector from, Vector to) {
        if (graph_.links.size() <= many_links) attempt_->plane.add(Segment{from, to});
    }

    template <class Candidates>
    void put(Size size, Point& label, const Candidates& candidates) {
        if (is_empty(size)) return;
        std::optional<Candidate> best;
        int crossed = 0;
        for (const Candidate& candidate : candidates(size)) {
            if (!attempt_->plane.is_free(aired(candidate.box))) continue;
            const int crossings = attempt_->plane.crossings(candidate.box);
            const double penalty = candidate.penalty + 1000.0 * crossings;
            if (best && best->penalty <= penalty) continue;
            best = {candidate.box, penalty, candidate.astray};
            crossed = crossings;
        }
        if (!best) {
            attempt_->homeless.push_back({size, &label});
            return;
        }
        attempt_->crossings += crossed;
        attempt_->astray += best->astray ? 1 : 0;
        attempt_->plane.add(best->box);
        label = best->box.at;
    }

    const Graph& graph_;
    const Skeleton& skeleton_;
    Attempt* attempt_ = nullptr;
};

/// Places the remaining labels in a column below the drawing.
void place_below(Attempt& attempt) {
    int y = attempt.plane.bottom() + 40;
    for (const auto& [size, label] : attempt.homeless) {
        *label = {attempt.plane.left(), y};
        y += size.height + 10;
    }
}

}  // namespace

Drawing draw(const Graph& graph) {
    static constexpr std::array scales = {1.0, 1.15, 1.3, 1.5, 1.7, 2.0, 2.4, 2.8, 4.0, 8.0};
    const Arrangement order = arrangement(graph);
    Attempt best;
    for (std::size_t i = 0; i < scales.size(); ++i) {
        const Skeleton lines = skeleton(graph, order, scales[i]);
        Attempt attempt;
        // Reserves the memory first, because labels refer to nodes by their addresses.
        attempt.drawing.nodes.reserve(graph.nodes.size());
        attempt.drawing.links.reserve(graph.links.size());
        Placer(graph, lines).place(attempt);
        const auto faults = [](const Attempt& a) { return std::pair(a.homeless.size(), a.crossings + a.astray); };
        if (i == 0 || faults(attempt) < faults(best)) best = std::move(attempt);
        const auto [homeless, blemishes] = faults(best);
        if (homeless == 0 && (blemishes == 0 || graph.links.size() > many_links || i >= 7)) break;
    }
    place_below(best);
    return best.drawing;
}

}  // namespace grafverif::layout
