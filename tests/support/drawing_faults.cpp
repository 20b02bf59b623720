// SPDX-License-Identifier: MIT
#include "support/drawing_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace grafverif {

namespace {

struct Area {
    int left = 0, top = 0, right = 0, bottom = 0;
    std::size_t element = 0;
    bool frame = false;  ///< the area is the frame of a partial chart, which its content may overlap
};

bool meet(const Area& a, const Area& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

bool contains(const Area& outer, const Area& inner) {
    return outer.left <= inner.left && inner.right <= outer.right && outer.top <= inner.top &&
           inner.bottom <= outer.bottom;
}

Area area_of(const Drawing::Box& box, std::size_t element, bool frame) {
    return {box.at.x, box.at.y, box.at.x + box.size.width, box.at.y + box.size.height, element, frame};
}

Area area_of(const Drawing::Text& text, std::size_t element) {
    const int left = text.anchor == Drawing::Anchor::Start    ? text.at.x
                     : text.anchor == Drawing::Anchor::Middle ? text.at.x - (text.width + 1) / 2
                                                              : text.at.x - text.width;
    return {left, text.at.y - text.size * 3 / 4, left + text.width, text.at.y + text.size / 5, element, false};
}

/// Calls `pair` for all pairs of areas whose horizontal ranges overlap, in a sweep from left to
/// right.
void each_pair(std::vector<Area> areas, const std::function<void(const Area&, const Area&)>& pair) {
    std::ranges::sort(areas, {}, &Area::left);
    for (std::size_t k = 0; k < areas.size(); ++k)
        for (std::size_t other = k + 1; other < areas.size() && areas[other].left < areas[k].right; ++other)
            pair(areas[k], areas[other]);
}

class Inspection {
public:
    explicit Inspection(const Drawing& drawing) : drawing_(drawing) {}

    std::vector<std::string> run() {
        for (std::size_t k = 0; k < drawing_.elements.size(); ++k) collect(k);
        look_at_areas();
        look_at_lines();
        return std::move(found_);
    }

private:
    static bool is(const Drawing::Element& element, const char* word) {
        return (' ' + element.classes + ' ').find(fmt::format(" {} ", word)) != std::string::npos;
    }

    std::string name(std::size_t element) const {
        const Drawing::Element& named = drawing_.elements[element];
        return named.id.empty() ? fmt::format("{} {}", named.classes, element) : named.id;
    }

    void collect(std::size_t number) {
        const Drawing::Element& element = drawing_.elements[number];
        const bool frame = is(element, "partial-chart");
        const Area page{0, 0, drawing_.size.width, drawing_.size.height, 0, false};
        const auto add = [&](std::vector<Area>& areas, const Area& area) {
            areas.push_back(area);
            if (!contains(page, area)) found_.push_back(name(number) + ": off the page");
        };
        for (const Drawing::Box& box : element.boxes) add(boxes_, area_of(box, number, frame));
        for (const Drawing::Text& text : element.texts) {
            add(texts_, area_of(text, number));
            const bool in_box = text.kind == "label" || (text.kind == "name" && is(element, "step"));
            if (in_box && !contains(area_of(element.boxes.front(), number, false), texts_.back()))
                found_.push_back(name(number) + ": the text does not fit into its box");
        }
        bool up = false, arrow = false;
        for (const Drawing::Line& line : element.lines) {
            arrow = arrow || line.arrow;
            for (std::size_t k = 1; k < line.points.size(); ++k) {
                const auto [from, to] = std::pair(line.points[k - 1], line.points[k]);
                if (from.x != to.x && from.y != to.y) found_.push_back(name(number) + ": an oblique line");
                up = up || to.y < from.y;
                lines_.push_back({std::min(from.x, to.x), std::min(from.y, to.y), std::max(from.x, to.x),
                                  std::max(from.y, to.y), number, false});
            }
        }
        if (is(element, "link") && up != arrow)
            found_.push_back(name(number) + ": a link must have an arrow exactly if it leads upward");
        if (is(element, "link") && element.lines.empty()) found_.push_back(name(number) + ": no line");
    }

    void look_at_areas() {
        std::vector<Area> all = boxes_;
        all.insert(all.end(), texts_.begin(), texts_.end());
        each_pair(std::move(all), [&](const Area& a, const Area& b) {
            if (a.element == b.element || !meet(a, b)) return;
            const bool inside = (a.frame && contains(a, b)) || (b.frame && contains(b, a));
            if (!inside) found_.push_back(name(a.element) + " overlaps " + name(b.element));
        });
        each_pair(texts_, [&](const Area& a, const Area& b) {
            if (a.element == b.element && meet(a, b)) found_.push_back(name(a.element) + ": its texts overlap");
        });
    }

    /// Checks the lines. A line may end at a box, and may run along the edge of the element that it belongs to.
    void look_at_lines() {
        std::vector<Area> areas;
        for (const auto* list : {&boxes_, &texts_})
            for (const Area& area : *list)
                if (!area.frame) areas.push_back(area);
        const std::size_t count = areas.size();
        std::vector<Area> all = areas;
        all.insert(all.end(), lines_.begin(), lines_.end());
        for (std::size_t k = count; k < all.size(); ++k) all[k].frame = true;  // here, `frame` marks lines
        for (Area& area : all)
            if (area.frame) --area.left, ++area.right;  // a vertical line gets a positive width for the sweep
        each_pair(std::move(all), [&](const Area& a, const Area& b) {
            if (a.frame == b.frame || a.element == b.element) return;
            Area line = a.frame ? a : b;
            ++line.left, --line.right;
            const Area& area = a.frame ? b : a;
            const bool through = line.left == line.right ? area.left < line.left && line.left < area.right &&
                                                               line.top < area.bottom && area.top < line.bottom
                                                         : area.top < line.top && line.top < area.bottom &&
                                                               line.left < area.right && area.left < line.right;
            if (through) found_.push_back(name(line.element) + " crosses " + name(area.element));
        });
    }

    const Drawing& drawing_;
    std::vector<Area> boxes_ = {}, texts_ = {}, lines_ = {};
    std::vector<std::string> found_ = {};
};

}  // namespace

std::vector<std::string> faults(const Drawing& drawing) { return Inspection(drawing).run(); }

}  // namespace grafverif
