// SPDX-License-Identifier: MIT
// Builds components in C++, for tests and generators that do not use the text language.
#pragma once

#include <utility>

#include "grafverif/ir/component.hpp"

namespace grafverif {

/// Shorthand for writing components by hand.
struct ComponentBuilder {
    using ParameterKind = Component::ParameterKind;
    using ValueKind = Component::ValueKind;

    Component component = {};

    Id<Expr> parameter(const char* name, ParameterKind kind, ValueKind value = ValueKind::Boolean) {
        return component.exprs.leaf(Op::Parameter,
                                    component.parameters.add({.name = name, .kind = kind, .value = value}).index);
    }
    Id<Component::Location> location(const char* name) { return component.locations.add({.name = name}); }
    Component::Edge& edge(Id<Component::Location> from, Id<Component::Location> to, bool urgent, Id<Expr> guard) {
        return component.edges[component.edges.add({.from = from, .to = to, .urgent = urgent, .guard = guard})];
    }
};

}  // namespace grafverif
