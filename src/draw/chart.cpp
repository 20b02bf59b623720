// SPDX-License-Identifier: MIT
#include "draw/chart.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "draw/routes.hpp"
#include "draw/symbols.hpp"
#include "draw/writing.hpp"

namespace grafverif::draw {

namespace {

using Element = Drawing::Element;
using Point = Drawing::Point;

constexpr int margin = 16, title_height = 22, title_size = 13;
constexpr int greatest_page = 1400;  ///< maximum width of the page in pixels, unless a partial chart is wider

void shift(Element& element, Point by) {
    const auto move = [&](Point& point) { point = {point.x + by.x, point.y + by.y}; };
    for (Drawing::Box& box : element.boxes) move(box.at);
    for (Drawing::Line& line : element.lines)
        for (Point& point : line.points) move(point);
    for (Drawing::Text& text : element.texts) move(text.at);
}

Drawing::Text heading(int x, int y, const std::string& text) {
    return {{x, y}, {{text, false}}, Drawing::Anchor::Start, title_size, width_of(text, title_size), "title"};
}

/// The drawing of a partial chart. The upper left corner is at (0, 0).
struct Panel {
    std::vector<Element> elements = {};
    Drawing::Size size = {};
};

/// The steps and transitions of one partial chart, in the order of the tables.
struct Members {
    std::vector<Id<Chart::Step>> steps = {};
    std::vector<Id<Chart::Transition>> transitions = {};
};

/// Builds the flow of one partial chart, and draws its panel. The nodes of the flow are the steps and transitions of
/// the partial chart.
class PanelMaker {
public:
    PanelMaker(const Chart& chart, const Symbols& symbols, const DrawOptions& options, std::vector<std::size_t>& nodes)
        : chart_(chart), symbols_(symbols), options_(options), nodes_(nodes) {}

    Panel make(const Members& members) {
        for (const Id<Chart::Step> step : members.steps) {
            nodes_[step.index] = flow_.nodes.size();
            add_node(symbols_.step(step), false);
        }
        for (const Id<Chart::Transition> transition : members.transitions)
            add_node(symbols_.transition(transition), true);
        add_links(members);
        for (const auto kind : {&Chart::Step::initial, &Chart::Step::entry, &Chart::Step::activation_link})
            for (const Id<Chart::Step> step : members.steps)
                if (chart_.steps[step].*kind) flow_.roots.push_back(nodes_[step.index]);
        const Order order = order_of(flow_);
        const int digits = static_cast<int>(std::to_string(flow_.arcs.size()).size());
        const Columns columns = columns_of(flow_, order, blocks_of(flow_, order), std::max(16, 7 * digits + 4));
        routes_ = routes_of(flow_, order, columns, options_.columns);
        draw(members, order);
        return {std::move(elements_), routes_.size};
    }

private:
    void add_node(Symbol symbol, bool bar) {
        flow_.add(bar, symbol.port, symbol.space);
        parts_.push_back(std::move(symbol));
    }

    /// Adds the links to the flow in the order of the transitions. For each transition, links from steps precede links
    /// to steps.
    void add_links(const Members& members) {
        for (std::size_t k = 0; k < members.transitions.size(); ++k) {
            const Chart::Transition& transition = chart_.transitions[members.transitions[k]];
            const std::size_t node = members.steps.size() + k;
            for (const Id<Chart::Step> step : transition.from) flow_.link(nodes_[step.index], node);
            for (const Id<Chart::Step> step : transition.to) flow_.link(node, nodes_[step.index]);
        }
    }

    std::string id_of(std::size_t node, const Members& members) const {
        return node < members.steps.size()
                   ? symbols_.ids().steps[members.steps[node].index]
                   : symbols_.ids().transitions[members.transitions[node - members.steps.size()].index];
    }

