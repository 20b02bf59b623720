// SPDX-License-Identifier: MIT
// Maps the elements of a flat system to the names in the model that `emit` writes. grafverif uses the map to read
// traces of NuSMV.
#include "emit/nusmv/nusmv.hpp"
#include "emit/nusmv/text.hpp"

namespace grafverif::nusmv {

SystemSpelling spelling(const TransitionSystem& system) {
    const Names names = names_of(system);
    SystemSpelling result;
    result.properties = names.properties;
    const auto add_module = [&](Id<TransitionSystem::Module> id, const std::string& path) {
        const TransitionSystem::Module& module = system.modules[id];
        for (const Id<TransitionSystem::Symbol> symbol : module.symbols.ids()) {
            const TransitionSystem::Symbol& here = module.symbols[symbol];
            if (!std::holds_alternative<TransitionSystem::StateSymbol>(here.kind) &&
                !std::holds_alternative<TransitionSystem::ChoiceSymbol>(here.kind))
                continue;
            result.variables.push_back(path + names.symbols[id.index][symbol.index]);
            std::vector<std::string>& values = result.values.emplace_back();
            for (const std::string& value : here.values) values.push_back(names.values[names.value_places.at(value)]);
        }
    };
    add_module(system.main, "");
    for (const Id<TransitionSystem::Instance> id : system.instances.ids())
        add_module(system.instances[id].module, names.instances[id.index] + ".");
    return result;
}

}  // namespace grafverif::nusmv
