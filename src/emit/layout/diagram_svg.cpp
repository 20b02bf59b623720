// SPDX-License-Identifier: MIT
// Diagrams as SVG: places from layout; a character is taken as seven pixels wide, a line as sixteen high.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "emit/layout/diagram.hpp"
#include "emit/layout/layout.hpp"
#include "support/xml_text.hpp"

namespace grafverif {

namespace {

using layout::Point;
using layout::Size;

constexpr int character_width = 7, line_height = 16, drawing_margin = 24;

Size label_size(const std::vector<std::string>& lines) {
    std::size_t longest = 0;
    for (const std::string& line : lines) longest = std::max(longest, line.size());
    return {static_cast<int>(longest) * character_width, static_cast<int>(lines.size()) * line_height};
}

class SvgWriter {
public:
    SvgWriter(const Diagram& diagram, std::ostream& out) : diagram_(diagram), out_(out) {
        layout::Graph graph;
        for (const Diagram::Node& node : diagram.nodes) graph.nodes.push_back(label_size(node.lines));
        for (const Diagram::Arrow& arrow : diagram.arrows)
            graph.links.push_back({arrow.from, arrow.to, label_size(arrow.lines)});
        drawing_ = layout::draw(graph);
    }

    void write() {
        frame();
        for (std::size_t k = 0; k < diagram_.arrows.size(); ++k) arrow(diagram_.arrows[k], drawing_.links[k]);
        for (std::size_t k = 0; k < diagram_.nodes.size(); ++k) node(k, drawing_.nodes[k]);
        out_ << "</svg>\n";
    }

private:
    void reach(Point point) {
        low_ = {std::min(low_.x, point.x), std::min(low_.y, point.y)};
        high_ = {std::max(high_.x, point.x), std::max(high_.y, point.y)};
    }

    void reach(Point at, Size size) {
        reach(at);
        reach({at.x + size.width, at.y + size.height});
    }

    void frame() {
        if (!drawing_.nodes.empty()) low_ = high_ = drawing_.nodes.front().centre;
        for (std::size_t k = 0; k < drawing_.nodes.size(); ++k) {
            const layout::Box box = layout::node_box(drawing_.nodes[k].centre);
            reach(box.at, box.size);
            reach(drawing_.nodes[k].label, label_size(diagram_.nodes[k].lines));
        }
        for (std::size_t k = 0; k < drawing_.links.size(); ++k) {
            for (const Point nail : drawing_.links[k].nails) reach(nail);
            reach(drawing_.links[k].label, label_size(diagram_.arrows[k].lines));
        }
        const int width = high_.x - low_.x + 2 * drawing_margin, height = high_.y - low_.y + 2 * drawing_margin;
        out_
            << fmt::format(
                   "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"{2} {3} {0} {1}\" "
                   "font-family=\"sans-serif\" font-size=\"12\">\n",
                   width, height, low_.x - drawing_margin, low_.y - drawing_margin)
            << fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"white\"/>\n",
                           low_.x - drawing_margin, low_.y - drawing_margin, width, height)
            << "<defs><marker id=\"tip\" viewBox=\"0 0 10 10\" refX=\"9\" refY=\"5\" markerWidth=\"8\" "
               "markerHeight=\"8\" orient=\"auto\">"
               "<path d=\"M0 0 L10 5 L0 10 z\" fill=\"#444\"/></marker></defs>\n";
    }

    void text(const std::vector<std::string>& lines, Point at, const char* style) {
        for (std::size_t k = 0; k < lines.size(); ++k) {
            std::string escaped;
            escape_xml(lines[k], escaped);
            out_ << fmt::format("<text x=\"{}\" y=\"{}\" {}>{}</text>\n", at.x,
                                at.y + line_height * static_cast<int>(k + 1) - 4, style, escaped);
        }
    }

    void node(std::size_t number, const layout::Drawing::Node& place) {
        const Diagram::Node& node = diagram_.nodes[number];
        if (node.initial)
            out_ << fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"white\" stroke=\"black\"/>\n",
                                place.centre.x, place.centre.y, layout::node_radius);
        out_ << fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"#eef\" stroke=\"black\"/>\n", place.centre.x,
                            place.centre.y, layout::node_radius - (node.initial ? 3 : 0))
             << fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", place.centre.x,
                            place.centre.y + 4, number);
        text(node.lines, place.label, "font-weight=\"bold\"");
    }

    /// From the rim of one node to the rim of the other.
    void arrow(const Diagram::Arrow& arrow, const layout::Drawing::Link& place) {
        std::vector<Point> points{drawing_.nodes[arrow.from].centre};
        points.insert(points.end(), place.nails.begin(), place.nails.end());
        points.push_back(drawing_.nodes[arrow.to].centre);
        if (points.size() > 1) {
            points.front() = rim(points.front(), points[1]);
            points.back() = rim(points.back(), points[points.size() - 2]);
        }
        out_ << "<polyline fill=\"none\" stroke=\"#444\" marker-end=\"url(#tip)\""
             << (arrow.dashed ? " stroke-dasharray=\"4 3\"" : "") << " points=\"";
        for (const Point point : points) out_ << point.x << ',' << point.y << ' ';
        out_ << "\"/>\n";
        text(arrow.lines, place.label, arrow.dashed ? "fill=\"#a00\"" : "fill=\"#225\"");
    }

    static Point rim(Point centre, Point towards) {
        const double dx = towards.x - centre.x, dy = towards.y - centre.y, length = std::hypot(dx, dy);
        if (length < 1) return centre;
        return {centre.x + static_cast<int>(std::lround(dx * layout::node_radius / length)),
                centre.y + static_cast<int>(std::lround(dy * layout::node_radius / length))};
    }

    const Diagram& diagram_;
    std::ostream& out_;
    layout::Drawing drawing_ = {};
    Point low_ = {}, high_ = {};
};

}  // namespace

void emit_svg(const Diagram& diagram, std::ostream& out) { SvgWriter(diagram, out).write(); }

}  // namespace grafverif
