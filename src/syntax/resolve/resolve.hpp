// SPDX-License-Identifier: MIT
// resolve: converts a syntax tree to a Chart, Component or ClosedLoop. Replaces names by ids, computes types of
// expressions, and checks the rules of GRAFCET and of the language. Each rule has its own diagnostic.
//
// Charts and components are resolved independently. A closed loop is resolved against the charts and components of its
// model. A closed loop refers to charts and components by name, so that they may come from other files.
#pragma once

#include <cstdint>
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
#include "syntax/resolve/chart_instance.hpp"
#include "syntax/resolve/references.hpp"

namespace grafverif {

// The `resolve_` functions add the declarations and references of the tree to `record`, and the number of elements in
// copies of replicated declarations to `copied`; this number is limited (see `largest_expansion`). If the resolution
// continues after errors (see Recorder), the result lacks only the parts with errors instead of being empty.

/// Resolves a chart. The result is empty after at least one error. The returned chart can contain
/// constructs that a later stage rejects. The chart can contain instances of `charts`, which must
/// have been resolved before. If `instance` is not null, the result is this instance of the chart.
std::optional<Chart> resolve_chart(const tree::File& file, const tree::Chart& written, Diagnostics& diagnostics,
                                   Recorder record = {}, std::uint64_t* copied = nullptr,
                                   const WrittenCharts* charts = nullptr, ChartInstance* instance = nullptr);
/// True if the chart contains instances of charts.
bool has_instances(const std::vector<tree::ChartItem>& items);

std::optional<Component> resolve_component(const tree::File& file, const tree::Component& written,
                                           Diagnostics& diagnostics, Recorder record = {},
                                           std::uint64_t* copied = nullptr);

/// Returns the first line of the comment directly above a declaration; empty if a blank line separates them or if the
/// comment does not exist.
std::string summary(const tree::File& file, Span declaration);

DeclarationKind declaration_kind(Chart::VariableKind kind);

/// Charts and components to which a closed loop can refer. Instances of charts are added to the model. The names of
/// charts and components with errors are also known, so that references to these elements cause no further errors.
struct LoopContext {
    Model& model;
    const WrittenCharts& charts;
    std::unordered_set<std::string> components_in_error = {};
    std::vector<std::string> component_names = {};  ///< names of all components, for suggestions

    /// Values of constants that the user has set; these values override the values in the loop.
    std::map<std::string, std::string, std::less<>> constants = {};
};

/// Resolves a closed loop. The result is empty after at least one error in the loop or in a chart or component to which
/// the loop refers.
std::optional<ClosedLoop> resolve_loop(const tree::File& file, const tree::ClosedLoop& written,
                                       const LoopContext& context, Diagnostics& diagnostics, Recorder record = {},
                                       std::uint64_t* copied = nullptr);

}  // namespace grafverif
