// SPDX-License-Identifier: MIT
// The plant on a page: instances with what they are bound to, and the automata of their components.
#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <set>
#include <variant>

#include "page/parts.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

std::string value_text(Component::ValueKind kind, std::int64_t value) {
    switch (kind) {
    case Component::ValueKind::Boolean: return value != 0 ? "true" : "false";
    case Component::ValueKind::Integer: return std::to_string(value);
    case Component::ValueKind::Duration: return duration_text(value);
    }
    unreachable();
}

std::string argument_text(const ClosedLoop& loop, const Component::Parameter& parameter,
                          const ClosedLoop::Argument& argument) {
    const std::string value =
        std::visit(overloaded{
                       [&](Id<ClosedLoop::Shared> shared) { return loop.shared[shared].name; },
                       [&](std::int64_t constant) { return value_text(parameter.value, constant); },
                   },
                   argument);
    return parameter.name + " = " + value;
}

void join(std::string& list, const std::string& word, std::string_view between = ", ") {
    if (word.empty()) return;
    if (!list.empty()) list += between;
    list += word;
}

/// The words of one component.
class Words {
public:
    explicit Words(const Component& component) : component_(component) {}

    std::string term(Id<Expr> term) const {
        return expr_text(component_.exprs, term, chart_spelling, [this](std::ostream& out, const Expr& leaf) {
            const auto index = static_cast<std::uint32_t>(leaf.value);
            if (leaf.op == Op::Parameter) out << component_.parameters[{index}].name;
            else if (leaf.op == Op::Variable) out << component_.variables[{index}].name;
            else out << duration_text(leaf.value);
        });
    }
    std::string clocks(const std::vector<Component::ClockConstraint>& constraints) const {
        std::string words;
        for (const Component::ClockConstraint& each : constraints)
            join(words,
                 fmt::format("{} {} {}", component_.clocks[each.clock].name, chart_spelling(each.relation).token,
                             term(each.bound)),
                 " && ");
        return words;
    }
    std::string guard(const Component::Edge& edge) const {
        std::string words = is_true(component_.exprs, edge.guard) ? "" : term(edge.guard);
        join(words, clocks(edge.constraint), " && ");
        return words;
    }
    std::string effect(const Component::Edge& edge) const {
        std::string words;
        for (const Component::Assignment& each : edge.assignments)
            join(words, term(each.target) + " := " + term(each.value));
        for (const Id<Component::Clock> clock : edge.resets) join(words, component_.clocks[clock].name + " := 0");
        return words;
    }

private:
    const Component& component_;
};

void add_row(Html& html, const std::vector<std::string>& cells, const char* tag = "td") {
    html.open("tr");
    for (const std::string& cell : cells) html.put(tag, cell);
    html.close("tr");
}

void begin_table(Html& html, const std::vector<std::string>& titles) {
    html.open("div", {{"class", "wide"}}).open("table").open("thead");
    add_row(html, titles, "th");
    html.close("thead").open("tbody");
}
void end_table(Html& html) { html.close("tbody").close("table").close("div"); }

void add_component(const Component& component, Html& html) {
    const Words words(component);
    html.open("details", {{"class", "component"}}).open("summary").put("strong", component.name);
    html.text(component.summary.empty() ? "" : ": " + component.summary).close("summary");
    begin_table(html, {"location", "time may pass while", ""});
    for (const Id<Component::Location> id : component.locations.ids())
        add_row(html, {component.locations[id].name, words.clocks(component.locations[id].invariant),
                       id == component.initial ? "initial" : ""});
    end_table(html);
    begin_table(html, {"from", "to", "", "when", "does"});
    for (const Component::Edge& edge : component.edges)
        add_row(html, {component.locations[edge.from].name, component.locations[edge.to].name,
                       edge.urgent ? "at once" : "timed", words.guard(edge), words.effect(edge)});
    end_table(html);
    html.close("details");
}

}  // namespace

void add_plant(const PageContent& content, Html& html) {
    if (!content.loop.valid()) return;
    const ClosedLoop& loop = content.model.loops[content.loop];
    html.open("section", {{"id", "plant"}}).put("h2", "Plant and environment");
    begin_table(html, {"instance", "", "component", "begins", "bound to"});
    std::set<Id<Component>> used;
    for (const ClosedLoop::Instance& instance : loop.instances) {
        const Component& component = content.model.components[instance.component];
        used.insert(instance.component);
        std::string bound;
        for (const Id<Component::Parameter> id : component.parameters.ids())
            join(bound, argument_text(loop, component.parameters[id], instance.arguments[id.index]));
        add_row(html, {instance.name, instance.environment ? "environment" : "plant", component.name,
                       component.locations[instance.initial].name, bound});
    }
    end_table(html);
    for (const Id<Component> id : used) add_component(content.model.components[id], html);
    html.close("section");
}

}  // namespace grafverif
