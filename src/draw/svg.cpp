// SPDX-License-Identifier: MIT
#include "draw/svg.hpp"

#include <fmt/format.h>

#include <ostream>
#include <string>

#include "draw/writing.hpp"
#include "support/xml_text.hpp"

namespace grafverif::draw {

namespace {

using Point = Drawing::Point;

constexpr std::size_t longest_title = 1000;  ///< maximum number of characters of a title (tooltip)

std::string escaped(std::string_view text) {
    std::string xml;
    escape_xml(text, xml);
    return xml;
}

class Writer {
public:
    Writer(const Drawing& drawing, std::ostream& out) : drawing_(drawing), out_(out) {}

    void write() {
        const auto [width, height] = drawing_.size;
        out_ << fmt::format(
                    "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"grafcet\" role=\"group\" width=\"{0}\" "
                    "height=\"{1}\" viewBox=\"-0.5 -0.5 {0} {1}\" font-family=\"{2}\" fill=\"none\" "
                    "stroke=\"currentColor\" "
                    "stroke-width=\"1.3\">\n<title>{3}</title>\n",
                    width, height, font_family, escaped(shortened(drawing_.title, longest_title)))
             << fmt::format(
                    "<rect class=\"paper\" x=\"-0.5\" y=\"-0.5\" width=\"{}\" height=\"{}\" fill=\"white\" "
                    "stroke=\"none\"/>\n",
                    width, height);
        for (const Drawing::Element& element : drawing_.elements) write(element);
        out_ << "</svg>\n";
    }

private:
    void write(const Drawing::Element& element) {
        out_ << "<g";
        if (!element.id.empty()) out_ << fmt::format(" id=\"{}\"", element.id);
        out_ << fmt::format(" class=\"{}\"", element.classes);
        if (element.classes.ends_with(" changed")) out_ << " color=\"#c00000\" stroke=\"currentColor\"";
        for (const auto& [name, value] : element.data)
            out_ << fmt::format(" data-{}=\"{}\"", name, attribute_xml(value));
        out_ << '>';
        if (!element.title.empty()) out_ << "<title>" << escaped(shortened(element.title, longest_title)) << "</title>";
        for (const Drawing::Box& box : element.boxes) write(box);
        for (const Drawing::Line& line : element.lines) write(line);
        for (const Drawing::Text& text : element.texts) write(text);
        out_ << "</g>\n";
    }

    void write(const Drawing::Box& box) {
        const auto [x, y] = box.at;
        const auto [width, height] = box.size;
        const char* const paint = box.filled ? " class=\"mark\" fill=\"currentColor\" stroke=\"none\"" : "";
        if (box.cut == 0) {
            out_ << fmt::format("<rect{} x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", paint, x, y, width, height);
            return;
        }
        out_ << fmt::format("<path{0} d=\"M{1} {2}h{3}l{4} {4}v{5}l-{4} {4}h-{3}l-{4} -{4}v-{5}z\"/>", paint,
                            x + box.cut, y, width - 2 * box.cut, box.cut, height - 2 * box.cut);
    }

    void write(const Drawing::Line& line) {
        out_ << "<polyline points=\"";
        for (std::size_t k = 0; k < line.points.size(); ++k)
            out_ << fmt::format("{}{},{}", k == 0 ? "" : " ", line.points[k].x, line.points[k].y);
        out_ << "\"/>";
        if (line.arrow && line.points.size() > 1) head(line.points[line.points.size() - 2], line.points.back());
    }

    /// Draws an arrow head at `tip`. The head has the direction of the line from `from` to `tip`.
    void head(Point from, Point tip) {
        const int along = 8, across = 4;
        const int dx = tip.x == from.x  ? 0
                       : tip.x > from.x ? 1
                                        : -1,
                  dy = tip.y == from.y  ? 0
                       : tip.y > from.y ? 1
                                        : -1;
        const Point base{tip.x - dx * along, tip.y - dy * along};
        out_ << fmt::format(
            "<path class=\"arrow\" fill=\"currentColor\" stroke=\"none\" d=\"M{} {}L{} {}L{} "
            "{}z\"/>",
            tip.x, tip.y, base.x + dy * across, base.y + dx * across, base.x - dy * across, base.y - dx * across);
    }

    void write(const Drawing::Text& text) {
        const char* const anchor = text.anchor == Drawing::Anchor::Start    ? ""
                                   : text.anchor == Drawing::Anchor::Middle ? " text-anchor=\"middle\""
                                                                            : " text-anchor=\"end\"";
        out_ << fmt::format(
            "<text class=\"{}\" x=\"{}\" y=\"{}\" font-size=\"{}\"{} fill=\"currentColor\" stroke=\"none\">", text.kind,
            text.at.x, text.at.y, text.size, anchor);
        for (const Drawing::Run& run : text.runs)
            out_ << (run.over ? "<tspan text-decoration=\"overline\">" + escaped(run.text) + "</tspan>"
                              : escaped(run.text));
        out_ << "</text>";
    }

    const Drawing& drawing_;
    std::ostream& out_;
};

}  // namespace

void print_svg(const Drawing& drawing, std::ostream& out) { Writer(drawing, out).write(); }

}  // namespace grafverif::draw
