// SPDX-License-Identifier: MIT
#include "lsp/hover.hpp"

#include <algorithm>
#include <optional>

#include "syntax/print/equations.hpp"

namespace grafverif::lsp {

namespace {

/// Returns `text` as a Markdown code block. No part of the text is interpreted as markup.
std::string fenced(std::string_view text, const char* language) {
    std::string fence = "```";
    while (text.find(fence) != std::string_view::npos) fence += '`';
    return fence + language + "\n" + std::string(text) + "\n" + fence + "\n";
}

/// Returns the equations of a step, a transition, an output or a stored variable, or an empty string if there are none.
std::string equation_of(const Declaration& element, const Model& model) {
    const Declaration* owner = element.owner;
    const std::string partial = owner->kind == DeclarationKind::Partial ? owner->name : "";
    if (owner->owner != nullptr) owner = owner->owner;
    const auto chart = owner->kind == DeclarationKind::Chart ? find_chart(model, owner->name) : std::nullopt;
    Diagnostics ignored;
    const auto equations = chart ? equations_of(model, *chart, ignored) : std::nullopt;
    if (!equations) return {};
    const auto is_called = [&](Id<Equations::Variable> variable) {
        return equations->variables[variable].name == element.name;
    };
    if (element.kind == DeclarationKind::Step) {
        for (const Equations::StepActivity& step : equations->steps)
            if (step.step.step == element.name && step.step.partial == partial)
                return equation_text(*equations, step.variable, step.next);
    } else if (element.kind == DeclarationKind::Transition) {
        for (const Equations::Firing& firing : equations->firings)
            if (firing.transition == element.name) return equation_text(*equations, firing.variable, firing.condition);
    } else if (element.kind == DeclarationKind::Output || element.kind == DeclarationKind::Internal) {
        for (const Equations::Stored& stored : equations->stored)
            if (is_called(stored.variable)) return equation_text(*equations, stored.variable, stored.next);
        for (const Equations::Output& output : equations->outputs)
            if (is_called(output.variable)) return equation_text(*equations, output.variable, output.value);
    }
    return {};
}

std::string documentation_of(const Names& names, const Declaration& element) {
    const bool parameter = element.kind == DeclarationKind::InputParameter ||
                           element.kind == DeclarationKind::OutputParameter ||
                           element.kind == DeclarationKind::Constant;
    if (parameter && element.owner != nullptr && element.owner->kind == DeclarationKind::Component)
        return parameter_comment(*element.owner->file, element.owner->whole, element.name);
    if (element.kind == DeclarationKind::Instance)
        for (const DeclarationKind kind : {DeclarationKind::Component, DeclarationKind::Chart})
            for (const Declaration* const of : names.referred(&element, kind)) return comment_of(*of->file, of->whole);
    return comment_of(*element.file, element.whole);
}

/// Returns the inputs and outputs of a unit of a PLC program, one per line.
std::string interface_text(const Names& names, const Declaration& element) {
    std::vector<const Declaration*> variables =
        element.kind == DeclarationKind::Unit ? names.parts(&element) : std::vector<const Declaration*>();
    std::ranges::sort(variables, {}, [](const Declaration* each) { return each->where.begin; });
    std::string text;
    for (const Declaration* const each : variables)
        if (each->kind == DeclarationKind::Input || each->kind == DeclarationKind::Output)
            text += "\n    " + declaration_text(*each);
    return text;
}

/// Returns the declaration. If a variable has no type in the source, its implicit type `bool` is added.
std::string shown_declaration(const Declaration& element) {
    const std::string text = declaration_text(element);
    if (element.file->language == TextLanguage::StructuredText) return text;
    const bool variable = element.kind == DeclarationKind::Input || element.kind == DeclarationKind::Output ||
                          element.kind == DeclarationKind::Internal || element.kind == DeclarationKind::Own ||
                          element.kind == DeclarationKind::InputParameter ||
                          element.kind == DeclarationKind::OutputParameter;
    if (!variable || text.find(':') != std::string::npos) return text;
    const std::size_t value = std::min(text.find(" ="), text.size());
    return text.substr(0, value) + ": bool" + text.substr(value);
}

}  // namespace

std::string hover_text(const Names& names, const Declaration& element, const Model* model) {
    const bool structured_text = element.file->language == TextLanguage::StructuredText;
    std::string text =
        fenced(shown_declaration(element) + interface_text(names, element), structured_text ? "st" : "grafcet");
    const std::string documentation = documentation_of(names, element);
    if (!documentation.empty()) text += "\n" + fenced(documentation, "text");
    const std::string equation = model != nullptr && element.owner != nullptr ? equation_of(element, *model) : "";
    if (!equation.empty()) text += "\n" + fenced(equation, "text");
    return text;
}

}  // namespace grafverif::lsp
