// SPDX-License-Identifier: MIT
#include "lsp/hover.hpp"

#include <algorithm>
#include <optional>

#include "syntax/print/equations.hpp"

namespace grafverif::lsp {

namespace {

/// Returns the text of a file as a Markdown code block. No part of it is interpreted as markup.
std::string fenced(std::string_view text, const char* language) {
    std::string fence = "```";
    while (text.find(fence) != std::string_view::npos) fence += '`';
    return fence + language + "\n" + std::string(text) + "\n" + fence + "\n";
}

/// Returns the equations of a step, a transition, an output or a stored variable, or an empty string if there are none.
std::string equation_of(const Declaration& thing, const Model& model) {
    const std::string name = thing.owner.substr(thing.owner.find(' ') + 1);
    const auto chart = find_chart(model, name);
    Diagnostics ignored;
    const auto equations = chart ? equations_of(model, *chart, ignored) : std::nullopt;
    if (!equations) return {};
    const auto is_called = [&](Id<Equations::Variable> variable) {
        return equations->variables[variable].name == thing.name;
    };
    if (thing.kind == DeclarationKind::Step) {
        for (const Equations::StepActivity& step : equations->steps)
            if (step.step.step == thing.name && thing.key.starts_with(thing.owner + "/s " + step.step.partial + "/"))
                return equation_text(*equations, step.variable, step.next);
    } else if (thing.kind == DeclarationKind::Transition) {
        for (const Equations::Firing& firing : equations->firings)
            if (firing.transition == thing.name) return equation_text(*equations, firing.variable, firing.condition);
    } else if (thing.kind == DeclarationKind::Output || thing.kind == DeclarationKind::Internal) {
        for (const Equations::Stored& stored : equations->stored)
            if (is_called(stored.variable)) return equation_text(*equations, stored.variable, stored.next);
        for (const Equations::Output& output : equations->outputs)
            if (is_called(output.variable)) return equation_text(*equations, output.variable, output.value);
    }
    return {};
}

std::string documentation_of(const Names& names, const Declaration& thing) {
    const bool parameter = thing.kind == DeclarationKind::InputParameter ||
                           thing.kind == DeclarationKind::OutputParameter || thing.kind == DeclarationKind::Constant;
    if (parameter && !thing.owner.starts_with("loop "))
        if (const Declaration* const component = names.thing(thing.owner))
            return parameter_comment(*component->file, component->whole, thing.name);
    if (thing.kind == DeclarationKind::Instance) {
        const Declaration* const component = names.thing(names.component_of(thing.key));
        return component == nullptr ? std::string() : comment_of(*component->file, component->whole);
    }
    return comment_of(*thing.file, thing.whole);
}

/// Returns the declaration with types that are implicit in the source.
std::string shown_declaration(const Declaration& thing) {
    const std::string text = declaration_text(thing);
    const bool variable = thing.kind == DeclarationKind::Input || thing.kind == DeclarationKind::Output ||
                          thing.kind == DeclarationKind::Internal || thing.kind == DeclarationKind::Own ||
                          thing.kind == DeclarationKind::InputParameter ||
                          thing.kind == DeclarationKind::OutputParameter;
    if (!variable || text.find(':') != std::string::npos) return text;
    const std::size_t value = std::min(text.find(" ="), text.size());
    return text.substr(0, value) + ": bool" + text.substr(value);
}

}  // namespace

std::string hover_text(const Names& names, const Declaration& thing, const Model* model) {
    std::string text = fenced(shown_declaration(thing), "grafcet");
    const std::string documentation = documentation_of(names, thing);
    if (!documentation.empty()) text += "\n" + fenced(documentation, "text");
    const std::string equation =
        model != nullptr && thing.owner.starts_with("chart ") ? equation_of(thing, *model) : "";
    if (!equation.empty()) text += "\n" + fenced(equation, "text");
    return text;
}

}  // namespace grafverif::lsp
