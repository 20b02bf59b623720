// SPDX-License-Identifier: MIT
// Adds the plant to a page: instances with their bindings, and the automata of their components.
#include <fmt/format.h>

#include <variant>

#include "page/data.hpp"
#include "page/parts.hpp"
#include "page/terms.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/component.hpp"
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

std::string argument_text(const Model& model, const ClosedLoop& loop, const Component::Parameter& parameter,
                          const ClosedLoop::Argument& argument) {
    const std::string value =
        std::visit(overloaded{
                       [&](Id<ClosedLoop::Shared> shared) { return loop.shared[shared].name; },
                       [&](std::int64_t constant) { return value_text(parameter.value, constant); },
                       [&](Id<Expr> term) { return term_text(model, loop, term); },
                   },
                   argument);
    return parameter.name + " = " + value;
}

void join(std::string& list, const std::string& word, std::string_view between = ", ") {
    if (word.empty()) return;
    if (!list.empty()) list += between;
    list += word;
}

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

void add_tables(const Component& component, Html& html) {
    begin_table(html, {"location", "invariant", ""});
    for (const Id<Component::Location> id : component.locations.ids())
        add_row(html, {component.locations[id].name, clocks_text(component, component.locations[id].invariant),
                       id == component.initial ? "initial" : ""});
    end_table(html);
    begin_table(html, {"from", "to", "", "when", "does"});
    for (const Component::Edge& edge : component.edges)
        add_row(html, {component.locations[edge.from].name, component.locations[edge.to].name,
                       edge.urgent ? "urgent" : "timed", guard_text(component, edge), effect_text(component, edge)});
    end_table(html);
}

void add_component(const Component& component, const ComponentContent& content, Html& html) {
    html.open("figure", {{"id", component_figure(content.component)}, {"class", "component"}});
    html.open("figcaption").put("strong", component.name);
    html.text(component.summary.empty() ? "" : ": " + component.summary).close("figcaption");
    if (content.drawing.empty())
        html.put("p", fmt::format("An automaton with {} locations is too large to draw; see the tables.",
                                  component.locations.size()));
    else
        html.open("div", {{"class", "drawing automaton"},
                          {"tabindex", "0"},
                          {"role", "region"},
                          {"aria-label", "Drawing of " + component.name}})
            .trusted(content.drawing)
            .close("div");
    html.open("details", content.drawing.empty() ? Html::Attributes{{"open", ""}} : Html::Attributes{});
    html.put("summary", "Tables of this automaton");
    add_tables(component, html);
    html.close("details").close("figure");
}

}  // namespace

std::string environment_text(const Model& model, const ClosedLoop& loop, bool timed) {
    std::string list;
    for (const ClosedLoop::Instance& instance : loop.instances) {
        if (!instance.environment) continue;
        const Component& component = model.components[instance.component];
        std::string about = component.name;
        for (const Id<Component::Parameter> id : component.parameters.ids()) {
            const Component::Parameter& parameter = component.parameters[id];
            if (timed && parameter.kind == Component::ParameterKind::Constant)
                join(about, argument_text(model, loop, parameter, instance.arguments[id.index]));
        }
        join(list, fmt::format("{} ({})", instance.name, about));
    }
    return list;
}

void add_plant(const PageContent& content, Html& html) {
    if (!content.loop.valid()) return;
    const ClosedLoop& loop = content.model.loops[content.loop];
    html.open("section", {{"id", "plant"}}).put("h2", "Plant and environment");
    if (loop.instances.empty())
        html.open("p", {{"class", "empty"}})
            .prose(
                "The closed loop declares no plant and no environment. Add instances of components, for example "
                "`environment Button = push_button(OUT = START);`.")
            .close("p");
    else begin_table(html, {"instance", "", "component", "begins", "bound to"});
    for (const ClosedLoop::Instance& instance : loop.instances) {
        const Component& component = content.model.components[instance.component];
        std::string bound;
        for (const Id<Component::Parameter> id : component.parameters.ids())
            join(bound, argument_text(content.model, loop, component.parameters[id], instance.arguments[id.index]));
        add_row(html, {instance.name, instance.environment ? "environment" : "plant", component.name,
                       component.locations[instance.initial].name, bound});
    }
    if (!loop.instances.empty()) end_table(html);
    for (const ComponentContent& each : content.components)
        add_component(content.model.components[each.component], each, html);
    html.close("section");
}

}  // namespace grafverif
