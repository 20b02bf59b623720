// SPDX-License-Identifier: MIT
// Resolves a component: its head first, then its variables and clocks, then its locations and edges.
#include <algorithm>
#include <iterator>

#include "support/messages.hpp"
#include "syntax/resolve/component_scope.hpp"
#include "syntax/resolve/expand.hpp"
#include "syntax/resolve/resolve.hpp"

namespace grafverif {

namespace {

bool is_blank(char byte) { return byte == ' ' || byte == '\t' || byte == '\r' || byte == '\n'; }

/// Returns the first line of a comment, without comment delimiters.
std::string first_line(std::string_view comment) {
    comment.remove_prefix(2);
    if (comment.ends_with("*/")) comment.remove_suffix(2);
    while (!comment.empty() && (is_blank(comment.front()) || comment.front() == '*')) comment.remove_prefix(1);
    comment = comment.substr(0, comment.find('\n'));
    while (!comment.empty() && is_blank(comment.back())) comment.remove_suffix(1);
    return std::string(comment);
}

/// Resolves a constraint of a component, which guarantees a condition on its outputs. A constraint reads only outputs,
/// so that a model with free outputs can assume the constraint.
void resolve_constraint(ComponentScope& scope, const tree::Constraint& written) {
    const InCopy copy(scope.diagnostics, scope.file, written.copy);
    const Id<Expr> condition = all_terms(scope).resolve(written.condition, TermKind::Boolean, "a constraint");
    if (!condition.valid()) return;
    const Component& component = scope.component;
    for (const Id<Expr> leaf : leaves(component.exprs, condition)) {
        const Expr& node = component.exprs[leaf];
        const auto index = static_cast<std::uint32_t>(node.value);
        const std::string& name =
            node.op == Op::Variable ? component.variables[{index}].name : component.parameters[{index}].name;
        if (node.op == Op::Variable || component.parameters[{index}].kind == Component::ParameterKind::Input)
            scope.diagnostics.add(messages::constraint_reads(written.where, name, "an output of the component"));
    }
    scope.component.constraints.push_back({condition, written.where});
}

void resolve_items(ComponentScope& scope, const tree::Component& written) {
    resolve_parameters(scope, written);
    for (const tree::ComponentItem& item : written.items) {
        if (const auto* variables = std::get_if<tree::Variables>(&item)) resolve_own_variables(scope, *variables);
        if (const auto* clocks = std::get_if<tree::Clocks>(&item))
            for (const tree::Name& name : clocks->names)
                declare(scope, name, scope.component.clocks.add({std::string(scope.text(name)), name.where}),
                        name.where);
        if (const auto* location = std::get_if<tree::Location>(&item)) declare_location(scope, *location);
    }
    if (scope.component.locations.empty())
        scope.diagnostics.add(messages::empty_component(written.name.where, scope.component.name));
    for (const tree::ComponentItem& item : written.items) {
        if (const auto* location = std::get_if<tree::Location>(&item)) resolve_location(scope, *location);
        if (const auto* edge = std::get_if<tree::Edge>(&item)) resolve_edge(scope, *edge);
        if (const auto* constraint = std::get_if<tree::Constraint>(&item)) resolve_constraint(scope, *constraint);
    }
}

/// Returns the resolver of terms in ranges of index variables and in indices. These terms cannot read parameters,
/// because the declarations are copied before instances bind the parameters.
Terms terms_before_parameters(ComponentScope& scope, const tree::File& file, const tree::Component& written,
                              std::string_view user) {
    Terms terms(scope.file, scope.component.exprs, scope.diagnostics);
    terms.name = [&scope, &file, &written, user = std::string(user)](const tree::Expr& node) {
        const std::string_view name = scope.file.text(node.word);
        const bool parameter = std::ranges::any_of(written.parameters, [&](const tree::Variables& group) {
            return std::ranges::any_of(group.variables, [&](const tree::Variable& each) {
                return node.op == tree::Op::Name && file.text(each.name) == name;
            });
        });
        scope.diagnostics.add(parameter ? messages::reads_parameter(node.where, user, name)
                                        : messages::not_constant(node.where, user));
        return Term{};
    };
    return terms;
}

/// Returns the position of the declaration of `name`, if `name` is a parameter, a variable or a clock; otherwise empty.
std::optional<Span> declared_name(const ComponentScope& scope, std::string_view name) {
    const auto found =
        std::ranges::find(scope.symbols, name, [&](const auto& symbol) { return scope.file.text(symbol.first); });
    return found == scope.symbols.end() ? std::nullopt : std::optional(origin(scope.component, found->second));
}

}  // namespace

std::string summary(const tree::File& file, Span written) {
    const auto after = std::ranges::lower_bound(file.comments, written.begin, {},
                                                [](const tree::Comment& comment) { return comment.where.begin; });
    const auto gap_at = [&](std::uint32_t position) { return std::ranges::binary_search(file.gaps, position); };
    if (after == file.comments.begin() || gap_at(written.begin)) return {};
    const auto here = std::ranges::partition_point(file.declarations, [&](const tree::Declaration& declaration) {
        return where(declaration).begin < written.begin;
    });
    const std::uint32_t before = here == file.declarations.begin() ? 0 : where(*std::prev(here)).end;
    auto first = after;
    while (first != file.comments.begin()) {
        const tree::Comment& comment = *std::prev(first);
        if (!comment.own_line || comment.where.begin < before) break;
        --first;
        if (gap_at(comment.where.begin)) break;
    }
    return first == after ? std::string() : first_line(first->text);
}

std::optional<Component> resolve_component(const tree::File& file, const tree::Component& written,
                                           Diagnostics& diagnostics, Recorder record, std::uint64_t* copied) {
    const std::size_t errors = diagnostics.errors();
    tree::File copies;
    ComponentScope scope{written.replicated ? copies : file, diagnostics, record};
    scope.component.name = file.text(written.name);
    scope.component.origin = written.name.where;
    record.declare(DeclarationKind::Component, scope.component.name, written.name.where, written.where);
    scope.component.summary = summary(file, written.where);
    Expansion expansion{file, copies, diagnostics, record, scope.component.origin};
    expansion.copied = copied;
    expansion.constant_terms = [&](std::string_view user) {
        return terms_before_parameters(scope, file, written, user);
    };
    resolve_expanded(expansion, written, [&](const tree::Component& all) { resolve_items(scope, all); });
    check_indices(expansion, [&](std::string_view name) { return declared_name(scope, name); });
    if (diagnostics.errors() != errors && !record.beyond_errors()) return {};
    return std::move(scope.component);
}

}  // namespace grafverif
