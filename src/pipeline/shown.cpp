// SPDX-License-Identifier: MIT
// Converts results to text, JSON and drawings.
#include <sstream>

#include "emit/layout/diagram.hpp"
#include "grafverif/grafverif.hpp"
#include "report/charts/comparison.hpp"
#include "report/findings.hpp"
#include "report/json.hpp"
#include "report/json_trace.hpp"
#include "report/report.hpp"
#include "report/svg.hpp"
#include "report/terminal.hpp"
#include "support/json_text.hpp"
#include "syntax/print/automaton.hpp"

namespace grafverif {

namespace {

template <class Write>
std::string shown(Write write) {
    std::ostringstream out;
    write(out);
    return std::move(out).str();
}

template <class Machine>
std::string graph_of(const Machine& machine) {
    const Diagram drawn = diagram(machine);
    if (drawn.nodes.size() > largest_table) return {};
    return shown([&](std::ostream& out) { emit_svg(drawn, out); });
}

}  // namespace

std::string text_of(const Report& report) {
    return shown([&](std::ostream& out) { print_report(report, {}, out); });
}
std::string text_of(const Report& report, const Sources& sources) {
    Report placed = report;
    name_places(placed, sources);
    return text_of(placed);
}
std::string json_of(const Report& report) { return json_of(report, Sources{}); }
std::string json_of(const Report& report, const Sources& sources) {
    return shown([&](std::ostream& out) { print_json(report, sources, out); });
}

std::string text_of(const ChartRun& run) {
    return shown([&](std::ostream& out) { print_trace(run, out); });
}
std::string json_of(const ChartRun& run) { return json_text(trace_json(run)); }

std::string text_of(const Analysis& analysis, const Sources& sources) {
    return shown([&](std::ostream& out) { print_findings(analysis, sources, Colour::Plain, out); });
}
std::string json_of(const Analysis& analysis, const Sources& sources) {
    return shown([&](std::ostream& out) { print_findings_json(analysis, sources, out); });
}

std::string text_of(const Comparison& comparison) {
    return shown([&](std::ostream& out) { print_comparison(comparison, Colour::Plain, out); });
}
std::string json_of(const Comparison& comparison) { return comparison_json(comparison); }

std::string text_of(const LocationAutomaton& automaton) {
    return shown([&](std::ostream& out) { print_automaton(out, automaton, true); });
}
std::string json_of(const LocationAutomaton& automaton) {
    return shown([&](std::ostream& out) { print_automaton_json(out, automaton, true); });
}
std::string text_of(const MealyMachine& machine) {
    return shown([&](std::ostream& out) { print_mealy(out, machine, true); });
}
std::string json_of(const MealyMachine& machine) {
    return shown([&](std::ostream& out) { print_mealy_json(out, machine, true); });
}
std::string json_of(const TestSequence& test) {
    return shown([&](std::ostream& out) { print_test_json(out, test); });
}

std::string svg_of(const ChartRun& run, std::string_view title) {
    return shown([&](std::ostream& out) { print_svg(run, title, {}, out); });
}
std::string svg_of(const LocationAutomaton& automaton) { return graph_of(automaton); }
std::string svg_of(const MealyMachine& machine) { return graph_of(machine); }

}  // namespace grafverif
