// SPDX-License-Identifier: MIT
#include "support/random_system.hpp"

#include <algorithm>

namespace grafverif {

namespace {

using System = TransitionSystem;

/// Generates terms over some symbols of a module.
struct Terms {
    Exprs& exprs;
    Random& random;
    std::vector<Id<Expr>> booleans = {}, integers = {};

    void add(Id<System::Symbol> symbol, Type type) {
        (type.boolean ? booleans : integers).push_back(exprs.leaf(Op::Variable, symbol.index));
    }
    Id<Expr> any(const std::vector<Id<Expr>>& list) {
        return list[static_cast<std::size_t>(random_number(random, 0, static_cast<std::int64_t>(list.size()) - 1))];
    }

    Id<Expr> integer(int depth) {
        if (integers.empty() || depth == 0 || chance(random, 30))
            return integers.empty() || chance(random, 40) ? exprs.integer(random_number(random, -2, 3)) : any(integers);
        const Op ops[] = {Op::Plus, Op::Minus, Op::Times};
        if (chance(random, 25)) return exprs.conditional(boolean(depth - 1), integer(depth - 1), integer(depth - 1));
        return exprs.apply(ops[random_number(random, 0, 2)], integer(depth - 1), integer(depth - 1));
    }

    Id<Expr> boolean(int depth) {
        if (depth == 0 || chance(random, 20)) return any(booleans);
        switch (random_number(random, 0, 4)) {
        case 0: return exprs.conjunction(boolean(depth - 1), boolean(depth - 1));
        case 1: return exprs.disjunction(boolean(depth - 1), boolean(depth - 1));
        case 2: return exprs.negation(boolean(depth - 1));
        case 3: return exprs.conditional(boolean(depth - 1), boolean(depth - 1), boolean(depth - 1));
        default: {
            const Op ops[] = {Op::Equal, Op::Less, Op::GreaterEqual};
            return exprs.apply(ops[random_number(random, 0, 2)], integer(depth - 1), integer(depth - 1));
        }
        }
    }

