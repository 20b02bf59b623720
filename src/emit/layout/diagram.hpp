// SPDX-License-Identifier: MIT
// Drawings of location automata, Mealy machines (JESA13 Figs. 8, 10, 11) and components: Graphviz DOT, and SVG with a
// built-in layout.
//
// A node represents a location. The node shows the number and situation of the location and, below, the outputs that
// are set. An arrow represents an evolution and shows its condition; a dashed arrow without target shows inputs for
// which no stable situation is reached. In a Mealy machine, an arrow has a label `condition / outputs`. Arrows between
// the same two nodes are merged; their labels are placed below each other. In the drawing of a component, nodes show
// invariants. Each edge has an arrow, which is marked as immediate or timed and shows the guard and the effect.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/component.hpp"
#include "grafverif/ir/location_automaton.hpp"
#include "grafverif/ir/mealy.hpp"

namespace grafverif {

struct Diagram {
    struct Node {
        std::vector<std::string> lines = {};
        bool initial = false;
        bool operator==(const Node&) const = default;
    };
    struct Arrow {
        std::size_t from = 0, to = 0;
        std::vector<std::string> lines = {};
        bool dashed = false;  ///< true if no stable situation is reached (total instability); then `to` equals `from`
        bool operator==(const Arrow&) const = default;
    };
    std::string name = {};
    std::vector<Node> nodes = {};
    std::vector<Arrow> arrows = {};
    bool numbered = true;  ///< true if nodes are identified by numbers, false if by names
    bool operator==(const Diagram&) const = default;
};

Diagram diagram(const LocationAutomaton& automaton);
Diagram diagram(const MealyMachine& machine);
Diagram diagram(const Component& component);

void emit_dot(const Diagram& diagram, std::ostream& out);
/// Writes a drawing, or a table if there are more nodes than `largest_drawing`. `prefix` is prepended to all ids of SVG
/// elements.
void emit_svg(const Diagram& diagram, std::ostream& out, std::string_view prefix = "");

/// The maximum number of nodes for which a drawing is readable.
inline constexpr std::size_t largest_drawing = 60;
/// The maximum number of nodes for which a table is readable. For a larger diagram, only the DOT file is useful.
inline constexpr std::size_t largest_table = 200;

}  // namespace grafverif
