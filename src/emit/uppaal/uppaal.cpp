// SPDX-License-Identifier: MIT
// Writes the project as XML: declarations, templates as drawn by emit/layout, system, queries. The text is written into
// one buffer, because the declaration of a large chart is long.
//
// UPPAAL's parser is stricter than XML: text must not be split by comments, and a comment must not be the last node in
// `queries`. Therefore, the comment of a property without a formula is placed before the next query, or before the last
// query if no query follows.
#include "emit/uppaal/uppaal.hpp"

#include <algorithm>
#include <cassert>
#include <ostream>
#include <sstream>

#include "emit/layout/layout.hpp"
#include "emit/uppaal/queries.hpp"
#include "emit/uppaal/text.hpp"
#include "support/xml_text.hpp"

namespace grafverif::uppaal {
namespace {

constexpr int char_width = 8, line_height = 17;
constexpr std::size_t label_width = 34;  // width of a label in columns

// Maximum number of characters in a guard; a longer guard becomes a function.
constexpr std::size_t longest_guard = 160;

/// One label of a location or an edge. Several labels are placed below each other.
struct Label {
    std::string_view kind = {};
    std::vector<std::string> lines = {};
};
using Labels = std::vector<Label>;

layout::Size size_of(const Labels& labels) {
    layout::Size size;
    for (const Label& label : labels) {
        for (const std::string& line : label.lines)
            size.width = std::max(size.width, char_width * static_cast<int>(line.size()));
        size.height += line_height * static_cast<int>(label.lines.size());
    }
    return size;
}

/// The labels of one template, and the functions for its long guards.
struct Captions {
    std::vector<Labels> locations = {}, edges = {};
    std::vector<GuardFunction> guards = {};
};

class Captioner {
public:
    Captioner(const Network& network, const Names& names, Id<Network::Template> id)
        : network_(network),
          automaton_(network.templates[id]),
          names_(names),
          local_(names.locals[id.index]),
          terms_(network, names, id) {}

    Captions captions() {
        for (const Id<Network::Location> id : automaton_.locations.ids()) captions_.locations.push_back(location(id));
        for (const Network::Edge& edge : automaton_.edges) captions_.edges.push_back(this->edge(edge));
        return std::move(captions_);
    }

private:
    Labels location(Id<Network::Location> id) const {
        Labels labels = {{"name", {local_.locations[id.index]}}};
        const auto& invariant = automaton_.locations[id].invariant;
        if (!invariant.empty()) labels.push_back({"invariant", lines_of(terms_.text(invariant), label_width)});
        return labels;
    }

    Labels edge(const Network::Edge& edge) {
        Labels labels;
        if (const std::string text = guard(edge); !text.empty())
            labels.push_back({"guard", lines_of(text, label_width)});
        if (edge.urgent) labels.push_back({"synchronisation", {names_.channel + '!'}});
        if (const std::string text = updates(edge); !text.empty())
            labels.push_back({"assignment", lines_of(text, label_width)});
        return labels;
    }

    /// Returns the guard: data conditions first, then clock constraints.
    std::string guard(const Network::Edge& edge) {
        std::string data;
        if (!is_true(network_.exprs, edge.guard)) data = terms_.text(edge.guard);
        const Op op = network_.exprs[edge.guard].op;
        if (data.size() > longest_guard) data = guard_function(std::move(data));
        else if (!edge.constraint.empty() && (op == Op::Or || op == Op::Conditional)) data = '(' + data + ')';
        if (!data.empty() && !edge.constraint.empty()) data += " && ";
        return data + terms_.text(edge.constraint);
    }

    std::string guard_function(std::string body) {
        const auto same = std::ranges::find(captions_.guards, body, &GuardFunction::body);
        if (same != captions_.guards.end()) return same->name + "()";
        std::string name;
        while (name.empty() || local_.taken.contains(name))
            name = std::string(guard_prefix) + std::to_string(++last_guard_);
        captions_.guards.push_back({name, std::move(body)});
        return name + "()";
    }

    std::string updates(const Network::Edge& edge) const {
        std::string list;
        const auto add = [&](const std::string& update) { list += (list.empty() ? "" : ", ") + update; };
        for (const Network::Assignment& assignment : edge.assignments) add(terms_.text(assignment));
        for (const Id<Network::Procedure> call : edge.calls) add(local_.procedures[call.index] + "()");
        for (const Id<Network::Clock> clock : edge.resets) add(local_.clocks[clock.index] + " = 0");
        return list;
    }

    const Network& network_;
    const Network::Template& automaton_;
    const Names& names_;
    const LocalNames& local_;
    Terms terms_;
    Captions captions_ = {};
    std::size_t last_guard_ = 0;
};

layout::Drawing drawn(const Network::Template& automaton, const Captions& captions) {
    layout::Graph graph;
    for (const Labels& labels : captions.locations) graph.nodes.push_back(size_of(labels));
    for (const Id<Network::Edge> id : automaton.edges.ids()) {
        const Network::Edge& edge = automaton.edges[id];
        graph.links.push_back({edge.from.index, edge.to.index, size_of(captions.edges[id.index])});
    }
    return layout::draw(graph);
}

/// Writes a project into one buffer.
class Project {
public:
    Project(const Network& network, std::string& xml) : network_(network), names_(names(network)), xml_(xml) {}

