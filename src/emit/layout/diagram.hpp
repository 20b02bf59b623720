// SPDX-License-Identifier: MIT
// Drawings of location automata, Mealy machines (JESA13 Figs. 8, 10, 11) and components: Graphviz DOT, and SVG with
// built-in layout.
//
// A node is a location: its number and situation, below them the outputs that are set. An arrow is an evolution with
// its condition; a dashed arrow without target shows inputs for which no stable situation is reached. In a Mealy
// machine an arrow has a label `condition / outputs`; arrows between the same two states are merged, with one label
// below the other. A component has its invariants in the nodes and an arrow for each edge: immediate or timed, with its
// guard and effect.
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
        bool dashed = false;  ///< total instability; `to` equals `from`
        bool operator==(const Arrow&) const = default;
    };
    std::string name = {};
    std::vector<Node> nodes = {};
    std::vector<Arrow> arrows = {};
    bool numbered = true;  ///< nodes are identified by numbers; false: by names
    bool operator==(const Diagram&) const = default;
};

Diagram diagram(const LocationAutomaton& automaton);
Diagram diagram(const MealyMachine& machine);
Diagram diagram(const Component& component);

void emit_dot(const Diagram& diagram, std::ostream& out);
/// A drawing; with more nodes than `largest_drawing` a table. `prefix` is prepended to the ids.
void emit_svg(const Diagram& diagram, std::ostream& out, std::string_view prefix = "");

/// Number of nodes above which a drawing is unreadable.
inline constexpr std::size_t largest_drawing = 60;
/// Number of nodes above which a table is unreadable; the DOT file can be used with Graphviz.
inline constexpr std::size_t largest_table = 200;

}  // namespace grafverif