    void draw(const Members& members, const Order& order) {
        for (std::size_t arc = 0; arc < flow_.arcs.size(); ++arc) {
            const std::string from = id_of(flow_.arcs[arc].from, members), to = id_of(flow_.arcs[arc].to, members);
            elements_.push_back({.classes = order.upward[arc] ? "link upward" : "link",
                                 .data = {{"from", from}, {"to", to}},
                                 .lines = std::move(routes_.arcs[arc])});
        }
        for (Routes::Meeting& meeting : routes_.meetings) {
            Element& bar = parts_[meeting.node].elements.front();
            const Point centre = routes_.nodes[meeting.node];
            Element lines{.lines = std::move(meeting.lines)};
            shift(lines, {-centre.x, -centre.y});
            std::ranges::move(lines.lines, std::back_inserter(bar.lines));
        }
        for (std::size_t node = 0; node < parts_.size(); ++node)
            for (Element& element : parts_[node].elements) {
                shift(element, routes_.nodes[node]);
                elements_.push_back(std::move(element));
            }
        for (const Routes::Reference& reference : routes_.references) add_reference(reference);
    }

    void add_reference(const Routes::Reference& reference) {
        const std::string number = std::to_string(reference.number);
        const int y = reference.at.y + (reference.below ? reference_height - 1 : -3);
        elements_.push_back({.classes = "reference",
                             .title = "this link continues at the other label with the number " + number,
                             .data = {{"number", number}},
                             .texts = {{{reference.at.x, y},
                                        {{number, false}},
                                        Drawing::Anchor::Middle,
                                        10,
                                        width_of(number, 10),
                                        "reference"}}});
    }

    const Chart& chart_;
    const Symbols& symbols_;
    const DrawOptions& options_;
    std::vector<std::size_t>& nodes_;  ///< for each step of the chart: its node in the flow
    Flow flow_ = {};
    std::vector<Symbol> parts_ = {};  ///< for each node: its symbol
    Routes routes_ = {};
    std::vector<Element> elements_ = {};
};

std::string title_of(const Chart& chart, const Chart::PartialChart& partial) {
    const std::string name = shortened(partial.name, 60);
    switch (partial.kind) {
    case Chart::PartialKind::Plain: break;
    case Chart::PartialKind::Expansion:
        return name + ": expansion of " + shortened(chart.steps[partial.owner].name, 60);
    case Chart::PartialKind::Enclosed: return name + ": enclosed in " + shortened(chart.steps[partial.owner].name, 60);
    }
    return name;
}

/// Adds the element of the partial chart to its panel. If the partial chart has a name, the element has a frame and a
/// title.
Panel framed(const Chart& chart, Id<Chart::PartialChart> id, const std::string& element_id, Panel panel) {
    const Chart::PartialChart& partial = chart.partial_charts[id];
    Element frame{.id = element_id, .classes = "partial-chart"};
    switch (partial.kind) {
    case Chart::PartialKind::Plain: break;
    case Chart::PartialKind::Expansion: frame.classes += " expansion"; break;
    case Chart::PartialKind::Enclosed: frame.classes += " enclosed"; break;
    }
    if (!partial.name.empty()) {
        const std::string title = title_of(chart, partial);
        for (Element& element : panel.elements) shift(element, {margin, margin + title_height});
        panel.size.width = std::max(panel.size.width, width_of(title, title_size)) + 2 * margin;
        panel.size.height += title_height + 2 * margin;
        frame.title = title;
        frame.boxes.push_back({{0, 0}, panel.size});
        frame.texts.push_back(heading(margin / 2, title_size + 4, title));
    }
    panel.elements.insert(panel.elements.begin(), std::move(frame));
    return panel;
}

/// Places panels on a page. Each panel is placed as high as possible, and as far to the left as possible at this
/// height.
class Skyline {
public:
    Skyline(int top, int right) : levels_({{margin, top}}), right_(right) {}

