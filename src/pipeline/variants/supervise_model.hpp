// SPDX-License-Identifier: MIT
// Derives a closed loop whose charts can be restricted by permissions. `supervised` builds the game from this loop.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/variants/supervise.hpp"
#include "support/unique_names.hpp"

namespace grafverif {

/// Returns the options of the model for the game and for the proof: untimed, with interleaved plant automata, grain
/// atomic (a PLC cycle is one move).
ModelOptions untimed(const SuperviseRequest& request);

/// A transition or output of a chart, with its permission.
struct PermittedElement {
    std::string permission = {};  ///< input of the chart that permits clearing or setting
    std::string subject = {};     ///< name of the transition or output
    bool output = false;
    std::vector<Span> places = {};            ///< positions of the transition, or of the actions of the output
    std::vector<Id<Chart::Step>> steps = {};  ///< for an output: the steps of its actions
    std::vector<std::string> sets =
        {};  ///< for each action: an output that only this action sets, without restriction; may be empty
};

/// Adds an input to the chart of a controller for each transition, which permits clearing it, and for each continuous
/// output, which permits setting it. If an output has several actions, also adds an output for each action that sets it
/// only during part of the activity of its step. `written` is the chart as in the source files.
std::vector<PermittedElement> add_permissions(Model& model, ClosedLoop& loop, Id<ClosedLoop::Controller> controller,
                                              const Chart& written, const SuperviseRequest& request,
                                              UniqueNames& names);

/// The variables that a controller can observe, with their names in conditions of its chart.
struct ObservableVariables {
    std::vector<std::string> names = {};
    std::vector<Id<Expr>> terms = {};
    std::size_t first_step = 0;  ///< index of the first step variable in `names`
};

ObservableVariables sight_of(TransitionSystem& system, const TransitionSystem::Controller& controller,
                             const ClosedLoop& loop, Id<ClosedLoop::Controller> id);

/// Returns a term that is true if exactly the initial steps of every chart are active.
Id<Expr> initial_situation(TransitionSystem& system, const Model& model, const ClosedLoop& loop);

/// Returns the properties of the system to enforce, or nullopt after an error.
std::optional<std::vector<Id<Property>>> kept(const TransitionSystem& system, const SuperviseRequest& request,
                                              const std::string& marked, Diagnostics& diagnostics);

/// Returns a term that is true exactly in the states that violate the property. Requires a property of single states.
Id<Expr> violation(TransitionSystem& system, const Property& property);

}  // namespace grafverif
