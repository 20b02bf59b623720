// SPDX-License-Identifier: MIT
// Draft: builder of a module of the TransitionSystem. A Draft contains the symbols of the module, with unique names,
// and creates terms over these symbols. A symbol can be added, and read by terms, before its value is known; `set`
// defines the value later. Main: builder of the system. Main contains the module `main` as a Draft, all other modules,
// the instances of these modules, and the symbols of instances that are visible in main.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "grafverif/ir/transition_system.hpp"
#include "ir/interval.hpp"
#include "support/unique_names.hpp"

namespace grafverif::schedule {

using Symbol = TransitionSystem::Symbol;

inline Id<Expr> implies(Exprs& exprs, Id<Expr> condition, Id<Expr> then) {
    return exprs.disjunction(exprs.negation(condition), then);
}

struct Draft {
    using Kind = decltype(Symbol::kind);

    Exprs& exprs;
    TransitionSystem::Module module = {};
    UniqueNames names = {};

    Id<Symbol> add(const std::string& preferred, Type type, Kind kind, const char* section = "", Span origin = {}) {
        return module.symbols.add({names.fresh(preferred), type, std::move(kind), section, origin, {}});
    }
    /// Adds a symbol with named values.
    Id<Symbol> add(const std::string& preferred, std::vector<std::string> values, Kind kind, const char* section = "") {
        const Type type = integer_type(0, static_cast<std::int64_t>(values.size()) - 1);
        return module.symbols.add({names.fresh(preferred), type, std::move(kind), section, {}, std::move(values)});
    }
    /// Adds a Boolean definition.
    Id<Symbol> define(const std::string& preferred, Id<Expr> value, const char* section = "") {
        return add(preferred, Type{}, TransitionSystem::DefineSymbol{value}, section);
    }
    void set(Id<Symbol> symbol, Kind kind) { module.symbols[symbol].kind = std::move(kind); }

    Id<Expr> leaf(Id<Symbol> symbol) const { return exprs.leaf(Op::Variable, symbol.index); }
    Id<Expr> is(Id<Symbol> symbol, std::int64_t value) const {
        return exprs.apply(Op::Equal, leaf(symbol), exprs.integer(value));
    }
    TypeOf types() const {
        return [this](const Expr& leaf) { return module.symbols[{static_cast<std::uint32_t>(leaf.value)}].type; };
    }
};

struct Main {
    using Instance = TransitionSystem::Instance;

    TransitionSystem system = {};
    Draft draft{system.exprs};
    UniqueNames module_names = {};
    /// For symbols of instances: the corresponding symbols of main, which are added on first use.
    std::map<std::pair<Id<Instance>, Id<Symbol>>, Id<Symbol>> members = {};

    explicit Main(const std::string& name) {
        system.name = name;
        draft.module.name = "main";
        module_names.take("main");
        system.main = system.modules.add({});
    }
    Main(const Main&) = delete;
    Main& operator=(const Main&) = delete;

    Id<TransitionSystem::Module> add_module(TransitionSystem::Module module) {
        module.name = module_names.fresh(module.name);
        return system.modules.add(std::move(module));
    }
    Id<Instance> add_instance(const std::string& preferred, Id<TransitionSystem::Module> module) {
        return system.instances.add({draft.names.fresh(preferred), module, {}});
    }

    /// Returns `instance.symbol` as a symbol of main.
    Id<Symbol> member(Id<Instance> instance, Id<Symbol> symbol) {
        const auto [known, fresh] = members.try_emplace({instance, symbol});
        if (!fresh) return known->second;
        const Symbol& inner = system.modules[system.instances[instance].module].symbols[symbol];
        return known->second = draft.module.symbols.add({system.instances[instance].name + "." + inner.name, inner.type,
                                                         TransitionSystem::MemberSymbol{instance, symbol}, "",
                                                         inner.origin, inner.values});
    }
    Id<Expr> inner(Id<Instance> instance, Id<Symbol> symbol) { return draft.leaf(member(instance, symbol)); }

    TransitionSystem finish() {
        system.modules[system.main] = std::move(draft.module);
        return std::move(system);
    }
};

}  // namespace grafverif::schedule
