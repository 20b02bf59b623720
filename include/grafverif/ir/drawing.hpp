// SPDX-License-Identifier: MIT
// Drawing: boxes, lines and texts with places, between a layout and what shows it. Every mark belongs to an element of
// what is drawn: a step, a transition, a link.
//
// An element of a chart has an id and classes that others may rely on (docs/drawing.md): `step-3` or `step-G1-3` with
// the classes `step`, `initial`, `macro`, ...; `transition-T4`, `condition-T4`, `action-c0`, `forcing-0`. A link has no
// id, but says what it joins.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grafverif/ir/chart.hpp"

namespace grafverif {

struct Drawing {
    struct Point {
        int x = 0, y = 0;  ///< pixels; y grows downwards
        bool operator==(const Point&) const = default;
    };
    struct Size {
        int width = 0, height = 0;
        bool operator==(const Size&) const = default;
    };
    struct Box {
        Point at = {};  ///< its upper left corner
        Size size = {};
        int cut = 0;          ///< how much is cut off each corner
        bool filled = false;  ///< a bar, a mark; else only its outline is drawn
        bool operator==(const Box&) const = default;
    };
    /// Straight pieces, each across or along the page.
    struct Line {
        std::vector<Point> points = {};
        bool arrow = false;  ///< at its end
        bool operator==(const Line&) const = default;
    };
    struct Run {
        std::string text = {};
        bool over = false;  ///< with a line above: negated
        bool operator==(const Run&) const = default;
    };
    enum class Anchor { Start, Middle, End };
    /// One line of text.
    struct Text {
        Point at = {};  ///< its anchor, on the base line
        std::vector<Run> runs = {};
        Anchor anchor = Anchor::Start;
        int size = 12;          ///< of the font
        int width = 0;          ///< room that it needs, and has, in any of the fonts of `font_family`
        std::string kind = {};  ///< its class: `name`, `label`, `reference`
        bool operator==(const Text&) const = default;
    };
    struct Element {
        std::string id = {};                                         ///< may be empty
        std::string classes = {};                                    ///< separated by blanks
        std::string title = {};                                      ///< for who points at it, or has it read out
        std::vector<std::pair<std::string, std::string>> data = {};  ///< `from`, `to` of a link
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

/// How logic is written: `a·b̅` as the standard does, or `a && !b` as the file does.
enum class Notation { Iec, Text };

struct DrawOptions {
    Notation notation = Notation::Iec;
    std::vector<Id<Chart::Step>> situation = {};  ///< to be marked as active
    int columns = 0;                              ///< into which long charts are folded; 0: as many as a page takes
    std::string prefix = {};                      ///< before every id, where several charts stand on a page
};

/// The ids of a chart's elements in its drawing, in the order of the chart's tables. An id has letters, digits, `-` and
/// `_` only; no two are equal.
struct ElementIds {
    std::vector<std::string> steps = {}, transitions = {}, conditions = {}, partial_charts = {};
    std::vector<std::string> continuous = {}, stored = {}, forcing = {};
};
ElementIds element_ids(const Chart& chart, std::string_view prefix = {});

}  // namespace grafverif