    /// Returns the position for a panel of this size, and marks the area of the panel as used.
    Point place(Drawing::Size size) {
        std::size_t best = 0;
        int y = std::numeric_limits<int>::max();
        for (std::size_t k = 0; k < levels_.size() && (k == 0 || levels_[k].x + size.width <= right_); ++k)
            if (const int lowest = lowest_above(k, size.width); lowest < y) best = k, y = lowest;
        const int left = levels_[best].x, end = left + size.width + margin;
        const auto first = levels_.begin() + static_cast<std::ptrdiff_t>(best);
        auto last = first;
        while (last != levels_.end() && last->x < end) ++last;
        std::vector<Point> made = {{left, y + size.height + margin}};
        if (last == levels_.end() || last->x > end) made.push_back({end, std::prev(last)->y});
        levels_.insert(levels_.erase(first, last), made.begin(), made.end());
        return {left, y};
    }

private:
    /// Returns the smallest y at which a panel of the given width that begins at the x of level `k` is below all panels
    /// that have already been placed.
    int lowest_above(std::size_t k, int width) const {
        int lowest = levels_[k].y;
        for (std::size_t j = k; j < levels_.size() && levels_[j].x < levels_[k].x + width + margin; ++j)
            lowest = std::max(lowest, levels_[j].y);
        return lowest;
    }

    /// Upper contour of the free area, with height y from the x of an entry to the x of the next entry.
    std::vector<Point> levels_;
    int right_;
};

struct Packing {
    std::vector<Point> places = {};
    Drawing::Size size = {};

    /// Returns the height of the smallest page with the aspect ratio 14:10 that contains the drawing.
    int page() const { return std::max(size.width * 10 / 14, size.height); }
};

Packing packed(const std::vector<Panel>& panels, int top, int right) {
    Skyline skyline(top, right);
    Packing made{.size = {0, top + margin}};
    for (const Panel& panel : panels) {
        const Point at = made.places.emplace_back(skyline.place(panel.size));
        made.size.width = std::max(made.size.width, at.x + panel.size.width + margin);
        made.size.height = std::max(made.size.height, at.y + panel.size.height + margin);
    }
    return made;
}

/// Places the panels for several page widths, and uses the smallest page.
void place(std::vector<Panel> panels, int top, Drawing& drawing) {
    constexpr int tries = 12;
    int widest = 0;
    for (const Panel& panel : panels) widest = std::max(widest, panel.size.width);
    Packing best = packed(panels, top, margin + std::max(widest, greatest_page));
    for (int k = 0; k < tries && widest < greatest_page; ++k) {
        Packing other = packed(panels, top, margin + widest + (greatest_page - widest) * k / tries);
        const bool narrower = other.page() == best.page() && other.size.width < best.size.width;
        if (other.page() < best.page() || narrower) best = std::move(other);
    }
    for (std::size_t k = 0; k < panels.size(); ++k)
        for (Element& element : panels[k].elements) {
            shift(element, best.places[k]);
            drawing.elements.push_back(std::move(element));
        }
    drawing.size = {std::max(drawing.size.width, best.size.width), best.size.height};
}

}  // namespace

Drawing drawing_of(const Chart& chart, const DrawOptions& options, const ChartText& text) {
    const Symbols symbols(chart, options, text);
    std::vector<Members> members(chart.partial_charts.size());
    for (const Id<Chart::Step> step : chart.steps.ids()) members[chart.steps[step].chart.index].steps.push_back(step);
    for (const Id<Chart::Transition> transition : chart.transitions.ids())
        members[chart.transitions[transition].chart.index].transitions.push_back(transition);

    Drawing drawing{.title = chart.name};
    const std::string title = shortened(chart.name, 80);
    drawing.elements.push_back({.classes = "chart-title", .texts = {heading(margin, margin + title_size, title)}});
    drawing.size = {width_of(title, title_size) + 2 * margin, 0};
    std::vector<std::size_t> nodes(chart.steps.size(), 0);
    std::vector<Panel> panels;
    for (const Id<Chart::PartialChart> partial : chart.partial_charts.ids()) {
        if (members[partial.index].steps.empty() && members[partial.index].transitions.empty()) continue;
        Panel panel = PanelMaker(chart, symbols, options, nodes).make(members[partial.index]);
        panels.push_back(framed(chart, partial, symbols.ids().partial_charts[partial.index], std::move(panel)));
    }
    place(std::move(panels), 2 * margin + title_size, drawing);
    return drawing;
}

}  // namespace grafverif::draw
