// SPDX-License-Identifier: MIT
#include "ir/subsystems.hpp"

#include <algorithm>

namespace grafverif {

using System = TransitionSystem;

std::vector<std::uint32_t> parts_of_symbols(const System& system) {
    std::vector<std::uint32_t> of(system.modules[system.main].symbols.size(), no_part);
    for (std::uint32_t part = 0; part < system.parts.each.size(); ++part)
        for (const auto& [symbol, value] : system.parts.each[part].without) of[symbol.index] = part;
    return of;
}

System with_parts(const System& system, const PartList& chosen) {
    System made = system;
    made.properties = {};
    made.omitted = {};
    made.controllers = {};
    made.components = {};
    made.parts = {};
    const Id<System::Module> nothing = made.modules.add({.name = "nothing"});
    System::Module& main = made.modules[made.main];
    std::vector<Id<Expr>> settled;
    for (std::uint32_t part = 0; part < system.parts.each.size(); ++part) {
        const System::Subsystem& of = system.parts.each[part];
        if (std::ranges::binary_search(chosen, part)) {
            if (of.settled.valid()) settled.push_back(of.settled);
            continue;
        }
        for (const Id<System::Instance> instance : of.instances) {
            made.instances[instance].module = nothing;
            made.instances[instance].arguments = {};
        }
        for (const auto& [symbol, value] : of.without) main.symbols[symbol].kind = System::DefineSymbol{value};
        main.transitions.push_back(made.exprs.negation(of.moves));
    }
    if (made.settled.valid()) made.settled = made.exprs.conjunction(settled);
    return made;
}

std::vector<Id<FlatSystem::Variable>> variables_in_complete(const FlatSystem& part, const FlatSystem& whole) {
    std::vector<Id<FlatSystem::Variable>> found;
    std::uint32_t next = 0;
    for (const FlatSystem::Variable& variable : part.variables) {
        while (whole.variables[{next}].name != variable.name) ++next;  // skips omitted variables
        found.push_back({next++});
    }
    return found;
}

}  // namespace grafverif
