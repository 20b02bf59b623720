// SPDX-License-Identifier: MIT
// resolve: tree -> Chart, Component, ClosedLoop. Replaces names by ids, computes types of expressions, and checks the
// rules of GRAFCET and of the language, each with a separate diagnostic.
//
// Charts and components are resolved independently. A closed loop is resolved against the charts and components of its
// model, which it refers to by strings, so that they may come from other files.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/component.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

/// Empty after at least one error. Constructs that a later stage rejects are represented, not rejected.
std::optional<Chart> resolve_chart(const tree::File& file, const tree::Chart& written, Diagnostics& diagnostics);

std::optional<Component> resolve_component(const tree::File& file, const tree::Component& written,
                                           Diagnostics& diagnostics);

/// Charts and components that a closed loop can refer to. Those with errors are known by name, so that the loop causes
/// no further errors about them.
struct LoopContext {
    const Model& model;
    std::unordered_set<std::string> charts_in_error = {};
    std::unordered_set<std::string> components_in_error = {};
    std::vector<std::string> component_names = {};  ///< all available names, for suggestions
    /// Values of constants set by the user; they override those of the loop.
    std::map<std::string, std::string, std::less<>> constants = {};
};

/// Empty after at least one error, possibly in a chart or component that the loop refers to.
std::optional<ClosedLoop> resolve_loop(const tree::File& file, const tree::ClosedLoop& written,
                                       const LoopContext& context, Diagnostics& diagnostics);

}  // namespace grafverif
