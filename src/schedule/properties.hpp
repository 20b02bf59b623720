// SPDX-License-Identifier: MIT
// The properties of a loop as properties of an untimed model of it, whatever the schedule: LoopMeaning says where the
// names of the loop are in main, and every term of a property, of a constraint, of an observer's guard is translated by
// it. What a model cannot say is left out of it, with the reason.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"
#include "schedule/main.hpp"

namespace grafverif::schedule {

/// What the names of a loop stand for in a model of it.
struct LoopMeaning {
    Main& main;
    const Model& model;
    const ClosedLoop& loop;
    std::span<const Equations> equations;  ///< of the controllers, in order
    /// Per shared variable: the symbol of main. Not valid: it is the plant's own, and the model has no plant.
    std::vector<Id<Symbol>> shared = {};
    /// The symbol of main that is a variable of a controller's equations.
    std::function<Id<Symbol>(std::size_t controller, Id<Equations::Variable>)> variable = {};
    /// An instance of the plant is at a location. None: the model has no plant.
    std::function<Id<Expr>(std::size_t instance, std::uint32_t location)> at = {};
    /// The argument of an instance of the plant in that place, a variable, as main has it. None: the model has no plant.
    std::function<Id<Symbol>(std::size_t instance, std::size_t argument)> own = {};
    /// Per observer, once add_observers has added them: the symbol of main that is its location; and why properties
    /// cannot read it, or nothing.
    std::vector<Id<Symbol>> observers = {};
    std::vector<std::string> unobserved = {};
    /// Some edge can fire, time can pass: what `no deadlock` and `no timelock` ask for. Not valid: the model cannot
    /// say.
    Id<Expr> can_move = {}, can_wait = {};
    bool judged_when_settled = false;  ///< every property, in settled states only
};

/// `expr` of the loop over the symbols of main; or not valid, and `reason` says why.
Id<Expr> term_of(const LoopMeaning& meaning, Id<Expr> expr, std::string& reason);

/// A property of the loop, in `system.properties` or in `system.omitted`.
void add_property(const LoopMeaning& meaning, const Property& property);

/// `name`: never one of `flags`; nothing where there are none.
void add_never(TransitionSystem& system, const std::string& name, std::string text, const std::vector<Id<Expr>>& flags);

}  // namespace grafverif::schedule
