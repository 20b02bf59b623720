// SPDX-License-Identifier: MIT
// ComponentScope: symbol tables of a component during name resolution.
#pragma once

#include <string_view>
#include <unordered_map>
#include <variant>

#include "grafverif/ir/component.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "syntax/language/tree.hpp"
#include "syntax/resolve/references.hpp"
#include "syntax/resolve/terms.hpp"

namespace grafverif {

struct ComponentScope {
    using Symbol = std::variant<Id<Component::Parameter>, Id<Component::Variable>, Id<Component::Clock>>;

    const tree::File& file;
    Diagnostics& diagnostics;
    Recorder record = {};
    Component component = {};

    std::unordered_map<Id<tree::Word>, Symbol> symbols = {};
    std::unordered_map<Id<tree::Word>, Id<Component::Location>> locations = {};

    std::string_view text(tree::Name name) const { return file.text(name); }
};

Span origin(const Component& component, const ComponentScope::Symbol& symbol);
TermKind kind_of(Component::ValueKind kind);

// -- parameters.cpp
void resolve_parameters(ComponentScope& scope, const tree::Component& written);
void resolve_own_variables(ComponentScope& scope, const tree::Variables& written);
void declare(ComponentScope& scope, tree::Name name, ComponentScope::Symbol symbol, Span whole);
/// Returns the resolver of guards and assignments, which may contain all names of the component.
Terms all_terms(ComponentScope& scope);
/// Returns the resolver of ranges, defaults, bounds and values at power-on, which may contain only constants. `user`
/// describes the term in messages.
Terms constant_terms(ComponentScope& scope, std::string_view user);

// -- edges.cpp
void declare_location(ComponentScope& scope, const tree::Location& written);
void resolve_location(ComponentScope& scope, const tree::Location& written);
void resolve_edge(ComponentScope& scope, const tree::Edge& written);

}  // namespace grafverif