    /// Returns a value of `type`. `otherwise` replaces an integer outside its range.
    Id<Expr> value(Type type, Id<Expr> otherwise) {
        if (type.boolean) return boolean(3);
        const Id<Expr> candidate = integer(2);
        const Id<Expr> fits = exprs.conjunction(exprs.apply(Op::GreaterEqual, candidate, exprs.integer(type.low)),
                                                exprs.apply(Op::LessEqual, candidate, exprs.integer(type.high)));
        return exprs.conditional(fits, candidate, otherwise);
    }
};

Type random_type(Random& random) {
    if (chance(random, 65)) return {};
    const std::int64_t low = random_number(random, -2, 1);
    return integer_type(low, low + random_number(random, 0, 4));
}

/// Adds state variables, choices and definitions to a module, after its first symbols.
void fill(System::Module& module, Exprs& exprs, Random& random, const std::string& prefix) {
    Terms before{exprs, random};  // terms over state variables and choices
    std::vector<Id<System::Symbol>> states;
    for (const Id<System::Symbol> id : module.symbols.ids()) before.add(id, module.symbols[id].type);
    const auto add = [&](Type type, auto kind) {
        const Id<System::Symbol> id =
            module.symbols.add({prefix + std::to_string(module.symbols.size()), type, kind, "", {}});
        before.add(id, type);
        return id;
    };
    add(Type{}, System::StateSymbol{});
    if (chance(random, 50)) add(random_type(random), System::StateSymbol{});
    for (std::int64_t i = random_number(random, 1, 3); i > 0; --i)
        states.push_back(add(random_type(random), System::StateSymbol{}));
    Terms timeless = before;  // invariants, initial values and justice conditions read no choice
    if (chance(random, 60)) add(Type{}, System::ChoiceSymbol{});
    if (chance(random, 30)) add(integer_type(0, 2), System::ChoiceSymbol{});
    for (std::int64_t i = random_number(random, 0, 2); i > 0; --i) {
        const Id<Expr> value = before.boolean(2);
        add(Type{}, System::DefineSymbol{value});
    }
    for (const Id<System::Symbol> id : states) {
        const Type type = module.symbols[id].type;
        const Id<Expr> self = exprs.leaf(Op::Variable, id.index);
        System::StateSymbol state;
        if (chance(random, 70))
            state.initial = type.boolean ? exprs.constant(chance(random, 50))
                                         : exprs.integer(random_number(random, type.low, type.high));
        state.next = before.value(type, self);
        module.symbols[id].kind = state;
    }
    if (chance(random, 15)) module.invariants.push_back(timeless.boolean(2));
    if (chance(random, 30)) module.transitions.push_back(exprs.disjunction(before.boolean(2), before.boolean(2)));
    for (std::int64_t i = random_number(random, 0, 5); i > 3; --i) module.justice.push_back(timeless.boolean(2));
}

}  // namespace

TransitionSystem random_system(Random& random) {
    System system;
    system.name = "random";
    System::Module main{.name = "main"};
    fill(main, system.exprs, random, "m");
    system.main = system.modules.add(std::move(main));
    if (chance(random, 50)) {
        System::Module part{.name = "part"};
        part.symbols.add({"p", {}, System::ParameterSymbol{}, "", {}});
        fill(part, system.exprs, random, "s");
        part.justice.clear();  // justice conditions read only symbols that the main module names
        const Id<System::Module> module = system.modules.add(std::move(part));
        const Id<System::Instance> instance = system.instances.add({"part_1", module, {{0}}});
        const Table<System::Symbol> symbols = system.modules[module].symbols;
        for (const Id<System::Symbol> id : symbols.ids())
            if (std::holds_alternative<System::StateSymbol>(symbols[id].kind))
                system.modules[system.main].symbols.add(
                    {"part_1." + symbols[id].name, symbols[id].type, System::MemberSymbol{instance, id}, "", {}});
    }
    Terms settled{system.exprs, random};
    for (const Id<System::Symbol> id : system.modules[system.main].symbols.ids()) {
        const System::Symbol& symbol = system.modules[system.main].symbols[id];
        if (std::holds_alternative<System::StateSymbol>(symbol.kind)) settled.add(id, symbol.type);
    }
    system.settled = settled.boolean(2);
    return system;
}

namespace {

bool offers_choices(const System::Module& module) {
    return std::ranges::any_of(module.symbols, [](const System::Symbol& symbol) {
        return std::holds_alternative<System::ChoiceSymbol>(symbol.kind);
    });
}

}  // namespace

bool holds_in_states(const System& system, const System::Symbol& symbol) {
    if (const auto* member = std::get_if<System::MemberSymbol>(&symbol.kind)) {
        const System::Module& module = system.modules[system.instances[member->instance].module];
        return std::holds_alternative<System::StateSymbol>(module.symbols[member->symbol].kind) ||
               !offers_choices(module);
    }
    return std::holds_alternative<System::StateSymbol>(symbol.kind);
}

void ask_more(System& system, Random& random) {
    Terms terms{system.exprs, random};
    for (const Id<System::Symbol> id : system.modules[system.main].symbols.ids()) {
        const System::Symbol& symbol = system.modules[system.main].symbols[id];
        if (symbol.type.boolean && holds_in_states(system, symbol)) terms.add(id, symbol.type);
    }
    for (const Pattern pattern : {Pattern::Always, Pattern::Never, Pattern::Reachable, Pattern::Inevitable,
                                  Pattern::LeadsTo, Pattern::AlwaysPossible, Pattern::ExactlyOneOf}) {
        Property property;
        property.name = "more_" + std::to_string(system.properties.size());
        property.pattern = pattern;
        property.operands = {terms.boolean(2)};
        if (pattern == Pattern::LeadsTo || pattern == Pattern::ExactlyOneOf)
            property.operands.push_back(terms.boolean(2));
        property.at_stable = chance(random, 30);
        system.properties.add(std::move(property));
    }
}

}  // namespace grafverif
