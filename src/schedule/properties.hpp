// SPDX-License-Identifier: MIT
// The properties of a loop as properties of its controllers alone.
#pragma once

#include <span>

#include "schedule/controller_module.hpp"

namespace grafverif::schedule {

/// The symbols of the controllers as main sees them, added to main when first asked for. The instances of `system` are
/// those of `controllers`, in order.
struct Members {
    TransitionSystem& system;
    std::span<const ControllerModule> controllers;   ///< their modules moved into `system`
    std::vector<std::vector<Id<Symbol>>> known = {};   ///< per controller and module symbol: its MemberSymbol of main
};
Members members(TransitionSystem& system, std::span<const ControllerModule> controllers);

/// `controller.symbol` in main.
Id<Symbol> member(Members& members, std::size_t controller, Id<Symbol> symbol);

/// The properties of `loop`, each in `system.properties` or in `system.omitted`. `shared`: per shared variable the
/// symbol of main that it is; not valid for one of the plant's own.
void add_properties(Members& members, const Model& model, const ClosedLoop& loop,
                    std::span<const Equations> equations, std::span<const Id<Symbol>> shared);

/// `no_race` and `no_out_of_range`, where such faults are possible.
void add_fault_properties(Members& members, std::span<const Equations> equations);

}  // namespace grafverif::schedule
