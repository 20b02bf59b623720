// SPDX-License-Identifier: MIT
// Randomized test of emit/nusmv: the text, read back with NuSMV's own precedences, equals the
// transition system. The text and the system have the same modules, parameters, variables, initial
// and next values, definitions and specifications, term by term.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <sstream>

#include "emit/nusmv/nusmv.hpp"
#include "schedule/controller.hpp"
#include "support/derived.hpp"
#include "support/nusmv_reader.hpp"
#include "support/random_loop.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

using System = TransitionSystem;

/// Returns the attribute of the symbol that differs between the text and the system: its definition, initial value,
/// next value or declaration. Returns an empty string if there is no difference.
std::string difference(const System& system, const System::Module& module, const System::Symbol& symbol,
                       NusmvModel& text, NusmvModel::Module& there) {
    const auto same = [&](Id<Expr> term, std::map<std::string, Id<Expr>>& found) {
        const Id<Expr> expected = translate(system.exprs, term, text.exprs, [&](const Expr& leaf) {
            return text.leaf(module.symbols[{static_cast<std::uint32_t>(leaf.value)}].name);
        });
        const auto entry = found.extract(symbol.name);
        return !entry.empty() && entry.mapped() == expected;
    };
    if (const auto* define = std::get_if<System::DefineSymbol>(&symbol.kind))
        return same(define->value, there.defines) ? "" : "the definition of " + symbol.name;
    const auto* state = std::get_if<System::StateSymbol>(&symbol.kind);
    if (state == nullptr) return {};
    if (state->initial && !same(*state->initial, there.initial)) return "the initial value of " + symbol.name;
    if (state->next && !same(*state->next, there.next)) return "the next value of " + symbol.name;
    const auto declared = std::ranges::find(there.variables, symbol.name, &NusmvModel::Variable::name);
    if (declared == there.variables.end() || declared->type != symbol.type) return "the declaration of " + symbol.name;
    return {};
}

std::string module_difference(const System& system, Id<System::Module> id, NusmvModel& text) {
    const System::Module& module = system.modules[id];
    const auto found = std::ranges::find(text.modules, module.name, &NusmvModel::Module::name);
    if (found == text.modules.end()) return "module " + module.name + " is missing";
    NusmvModel::Module there = *found;
    std::vector<std::string> parameters, variables;
    for (const System::Symbol& symbol : module.symbols) {
        const std::string different = difference(system, module, symbol, text, there);
        if (!different.empty()) return module.name + ": " + different;
        if (std::holds_alternative<System::ParameterSymbol>(symbol.kind)) parameters.push_back(symbol.name);
        if (std::holds_alternative<System::StateSymbol>(symbol.kind)) variables.push_back(symbol.name);
    }
    if (parameters != there.parameters) return module.name + ": the parameters";
    if (!there.defines.empty() || !there.initial.empty() || !there.next.empty())
        return module.name + ": the text has additional assignments";
    if (there.justice.size() != module.justice.size()) return module.name + ": justice";
    if (id != system.main) return {};
    if (there.instances.size() != system.instances.size()) return "the instances";
    for (std::size_t k = 0; k < there.instances.size(); ++k) {
        const System::Instance& instance = system.instances[{static_cast<std::uint32_t>(k)}];
        std::vector<std::string> arguments;
        for (const Id<System::Symbol> argument : instance.arguments) arguments.push_back(module.symbols[argument].name);
        if (there.instances[k].name != instance.name || there.instances[k].arguments != arguments)
            return "instance " + instance.name;
    }
    return there.specifications.size() == system.properties.size() ? "" : "the number of specifications";
}

std::string difference(const System& system) {
    std::ostringstream out;
    nusmv::emit(system, out);
    NusmvModel text = read_nusmv(out.str());
    if (!text.error_text.empty()) return text.error_text + "\n" + out.str();
    for (const Id<System::Module> id : system.modules.ids()) {
        const std::string found = module_difference(system, id, text);
        if (!found.empty()) return found + "\n" + out.str();
    }
    return {};
}

TEST(RandomizedNusmvText, TheModelOfARandomLoopReadBackIsItsTransitionSystem) {
    const int cases = test_size(150);
    std::cout << "seeds 1 to " << cases << '\n';
    for (int seed = 1; seed <= cases; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop(random);
        const ClosedLoop& loop = model.loops[{0}];
        const auto equations = derived(model);
        if (!equations) continue;
        const System system = schedule_controllers(model, loop, *equations);
        ASSERT_EQ(verify(system), std::vector<std::string>{}) << "seed " << seed;
        EXPECT_GE(system.properties.size() + system.omitted.size(), loop.properties.size()) << "seed " << seed;
        const std::string found = difference(system);
        ASSERT_EQ(found, "") << "seed " << seed;
    }
}

}  // namespace
}  // namespace grafverif
