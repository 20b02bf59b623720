// SPDX-License-Identifier: MIT
// The controllers as instances of main, whatever their inputs come from.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "schedule/controller_module.hpp"
#include "schedule/properties.hpp"
#include "support/unique_names.hpp"

namespace grafverif::schedule {

struct ControllerPart {
    const Equations& equations;
    ExecutionMode mode = ExecutionMode::StabilitySearch;
};

/// The modules and main, without properties. `names`: those taken in main; `module_names`: those of modules.
struct Assembly {
    TransitionSystem system = {};
    std::vector<ControllerModule> modules = {};
    UniqueNames names = {}, module_names = {};

    TransitionSystem::Module& main() { return system.modules[system.main]; }

    Id<Symbol> free(const std::string& wish, Type type, const char* section, Span origin) {
        return main().symbols.add({names.fresh(wish), type, TransitionSystem::StateSymbol{}, section, origin});
    }
};

/// `turns`, `with_plant`: as in ControllerStyle.
Assembly assemble(std::span<const ControllerPart> controllers, bool turns, bool with_plant);

inline Id<TransitionSystem::Instance> controller_instance(std::size_t controller) {
    return {static_cast<std::uint32_t>(controller)};
}

/// The outputs of every controller, among the shared variables of the loop.
void share_outputs(Members& members, const ClosedLoop& loop, std::span<const Equations> equations,
                   std::vector<Id<Symbol>>& shared);
/// The inputs of every controller as its first arguments.
void wire_inputs(Members& members, const ClosedLoop& loop, std::span<const Equations> equations,
                 const std::vector<Id<Symbol>>& shared);

/// Every controller is settled.
Id<Expr> settled_controllers(Members& members);

/// What traces say of the controllers; `runs` per controller, when it makes a step, or empty: in every step.
void add_names(Members& members, std::span<const ControllerPart> controllers, const std::vector<Id<Expr>>& runs);

}  // namespace grafverif::schedule
