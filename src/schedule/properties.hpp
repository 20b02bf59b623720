// SPDX-License-Identifier: MIT
// Translates properties of a loop to properties of an untimed model, for all schedules. LoopMeaning maps the names of
// the loop to symbols of main; with this map, terms of properties, constraints and observer guards are translated.
// Properties that a model cannot express are added to TransitionSystem::omitted, with the reason.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"
#include "schedule/main.hpp"

namespace grafverif::schedule {

/// Meaning of the names of a closed loop in one untimed model of the loop.
struct LoopMeaning {
    Main& main;
    const Model& model;
    const ClosedLoop& loop;
    std::span<const Equations> equations;  ///< equations of the controllers, in order
    /// Symbol of main for each shared variable. The symbol is invalid if the variable belongs to the plant and the
    /// model has no plant.
    std::vector<Id<Symbol>> shared = {};
    /// Returns the symbol of main for a variable of a controller's equations.
    std::function<Id<Symbol>(std::size_t controller, Id<Equations::Variable>)> variable = {};
    /// Returns a condition that is true if the instance of the plant is in `location`. The member is empty if the model
    /// has no plant.
    std::function<Id<Expr>(std::size_t instance, std::uint32_t location)> at = {};
    /// Returns the symbol of main for argument number `argument` of an instance of the plant. The member is empty if
    /// the model has no plant.
    std::function<Id<Symbol>(std::size_t instance, std::size_t argument)> own = {};
    /// For each observer (set by add_observers): the symbol of main for its location (`observers`), and the reason why
    /// properties cannot read this symbol (`unobserved`). The reason is empty if properties can read the symbol.
    std::vector<Id<Symbol>> observers = {};
    std::vector<std::string> unobserved = {};
    /// `can_move` is true if an edge can be taken (for `no deadlock`); `can_wait` is true if time can pass (for `no
    /// timelock`). `can_move` and `can_wait` are invalid if the model has abstract time or no plant.
    Id<Expr> can_move = {}, can_wait = {};
    bool checked_when_stable = false;  ///< true if every property is evaluated only in quiescent states
};

/// Translates the term `expr` of the loop to a term over symbols of main. If the translation is impossible, the result
/// is invalid, and `reason` receives the reason.
Id<Expr> term_of(const LoopMeaning& meaning, Id<Expr> expr, std::string& reason);

/// Adds a property of the loop to TransitionSystem::properties or, if the model cannot express it, to
/// TransitionSystem::omitted.
void add_property(const LoopMeaning& meaning, const Property& property);

/// Adds a property that states that none of `flags` is ever true. The property is called `name`, or `name_2`, `name_3`,
/// ... if this name is used. Has no effect if `flags` is empty.
void add_never(TransitionSystem& system, const std::string& name, std::string text, const std::vector<Id<Expr>>& flags);

}  // namespace grafverif::schedule
