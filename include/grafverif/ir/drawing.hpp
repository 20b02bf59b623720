// SPDX-License-Identifier: MIT
// Drawing: boxes, lines and texts with positions, which the layout of a chart computes. Every shape belongs to an
// element of the drawing: a step, a transition, an action or a directed link.
//
// Each element of a chart has an id and classes. Ids and classes belong to the stable interface (docs/how-to/draw.md):
// `step-3` or `step-G1-3` with the classes `step`, `initial`, `macro`, ...; `transition-T4`, `condition-T4`,
// `action-c0`, `forcing-0`. A link has no id; its `data` names the elements at its two ends.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grafverif/ir/chart.hpp"

namespace grafverif {

struct Drawing {
    struct Point {
        int x = 0, y = 0;  ///< position in pixels; y grows downwards
        bool operator==(const Point&) const = default;
    };
    struct Size {
        int width = 0, height = 0;
        bool operator==(const Size&) const = default;
    };
    struct Box {
        Point at = {};  ///< upper left corner
        Size size = {};
        int cut = 0;          ///< length by which each corner is cut off
        bool filled = false;  ///< true if the box is filled (a bar or mark), false if only its outline is drawn
        bool operator==(const Box&) const = default;
    };
    /// A line of horizontal and vertical segments.
    struct Line {
        std::vector<Point> points = {};
        bool arrow = false;  ///< true if the line ends with an arrow
        bool operator==(const Line&) const = default;
    };
    struct Run {
        std::string text = {};
        bool over = false;  ///< true if drawn with an overline (negation)
        bool operator==(const Run&) const = default;
    };
    enum class Anchor { Start, Middle, End };
    /// One line of text.
    struct Text {
        Point at = {};  ///< anchor point on the base line of the text
        std::vector<Run> runs = {};
        Anchor anchor = Anchor::Start;
        int size = 12;          ///< font size in pixels
        int width = 0;          ///< upper bound of the text's width in every font of `font_family`
        std::string kind = {};  ///< class of the text: `name`, `label` or `reference`
        bool operator==(const Text&) const = default;
    };
    struct Element {
        std::string id = {};                                         ///< element id; may be empty
        std::string classes = {};                                    ///< class names separated by spaces
        std::string title = {};                                      ///< tooltip and text for screen readers
        std::vector<std::pair<std::string, std::string>> data = {};  ///< for a link: ids of its ends `from`, `to`
        std::vector<Box> boxes = {};
        std::vector<Line> lines = {};
        std::vector<Text> texts = {};
        bool operator==(const Element&) const = default;
    };

    std::string title = {};
    Size size = {};
    std::vector<Element> elements = {};

    bool operator==(const Drawing&) const = default;
};

/// Notation of Boolean terms: `a·b̅` as in the standard, or `a && !b` as in the input language.
enum class Notation { Iec, Text };

struct DrawOptions {
    Notation notation = Notation::Iec;
    std::vector<Id<Chart::Step>> situation = {};  ///< steps to be marked as active

    /// Number of columns into which a long chart is split; 0 selects a number that fits the shape of a page.
    int columns = 0;
    /// Prefix of all ids; different prefixes make the ids of several charts on one page distinct.
    std::string prefix = {};
};

/// The ids of a chart's elements, in the order of the tables of the chart. Ids are unique and consist of letters,
/// digits, `-` and `_`.
struct ElementIds {
    std::vector<std::string> steps = {}, transitions = {}, conditions = {}, partial_charts = {};
    std::vector<std::string> continuous = {}, stored = {}, forcing = {};
    bool operator==(const ElementIds&) const = default;
};
ElementIds element_ids(const Chart& chart, std::string_view prefix = {});

}  // namespace grafverif
