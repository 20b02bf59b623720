// SPDX-License-Identifier: MIT
// Adds the controllers of a loop as instances of main. The caller determines the source of the inputs of the
// controllers.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "schedule/controller_module.hpp"

namespace grafverif::schedule {

struct ControllerPart {
    const Equations& equations;
    ExecutionMode mode = ExecutionMode::StabilitySearch;
};

/// Returns the controllers of a loop, in order. If given, `mode` overrides the execution modes of the controllers.
std::vector<ControllerPart> controller_parts(const ClosedLoop& loop, std::span<const Equations> equations,
                                             std::optional<ExecutionMode> mode);

struct ControllerInstances {
    Main& main;
    const std::vector<ControllerPart> parts;
    /// Module of each controller. The contents of the modules have been moved into the system.
    std::vector<ControllerModule> modules = {};
    std::vector<Id<TransitionSystem::Instance>> instances = {};  ///< instance of each controller

    /// `turns` and `with_plant` have the same meaning as in ControllerStyle. The constructor does not set the names and
    /// the arguments of the instances; `name` sets the names, and `wire_inputs` sets the inputs.
    ControllerInstances(Main& main, std::vector<ControllerPart> parts, bool turns, bool with_plant);

    /// Gives each instance a name that no symbol of main has. Requires that no symbol of an instance is used in main
    /// yet.
    void name() const;

    /// Returns the symbol that represents a variable of a controller's equations in properties: a symbol or an argument
    /// of its module.
    Id<Symbol> variable(std::size_t controller, Id<Equations::Variable> id) const;
    Id<Expr> inner(std::size_t controller, Id<Symbol> symbol) const {
        return main.inner(instances[controller], symbol);
    }
    std::vector<Id<Symbol>>& arguments(std::size_t controller) const {
        return main.system.instances[instances[controller]].arguments;
    }

    /// Sets the entries of `shared` for the outputs of every controller to the symbols of these outputs.
    void share_outputs(const ClosedLoop& loop, std::vector<Id<Symbol>>& shared) const;
    /// Sets the first arguments of every instance to the symbols of the inputs of its controller.
    void wire_inputs(const ClosedLoop& loop, const std::vector<Id<Symbol>>& shared) const;
    /// Returns a condition that is true if every controller is quiescent.
    Id<Expr> settled() const;
    /// Adds the properties `no_race` (if a race is possible) and `no_out_of_range` (if a value outside a range is
    /// possible).
    void add_fault_properties() const;
    /// Adds TransitionSystem::controllers, which relates the system to the charts for traces. For each controller,
    /// `runs` contains a condition that is true in the steps in which the controller runs. `runs` is empty if all
    /// controllers run in every step.
    void add_words(const std::vector<Id<Expr>>& runs) const;
};

}  // namespace grafverif::schedule
