// SPDX-License-Identifier: MIT
// Writes diagrams as SVG: a layered drawing, in the direction that results in the smaller page, or a table. The font is
// monospaced, so that each text fits its box in every viewer.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <ostream>
#include <utility>

#include "emit/layout/diagram.hpp"
#include "emit/layout/layered.hpp"
#include "emit/wrapped_text.hpp"
#include "support/printable.hpp"
#include "support/xml_text.hpp"

namespace grafverif {

namespace {

using layout::Box;
using layout::Direction;
using layout::Layered;
using layout::Point;
using layout::Size;

constexpr int character_width = 7, line_height = 14, padding = 7, drawing_margin = 20;

using Lines = std::vector<std::string>;

int columns(std::string_view text) {
    std::size_t count = 0;
    while (!text.empty()) {
        const Glyph glyph = first_glyph(text);
        count += glyph.columns;
        text.remove_prefix(glyph.bytes);
    }
    return static_cast<int>(count);
}

Size text_size(const Lines& lines) {
    int longest = 0;
    for (const std::string& line : lines) longest = std::max(longest, columns(line));
    return {longest * character_width, static_cast<int>(lines.size()) * line_height};
}

/// Breaks lines after operators and commas.
Lines broken(const Lines& lines, std::size_t width) {
    Lines result;
    for (const std::string& line : lines)
        for (const std::string_view part : wrapped(line, width, [](std::string_view before) {
                 return before.ends_with(',') || before.ends_with(" &&") || before.ends_with(" ||") ||
                        before.ends_with(" and") || before.ends_with(" or") || before.ends_with(':') ||
                        before.ends_with(" /");
             }))
            result.emplace_back(part);
    return result;
}

/// The texts of a diagram as lines, with their positions.
struct Page {
    std::vector<Lines> nodes = {}, arrows = {};
    Layered places = {};
    /// Returns the height of the smallest landscape page with the aspect ratio 3:2 that contains the drawing.
    int side() const { return std::max(2 * places.size.width / 3, places.size.height); }
};

/// Returns the table: all nodes in one column, each with its arrows and the numbers of the target nodes.
Layered table(const layout::States& states) {
    constexpr int gap = 10, row_gap = 3;
    Layered places;
    int widest = 0, longest = 0, y = 0;
    for (const Size& node : states.nodes) widest = std::max(widest, node.width);
    for (const layout::States::Arrow& arrow : states.arrows) longest = std::max(longest, arrow.label.width);
    std::vector<std::vector<std::size_t>> arrows(states.nodes.size());
    for (std::size_t k = 0; k < states.arrows.size(); ++k) arrows[states.arrows[k].from].push_back(k);
    places.arrows.resize(states.arrows.size());
    for (std::size_t node = 0; node < states.nodes.size(); ++node) {
        int height = 0;
        for (const std::size_t k : arrows[node]) {
            places.arrows[k].label = {{widest + gap, y + height}, states.arrows[k].label};
            height += states.arrows[k].label.height + row_gap;
        }
        height = std::max(height, states.nodes[node].height);
        places.nodes.push_back({{0, y}, {widest, height}});
        y += height + gap;
    }
    places.size = {widest + gap + longest, y};
    return places;
}

/// Returns the page with a drawing in the given direction, or with a table if `direction` is empty.
Page page(const Diagram& diagram, std::optional<Direction> direction) {
    constexpr std::size_t node_width = 36;
    const std::size_t label_width = !direction ? 100 : direction == Direction::Across ? 60 : 32;
    Page page;
    layout::States states;
    for (std::size_t k = 0; k < diagram.nodes.size(); ++k) {
        Lines lines = diagram.nodes[k].lines;
        if (diagram.numbered) lines.front() = fmt::format("{}: {}", k, lines.front());
        page.nodes.push_back(broken(lines, node_width));
        const Size text = text_size(page.nodes.back());
        states.nodes.push_back({text.width + 2 * padding, text.height + 2 * padding});
        if (diagram.nodes[k].initial) states.first = k;
    }
    for (const Diagram::Arrow& arrow : diagram.arrows) {
        Lines lines = arrow.lines;
        if (arrow.dashed) lines.front() = "never stable: " + lines.front();
        else if (!direction)
            lines.front() =
                fmt::format("to {}: {}", diagram.numbered ? std::to_string(arrow.to) : diagram.nodes[arrow.to].lines[0],
                            lines.front());
        page.arrows.push_back(broken(lines, label_width));
        states.arrows.push_back({arrow.from, arrow.to, text_size(page.arrows.back()), arrow.dashed});
    }
    page.places = direction ? layout::layered(states, *direction) : table(states);
    return page;
}

class SvgWriter {
public:
    SvgWriter(const Diagram& diagram, const Page& page, std::ostream& out, std::string_view prefix)
        : diagram_(diagram), page_(page), out_(out), prefix_(prefix) {}