    void write() {
        xml_ +=
            "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
            "<!DOCTYPE nta PUBLIC '-//Uppaal Team//DTD Flat System 1.6//EN' "
            "'http://www.it.uu.se/research/group/darts/uppaal/flat-1_6.dtd'>\n"
            "<nta>\n";
        program("declaration", "\t", [&](std::ostream& out) { write_global_declarations(out, network_, names_); });
        for (const Id<Network::Template> id : network_.templates.ids()) write_template(id);
        program("system", "\t", [&](std::ostream& out) { write_system(out, network_, names_); });
        write_queries();
        xml_ += "</nta>\n";
    }

private:
    template <class Write>
    void program(std::string_view tag, std::string_view indent, const Write& write) {
        text_.str({});
        write(text_);
        if (text_.view().empty()) return;
        ((((xml_ += indent) += '<') += tag) += '>');
        escape_xml(text_.view(), xml_);
        ((xml_ += "</") += tag) += ">\n";
    }

    void element(std::string_view indent, std::string_view tag, std::string_view text) {
        (((xml_ += indent) += '<') += tag) += '>';
        escape_xml(text, xml_);
        ((xml_ += "</") += tag) += ">\n";
    }

    void place(layout::Point at) { xml_ += " x=\"" + std::to_string(at.x) + "\" y=\"" + std::to_string(at.y) + '"'; }

    void write_template(Id<Network::Template> id) {
        const Network::Template& automaton = network_.templates[id];
        const Captions captions = Captioner(network_, names_, id).captions();
        const layout::Drawing drawing = drawn(automaton, captions);
        xml_ += "\t<template>\n";
        element("\t\t", "name", names_.templates[id.index]);
        if (!automaton.parameters.empty())
            element("\t\t", "parameter", parameter_list(automaton, names_.locals[id.index]));
        program("declaration", "\t\t",
                [&](std::ostream& out) { write_template_declarations(out, network_, names_, id, captions.guards); });
        for (std::size_t i = 0; i < captions.locations.size(); ++i)
            write_location(i, captions.locations[i], drawing.nodes[i]);
        xml_ += "\t\t<init ref=\"" + location_id(automaton.initial.index) + "\"/>\n";
        for (const Id<Network::Edge> edge : automaton.edges.ids())
            write_edge(automaton.edges[edge], captions.edges[edge.index], drawing.links[edge.index]);
        xml_ += "\t</template>\n";
        first_location_ += automaton.locations.size();
    }

    /// Returns an id that is unique in the document.
    std::string location_id(std::size_t location) const { return "id" + std::to_string(first_location_ + location); }

    void write_location(std::size_t index, const Labels& labels, const layout::Drawing::Node& node) {
        xml_ += "\t\t<location id=\"" + location_id(index) + '"';
        place(node.centre);
        xml_ += ">\n";
        write_labels(labels, node.label);
        xml_ += "\t\t</location>\n";
    }

    void write_edge(const Network::Edge& edge, const Labels& labels, const layout::Drawing::Link& link) {
        xml_ += "\t\t<transition>\n\t\t\t<source ref=\"" + location_id(edge.from.index) + "\"/>\n\t\t\t<target ref=\"" +
                location_id(edge.to.index) + "\"/>\n";
        write_labels(labels, link.label);
        for (const layout::Point nail : link.nails) {
            xml_ += "\t\t\t<nail";
            place(nail);
            xml_ += "/>\n";
        }
        xml_ += "\t\t</transition>\n";
    }

    /// Prints the labels in a column, starting at `at`.
    void write_labels(const Labels& labels, layout::Point at) {
        for (const auto& [kind, lines] : labels) {
            const bool is_name = kind == "name";
            if (is_name) xml_ += "\t\t\t<name";
            else ((xml_ += "\t\t\t<label kind=\"") += kind) += '"';
            place(at);
            xml_ += '>';
            for (std::size_t i = 0; i < lines.size(); ++i) {
                if (i > 0) xml_ += '\n';
                escape_xml(lines[i], xml_);
            }
            xml_ += is_name ? "</name>\n" : "</label>\n";
            at.y += line_height * static_cast<int>(lines.size());
        }
    }

    void write_queries() {
        const std::vector<Query> list = queries(network_, names_);
        const auto has_formula = [](const Query& query) { return !query.formula.empty(); };
        const auto last = std::ranges::find_if(list.rbegin(), list.rend(), has_formula);
        if (last == list.rend()) return;  // the header lists the omitted properties
        const auto end = last.base();
        xml_ += "\t<queries>\n";
        for (auto query = list.begin(); query != end; ++query) {
            if (query + 1 == end)
                std::for_each(end, list.end(), [&](const Query& omitted) { write_omitted_query(omitted); });
            if (has_formula(*query)) write_query(*query);
            else write_omitted_query(*query);
        }
        xml_ += "\t</queries>\n";
    }

    void write_query(const Query& query) {
        xml_ += "\t\t<query>\n";
        element("\t\t\t", "formula", query.formula);
        element("\t\t\t", "comment", query.comment);
        if (query.satisfied)
            ((xml_ += "\t\t\t<expect outcome=\"") += *query.satisfied ? "success" : "failure") +=
                "\" type=\"symbolic\"/>\n";
        xml_ += "\t\t</query>\n";
    }

    void write_omitted_query(const Query& query) {
        xml_ += "\t\t<!-- ";
        comment_xml(query.comment, xml_);
        xml_ += " -->\n";
    }

    const Network& network_;
    Names names_;
    std::string& xml_;
    std::ostringstream text_ = {};
    std::size_t first_location_ = 0;
};

[[maybe_unused]] bool is_lowered(const Network& network) {
    return std::ranges::all_of(network.processes, [&](const Network::Process& process) {
        return process.initial == network.templates[process.automaton].initial;
    });
}

}  // namespace

void emit(const Network& network, std::ostream& out) {
    assert(is_lowered(network));
    std::string xml;
    Project(network, xml).write();
    out << xml;
}

}  // namespace grafverif::uppaal
