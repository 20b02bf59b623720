// SPDX-License-Identifier: MIT
// Represents the elements on a page, and finds violations of the layout rules.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "emit/layout/layout.hpp"

namespace grafverif {

struct Scene {
    std::vector<layout::Box> boxes = {};  ///< the boxes of nodes and labels
    struct Line {
        std::vector<layout::Point> points = {};
        std::size_t net = 0;  ///< lines of one net may overlap
    };
    std::vector<Line> lines = {};
    layout::Box page = {};
};

struct Stretch {
    layout::Point low = {}, high = {};
    bool across() const { return low.y == high.y; }
};

inline std::vector<Stretch> stretches(const Scene::Line& line) {
    std::vector<Stretch> list;
    for (std::size_t k = 1; k < line.points.size(); ++k) {
        const layout::Point a = line.points[k - 1], b = line.points[k];
        list.push_back({{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}});
    }
    return list;
}

inline bool runs_through(const Stretch& line, const layout::Box& box) {
    return line.low.x < box.at.x + box.size.width && line.high.x > box.at.x &&
           line.low.y < box.at.y + box.size.height && line.high.y > box.at.y;
}

inline bool lie_on_each_other(const Stretch& a, const Stretch& b) {
    if (a.across() && b.across()) return a.low.y == b.low.y && a.low.x < b.high.x && b.low.x < a.high.x;
    return a.low.x == b.low.x && a.high.x == b.high.x && a.low.x == a.high.x && a.low.y < b.high.y &&
           b.low.y < a.high.y;
}

inline std::string text_of(layout::Point at) { return std::to_string(at.x) + "," + std::to_string(at.y); }

/// Checks the layout rules of a page, except those about its content.
inline std::vector<std::string> faults(const Scene& scene) {
    std::vector<std::string> found;
    for (std::size_t a = 0; a < scene.boxes.size(); ++a) {
        const layout::Box& box = scene.boxes[a];
        const layout::Point end = {box.at.x + box.size.width, box.at.y + box.size.height};
        if (box.at.x < scene.page.at.x || box.at.y < scene.page.at.y ||
            end.x > scene.page.at.x + scene.page.size.width || end.y > scene.page.at.y + scene.page.size.height)
            found.push_back("a box leaves the page: " + text_of(box.at));
        for (std::size_t b = 0; b < a; ++b)
            if (layout::overlap(box, scene.boxes[b]))
                found.push_back("boxes overlap: " + text_of(box.at) + " and " + text_of(scene.boxes[b].at));
    }
    std::vector<std::pair<Stretch, std::size_t>> all;
    for (const Scene::Line& line : scene.lines)
        for (const Stretch& stretch : stretches(line)) {
            if (!stretch.across() && stretch.low.x != stretch.high.x)
                found.push_back("a line runs askew at " + text_of(stretch.low));
            for (const layout::Box& box : scene.boxes)
                if (runs_through(stretch, box))
                    found.push_back("a line at " + text_of(stretch.low) + " runs through the box " + text_of(box.at));
            for (const auto& [other, net] : all)
                if (net != line.net && lie_on_each_other(stretch, other))
                    found.push_back("two lines lie on each other at " + text_of(stretch.low));
            all.emplace_back(stretch, line.net);
        }
    return found;
}

}  // namespace grafverif
