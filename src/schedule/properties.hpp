// SPDX-License-Identifier: MIT
// The properties of a loop as properties of an untimed model of it, whatever the schedule: LoopMeaning says where the
// names of the loop are in main, and every term of a property, of a constraint, of an observer's guard is translated by
// it. What a model cannot say is left out of it, with the reason.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "schedule/controller_module.hpp"

namespace grafverif::schedule {

/// The symbols of instances as main sees them, added to main when first asked for. The first instances of `system` are
/// those of `controllers`, in order.
struct Members {
    TransitionSystem& system;
    std::span<const ControllerModule> controllers;   ///< their modules moved into `system`
    /// Per instance and symbol of its module: its MemberSymbol of main.
    std::map<std::pair<Id<TransitionSystem::Instance>, Id<Symbol>>, Id<Symbol>> known = {};
};

/// `instance.symbol` in main.
Id<Symbol> member(Members& members, Id<TransitionSystem::Instance> instance, Id<Symbol> symbol);
Id<Symbol> member(Members& members, std::size_t controller, Id<Symbol> symbol);

/// Of controllers that are instances of main: LoopMeaning::variable.
inline auto of_controllers(Members& members) {
    return [&members](std::size_t controller, Id<Equations::Variable> variable) {
        return member(members, controller, members.controllers[controller].symbols[variable.index]);
    };
}

/// What the names of a loop stand for in a model of it.
struct LoopMeaning {
    TransitionSystem& system;
    const Model& model;
    const ClosedLoop& loop;
    std::span<const Equations> equations;                 ///< of the controllers, in order
    /// Per shared variable: the symbol of main. Not valid: it is the plant's own, and the model has no plant.
    std::vector<Id<Symbol>> shared = {};
    /// The symbol of main that is a variable of a controller's equations.
    std::function<Id<Symbol>(std::size_t controller, Id<Equations::Variable>)> variable = {};
    /// An instance of the plant is at a location. None: the model has no plant.
    std::function<Id<Expr>(std::size_t instance, std::uint32_t location)> at = {};
    /// Per observer: the symbol of main that is its location; not valid: the model has not what it reads, and
    /// `unobserved` says why. Empty: see add_observers.
    std::vector<Id<Symbol>> observers = {};
    std::vector<std::string> unobserved = {};
    /// Some edge can fire, time can pass: what `no deadlock` and `no timelock` ask for. Not valid: the model cannot say.
    Id<Expr> can_move = {}, can_wait = {};
    bool judged_when_settled = false;                     ///< every property, in settled states only
};

/// `expr` of the loop over the symbols of main; or not valid, and `reason` says why.
Id<Expr> term_of(const LoopMeaning& meaning, Id<Expr> expr, std::string& reason);

/// A property of the loop, in `system.properties` or in `system.omitted`.
void add_property(const LoopMeaning& meaning, const Property& property);

/// Of a model with controllers that are instances of main: `no_race` and `no_out_of_range`, where such faults are possible.
void add_fault_properties(Members& members, std::span<const Equations> equations);

/// `name`: never one of `flags`; nothing where there are none.
void add_never(TransitionSystem& system, std::string name, std::string text, const std::vector<Id<Expr>>& flags);

}  // namespace grafverif::schedule
