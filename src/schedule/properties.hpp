// SPDX-License-Identifier: MIT
// The properties of a loop as properties of an untimed model of it.
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

/// One step of a chart: `7`, `G2.7`, or with several controllers `press.7`, `press.G2.7`; and whether it is active.
struct StepTerm {
    std::string label = {};
    Id<Expr> active = {};
};

/// What an untimed model says of the names of a loop, over the symbols of main.
struct LoopMeaning {
    /// Not valid where the model has nothing of the kind; then `reason` says why.
    std::function<Id<Expr>(const ClosedLoop::Symbol&, std::string& reason)> term = {};
    std::vector<StepTerm> steps = {};
    /// Why the model cannot answer a pattern; empty: it can.
    std::function<std::string(Pattern)> refusal = {};
    /// Whether every property is judged in settled states only.
    bool judged_when_settled = false;
};

/// Of controllers that are instances of main: per shared variable in `shared` the symbol of main that it is; not valid
/// for one of the plant's own. Locations of the plant have no meaning.
LoopMeaning meaning_of_controllers(Members& members, const Model& model, const ClosedLoop& loop,
                                   std::span<const Equations> equations, const std::vector<Id<Symbol>>& shared);

/// Why a model without deadlocks of its own cannot answer a pattern.
std::string untimed_refusal(Pattern pattern);

/// `expr` of the loop over the symbols of main; or not valid, and `reason` says why.
Id<Expr> term_of(TransitionSystem& system, const ClosedLoop& loop, const LoopMeaning& meaning, Id<Expr> expr,
                 std::string& reason);

/// The properties of `loop`, each in `system.properties` or in `system.omitted`.
void add_properties(TransitionSystem& system, const ClosedLoop& loop, const LoopMeaning& meaning);

/// The constraints of `loop` as properties to prove, where the model has what they read.
void add_constraint_properties(TransitionSystem& system, const ClosedLoop& loop, const LoopMeaning& meaning);

/// `no_race` and `no_out_of_range`, where such faults are possible.
void add_fault_properties(Members& members, std::span<const Equations> equations);

/// `name`: never one of `flags`; nothing where there are none.
void add_never(TransitionSystem& system, std::string name, std::string text, const std::vector<Id<Expr>>& flags);

}  // namespace grafverif::schedule
