// SPDX-License-Identifier: MIT
// resolve: tree -> Chart, Component, ClosedLoop. Names become ids, expressions get types, and the rules of GRAFCET and
// of the language that an author can break are checked, each with a diagnostic of its own.
//
// Charts and components stand alone; a closed loop is resolved against the charts and components of its model, which
// it names by strings, so that they may come from other files.
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

/// Empty after at least one error. Constructs that a later stage refuses are held, not refused.
std::optional<Chart> resolve_chart(const tree::File& file, const tree::Chart& written, Diagnostics& diagnostics);

std::optional<Component> resolve_component(const tree::File& file, const tree::Component& written,
                                           Diagnostics& diagnostics);

/// What a closed loop may name. Charts and components in error are known, so that the loop says nothing more of them.
struct LoopContext {
    const Model& model;
    std::unordered_set<std::string> charts_in_error = {};
    std::unordered_set<std::string> components_in_error = {};
    std::vector<std::string> component_names = {};  ///< all that could be written, for hints
    /// Values of constants, from outside: in the place of what the loop says.
    std::map<std::string, std::string, std::less<>> constants = {};
};

/// Empty after at least one error, which may be one of a chart or component that the loop names.
std::optional<ClosedLoop> resolve_loop(const tree::File& file, const tree::ClosedLoop& written,
                                       const LoopContext& context, Diagnostics& diagnostics);

}  // namespace grafverif
