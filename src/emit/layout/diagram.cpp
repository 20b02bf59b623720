// SPDX-License-Identifier: MIT
#include "emit/layout/diagram.hpp"

#include <algorithm>
#include <map>
#include <ostream>
#include <utility>

#include "syntax/print/automaton.hpp"
#include "syntax/print/component.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

/// Groups arrows by target. Lines between the same two nodes are merged.
class Arrows {
public:
    void add(std::size_t from, std::size_t to, std::string line) {
        const auto [place, added] = known_.try_emplace({from, to}, list_.size());
        if (added) list_.push_back({from, to, {}, false});
        list_[place->second].lines.push_back(std::move(line));
    }
    void add_unstable(std::size_t from, std::string line) { list_.push_back({from, from, {std::move(line)}, true}); }
    std::vector<Diagram::Arrow> take() { return std::move(list_); }

private:
    std::vector<Diagram::Arrow> list_ = {};
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> known_ = {};
};

/// Returns a quoted DOT string. Each line ends with `\n`.
std::string dot_label(const std::vector<std::string>& lines) {
    std::string text = "\"";
    for (const std::string& line : lines) {
        if (text.size() > 1) text += "\\n";
        for (const char c : line) {
            if (c == '"' || c == '\\') text += '\\';
            text += c;
        }
    }
    return text + '"';
}

}  // namespace

Diagram diagram(const LocationAutomaton& automaton) {
    Diagram result{.name = automaton.name};
    Arrows arrows;
    for (const Id<LocationAutomaton::Location> id : automaton.locations.ids()) {
        const LocationAutomaton::Location& location = automaton.locations[id];
        Diagram::Node node{{(id == automaton.init ? "INIT " : "") + situation_text(automaton, location.situation)},
                           id == automaton.init};
        for (const Id<LocationAutomaton::Stored> stored : automaton.stored.ids())
            node.lines.push_back(automaton.stored[stored].name + " = " + std::to_string(location.values[stored.index]));
        std::string outputs;
        for (const LocationAutomaton::Emission& emission : location.emissions)
            outputs += (outputs.empty() ? "" : ", ") + emission_text(automaton, emission);
        if (!outputs.empty()) node.lines.push_back(outputs);
        result.nodes.push_back(std::move(node));
        for (const LocationAutomaton::Evolution& evolution : evolutions_from(automaton, id))
            arrows.add(id.index, evolution.to.index, condition_text(automaton, evolution.condition));
        for (const LocationAutomaton::Instability& instability : instabilities_of(automaton, id))
            arrows.add_unstable(id.index, condition_text(automaton, instability.condition));
    }
    result.arrows = arrows.take();
    return result;
}

Diagram diagram(const MealyMachine& machine) {
    Diagram result{.name = machine.name};
    Arrows arrows;
    for (const Id<MealyMachine::State> id : machine.states.ids()) {
        const MealyMachine::State& state = machine.states[id];
        Diagram::Node node{{state.situation}, id == machine.initial};
        if (!state.detail.empty()) node.lines.push_back(state.detail);
        result.nodes.push_back(std::move(node));
    }
    for (const MealyMachine::Transition& one : machine.transitions)
        arrows.add(one.from.index, one.to.index,
                   (one.wait_ms != 0 ? "wait " + duration_text(one.wait_ms) + ", " : "") +
                       condition_text(machine, one.condition) + " / " + result_text(machine, one.answer, "-"));
    for (const MealyMachine::Unstable& one : machine.unstable)
        arrows.add_unstable(one.from.index, condition_text(machine, one.condition));
    result.arrows = arrows.take();
    return result;
}

Diagram diagram(const Component& component) {
    Diagram result{.name = component.name, .numbered = false};
    for (const Id<Component::Location> id : component.locations.ids()) {
        const Component::Location& location = component.locations[id];
        Diagram::Node node{{location.name}, id == component.initial};
        if (!location.invariant.empty()) node.lines.push_back(clocks_text(component, location.invariant));
        result.nodes.push_back(std::move(node));
    }
    for (const Component::Edge& edge : component.edges) {
        const std::string guard = guard_text(component, edge), effect = effect_text(component, edge);
        Diagram::Arrow arrow{edge.from.index, edge.to.index, {edge.urgent ? "urgent" : "timed"}, false};
        if (!guard.empty()) arrow.lines.front() += ", when " + guard;
        if (!effect.empty()) arrow.lines.push_back("do " + effect);
        result.arrows.push_back(std::move(arrow));
    }
    return result;
}

void emit_dot(const Diagram& diagram, std::ostream& out) {
    out << "digraph " << dot_label({diagram.name})
        << " {\n    node [shape=box, style=rounded, fontname=\"sans-serif\"];\n"
        << "    edge [fontname=\"sans-serif\", fontsize=10];\n";
    for (std::size_t k = 0; k < diagram.nodes.size(); ++k)
        out << "    " << k << " [label=" << dot_label(diagram.nodes[k].lines)
            << (diagram.nodes[k].initial ? ", peripheries=2" : "") << "];\n";
    for (std::size_t k = 0; k < diagram.arrows.size(); ++k) {
        const Diagram::Arrow& arrow = diagram.arrows[k];
        if (arrow.dashed) out << "    unstable" << k << " [label=\"never stable\", shape=plaintext];\n";
        out << "    " << arrow.from << " -> ";
        if (arrow.dashed) out << "unstable" << k;
        else out << arrow.to;
        out << " [label=" << dot_label(arrow.lines) << (arrow.dashed ? ", style=dashed" : "") << "];\n";
    }
    out << "}\n";
}

}  // namespace grafverif