    void write() {
        const Size size = {page_.places.size.width + 2 * drawing_margin, page_.places.size.height + 2 * drawing_margin};
        out_ << fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"-{2}.5 -{2}.5 {0} {1}\" "
            "font-family=\"'DejaVu Sans Mono', 'Liberation Mono', monospace\" font-size=\"11\">\n"
            "<rect x=\"-{2}\" y=\"-{2}\" width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n"
            "<defs><marker id=\"{3}tip\" viewBox=\"0 0 10 10\" refX=\"10\" refY=\"5\" markerWidth=\"8\" "
            "markerHeight=\"8\" orient=\"auto\"><path d=\"M0 1 L10 5 L0 9 z\" fill=\"#444\"/></marker></defs>\n",
            size.width, size.height, drawing_margin, prefix_);
        lines();
        for (const Point joint : page_.places.joints)
            out_ << fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"2.5\" fill=\"#444\"/>\n", joint.x, joint.y);
        for (std::size_t k = 0; k < diagram_.nodes.size(); ++k) node(k);
        for (std::size_t k = 0; k < diagram_.arrows.size(); ++k)
            text(page_.arrows[k], page_.places.arrows[k].label.at, "label",
                 diagram_.arrows[k].dashed ? "#a00" : "#225");
        out_ << "</svg>\n";
    }

private:
    void text(const Lines& lines, Point at, std::string_view kind, std::string_view colour) {
        for (std::size_t k = 0; k < lines.size(); ++k) {
            std::string escaped;
            escape_xml(lines[k], escaped);
            out_ << fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\" fill=\"{}\">{}</text>\n", kind, at.x,
                                at.y + line_height * static_cast<int>(k + 1) - 4, colour, escaped);
        }
    }

    void rectangle(const Box& box, std::string_view kind, int inset) {
        out_ << fmt::format(
            "<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"6\" fill=\"#eef\" "
            "stroke=\"black\"/>\n",
            kind, box.at.x + inset, box.at.y + inset, box.size.width - 2 * inset, box.size.height - 2 * inset);
    }

    void node(std::size_t number) {
        const Box& box = page_.places.nodes[number];
        const Size size = text_size(page_.nodes[number]);
        rectangle(box, "node", 0);
        if (diagram_.nodes[number].initial) rectangle(box, "initial", 3);
        text(page_.nodes[number],
             {box.at.x + (box.size.width - size.width) / 2, box.at.y + (box.size.height - size.height) / 2}, "name",
             "black");
    }

    /// Draws all arrows with the same end point as one path, so that shared segments are drawn only once.
    void lines() {
        std::map<std::pair<int, int>, std::size_t> known;
        Lines paths;
        for (std::size_t k = 0; k < diagram_.arrows.size(); ++k) {
            const std::vector<Point>& points = page_.places.arrows[k].points;
            if (points.empty()) continue;
            std::string path;
            for (const Point point : points)
                path += fmt::format("{}{},{}", path.empty() ? "M" : " L", point.x, point.y);
            if (diagram_.arrows[k].dashed) {
                out_ << "<path class=\"unstable\" fill=\"none\" stroke=\"#a00\" stroke-dasharray=\"4 3\" d=\"" << path
                     << "\"/>\n";
                continue;
            }
            const auto [place, added] = known.try_emplace({points.back().x, points.back().y}, paths.size());
            if (added) paths.push_back(std::move(path));
            else paths[place->second] += ' ' + path;
        }
        for (const std::string& path : paths)
            out_ << "<path class=\"arrow\" fill=\"none\" stroke=\"#444\" marker-end=\"url(#" << prefix_ << "tip)\" d=\""
                 << path << "\"/>\n";
    }

    const Diagram& diagram_;
    const Page& page_;
    std::ostream& out_;
    std::string_view prefix_;
};

}  // namespace

void emit_svg(const Diagram& diagram, std::ostream& out, std::string_view prefix) {
    if (diagram.nodes.size() > largest_drawing) return SvgWriter(diagram, page(diagram, {}), out, prefix).write();
    const Page across = page(diagram, Direction::Across), down = page(diagram, Direction::Down);
    SvgWriter(diagram, down.side() < across.side() ? down : across, out, prefix).write();
}

}  // namespace grafverif
