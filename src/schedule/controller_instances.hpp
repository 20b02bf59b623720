// SPDX-License-Identifier: MIT
// The controllers as instances of main, whatever their inputs come from.
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

/// Of a loop, in order; `mode` wins over what the loop says.
std::vector<ControllerPart> controller_parts(const ClosedLoop& loop, std::span<const Equations> equations,
                                             std::optional<ExecutionMode> mode);

struct ControllerInstances {
    Main& main;
    const std::vector<ControllerPart> parts;
    std::vector<ControllerModule> modules = {};                  ///< per controller; its module moved into the system
    std::vector<Id<TransitionSystem::Instance>> instances = {};  ///< per controller

    /// `turns`, `with_plant`: as in ControllerStyle. The instances get their names later (`name`), arguments too.
    ControllerInstances(Main& main, std::vector<ControllerPart> parts, bool turns, bool with_plant);

    /// Gives the instances names that nothing in main has so far. Requires that no member was asked for.
    void name() const;

    /// A variable of the equations of a controller, as properties read it: of its module, or what its module is given.
    Id<Symbol> variable(std::size_t controller, Id<Equations::Variable> id) const;
    Id<Expr> inner(std::size_t controller, Id<Symbol> symbol) const {
        return main.inner(instances[controller], symbol);
    }
    std::vector<Id<Symbol>>& arguments(std::size_t controller) const {
        return main.system.instances[instances[controller]].arguments;
    }

    /// Puts the outputs of every controller among the shared variables of the loop.
    void share_outputs(const ClosedLoop& loop, std::vector<Id<Symbol>>& shared) const;
    /// The inputs of every controller, as its first arguments.
    void wire_inputs(const ClosedLoop& loop, const std::vector<Id<Symbol>>& shared) const;
    /// Every controller is settled.
    Id<Expr> settled() const;
    /// `no_race` and `no_out_of_range`, where such faults are possible.
    void add_fault_properties() const;
    /// What traces say of the controllers; `runs` per controller, when it makes a step, or empty: in every step.
    void add_words(const std::vector<Id<Expr>>& runs) const;
};

}  // namespace grafverif::schedule
