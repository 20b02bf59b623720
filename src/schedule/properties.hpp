// SPDX-License-Identifier: MIT
// Properties of a loop as properties of an untimed model, for all schedules. LoopMeaning maps the names of the loop to
// main, and terms of properties, constraints and observer guards are translated by it. Properties that a model cannot
// express are omitted, with the reason.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"
#include "schedule/main.hpp"

namespace grafverif::schedule {

/// Meaning of the names of a loop in a model of it.
struct LoopMeaning {
    Main& main;
    const Model& model;
    const ClosedLoop& loop;
    std::span<const Equations> equations;  ///< of the controllers, in order
    /// Per shared variable: the symbol of main. Invalid: it belongs to the plant, and the model has none.
    std::vector<Id<Symbol>> shared = {};
    /// The symbol of main for a variable of a controller's equations.
    std::function<Id<Symbol>(std::size_t controller, Id<Equations::Variable>)> variable = {};
    /// True if an instance of the plant is in a location. Empty: the model has no plant.
    std::function<Id<Expr>(std::size_t instance, std::uint32_t location)> at = {};
    /// The variable that is argument number `argument` of an instance of the plant, as symbol of main. Empty: the model
    /// has no plant.
    std::function<Id<Symbol>(std::size_t instance, std::size_t argument)> own = {};
    /// Per observer, set by add_observers: the symbol of main for its location, and the reason why properties cannot
    /// read it, or empty.
    std::vector<Id<Symbol>> observers = {};
    std::vector<std::string> unobserved = {};
    /// An edge can be taken, time can pass: conditions of `no deadlock` and `no timelock`. Invalid if the model does
    /// not determine them.
    Id<Expr> can_move = {}, can_wait = {};
    bool checked_when_stable = false;  ///< every property is evaluated only in quiescent states
};

/// Translates `expr` of the loop to the symbols of main; invalid if not possible, with the reason in `reason`.
Id<Expr> term_of(const LoopMeaning& meaning, Id<Expr> expr, std::string& reason);

/// Adds a property of the loop to `system.properties` or `system.omitted`.
void add_property(const LoopMeaning& meaning, const Property& property);

/// Adds the property `name`: none of `flags` is ever true. No effect if there are no flags.
void add_never(TransitionSystem& system, const std::string& name, std::string text, const std::vector<Id<Expr>>& flags);

}  // namespace grafverif::schedule
