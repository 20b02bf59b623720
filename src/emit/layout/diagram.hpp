// SPDX-License-Identifier: MIT
// Location automata, Mealy machines (JESA13 Figs. 8, 10, 11) and components of the plant as drawings: Graphviz DOT, and SVG
// laid out here.
//
// A node is a location: its number and situation, below them the outputs that are set. An arrow is an evolution under its
// condition; inputs that never stabilise are a dashed arrow to nowhere. In a Mealy machine an arrow carries
// `condition / outputs`; arrows between the same two states are one, their labels below each other. A component has its
// invariants in the nodes, and each edge as an arrow: at once or timed, under which guard, and what it does.
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
        bool dashed = false;  ///< total instability; `to` is `from`
        bool operator==(const Arrow&) const = default;
    };
    std::string name = {};
    std::vector<Node> nodes = {};
    std::vector<Arrow> arrows = {};
    bool numbered = true;  ///< nodes are told apart by their numbers; false: by their names
    bool operator==(const Diagram&) const = default;
};

Diagram diagram(const LocationAutomaton& automaton);
Diagram diagram(const MealyMachine& machine);
Diagram diagram(const Component& component);

void emit_dot(const Diagram& diagram, std::ostream& out);
/// A drawing, or of more nodes than `largest_drawing` a table. `prefix` stands before the ids in it.
void emit_svg(const Diagram& diagram, std::ostream& out, std::string_view prefix = "");

/// More nodes than this make no drawing that a person could read.
inline constexpr std::size_t largest_drawing = 60;
/// And more than this no table; Graphviz takes the DOT file.
inline constexpr std::size_t largest_table = 200;

}  // namespace grafverif
