// SPDX-License-Identifier: MIT
// Translates properties of a loop to properties of an untimed model, for all schedules. LoopMeaning maps the names of
// the loop to main. LoopMeaning is used to translate terms of properties, constraints and observer guards. Properties
// that a model cannot express are omitted, with the reason.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"
#include "schedule/main.hpp"

namespace grafverif::schedule {

/// Meaning of the names of a loop in one of its models.
struct LoopMeaning {
    Main& main;
    const Model& model;
    const ClosedLoop& loop;
    std::span<const Equations> equations;  ///< equations of the controllers, in order
    /// Symbol of main for each shared variable. It is invalid if the variable belongs to the plant and the model has no
    /// plant.
    std::vector<Id<Symbol>> shared = {};
    /// Returns the symbol of main for a variable of a controller's equations.
    std::function<Id<Symbol>(std::size_t controller, Id<Equations::Variable>)> variable = {};
    /// Returns the condition that an instance of the plant is in a location. This function is empty if the model has no
    /// plant.
    std::function<Id<Expr>(std::size_t instance, std::uint32_t location)> at = {};
    /// Returns the symbol of main for argument number `argument` of an instance of the plant. This function is empty if
    /// the model has no plant.
    std::function<Id<Symbol>(std::size_t instance, std::size_t argument)> own = {};
    /// For each observer (set by add_observers): the symbol of main for its location, and the reason why properties
    /// cannot read this symbol. The reason is empty if they can read it.
    std::vector<Id<Symbol>> observers = {};
    std::vector<std::string> unobserved = {};
    /// Conditions that an edge can be taken, and that time can pass, for `no deadlock` and `no timelock`. They are
    /// invalid if the model does not determine them.
    Id<Expr> can_move = {}, can_wait = {};
    bool checked_when_stable = false;  ///< true if every property is evaluated only in quiescent states
};

/// Translates `expr` of the loop to the symbols of main. If the translation is impossible, the result is invalid, and
/// `reason` receives the reason.
Id<Expr> term_of(const LoopMeaning& meaning, Id<Expr> expr, std::string& reason);

/// Adds a property of the loop to `system.properties` or `system.omitted`.
void add_property(const LoopMeaning& meaning, const Property& property);

/// Adds a property called `name`, which states that none of `flags` is ever true. Has no effect if there are no flags.
void add_never(TransitionSystem& system, const std::string& name, std::string text, const std::vector<Id<Expr>>& flags);

}  // namespace grafverif::schedule
