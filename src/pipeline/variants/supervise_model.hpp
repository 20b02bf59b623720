// SPDX-License-Identifier: MIT
// The closed loop with restrictable charts from which `supervised` builds the game.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/variants/supervise.hpp"
#include "support/unique_names.hpp"

namespace grafverif {

/// The model of the game and of its proof: untimed, plant automata interleaved, grain atomic.
ModelOptions untimed(const SuperviseRequest& ask);

/// A transition or output of a chart with a permission.
struct PermittedElement {
    std::string permission = {};  ///< an input of the chart
    std::string subject = {};     ///< the name of the transition or output
    bool output = false;
    std::vector<Span> places = {};            ///< of the transition, or of its actions
    std::vector<Id<Chart::Step>> steps = {};  ///< of an output: those of its actions
    std::vector<std::string> sets =
        {};  ///< per action: an output of the chart that it alone sets, unrestricted; or empty
};

/// Gives the chart of a controller an input for each of its transitions and continuous outputs, which permits the
/// clearing or setting. Also gives it an output for each action that sets its output only sometimes while its step is
/// active, if the output has several actions. `written`: the chart as in the files.
std::vector<PermittedElement> add_permissions(Model& model, ClosedLoop& loop, Id<ClosedLoop::Controller> controller,
                                              const Chart& written, const SuperviseRequest& ask, UniqueNames& names);

/// The variables that a controller can observe, with their names in conditions of its chart.
struct ObservableVariables {
    std::vector<std::string> names = {};
    std::vector<Id<Expr>> terms = {};
};

ObservableVariables sight_of(TransitionSystem& system, const TransitionSystem::Controller& controller,
                             const ClosedLoop& loop, Id<ClosedLoop::Controller> id);

/// True if exactly the initial steps of every chart are active.
Id<Expr> initial_situation(TransitionSystem& system, const Model& model, const ClosedLoop& loop);

/// The properties of the system to be enforced; nothing after an error.
std::optional<std::vector<Id<Property>>> kept(const TransitionSystem& system, const SuperviseRequest& ask,
                                              const std::string& marked, Diagnostics& diagnostics);

/// The states that violate the property, which is about states.
Id<Expr> violation(TransitionSystem& system, const Property& property);

}  // namespace grafverif
