// SPDX-License-Identifier: MIT
// verify: checks the invariants of a TransitionSystem. Each group of invariants has a separate function.
#include "grafverif/ir/transition_system.hpp"

#include <algorithm>
#include <unordered_set>

#include "ir/sorts.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

namespace {

using System = TransitionSystem;
using Faults = std::vector<std::string>;

/// Returns the sort checker for terms in the scope of one module.
Sorts sorts_in(const Exprs& exprs, const System::Module& module) {
    return {exprs, [&module](const Expr& leaf) {
                const bool known = leaf.op == Op::Variable && leaf.value >= 0 &&
                                   static_cast<std::size_t>(leaf.value) < module.symbols.size();
                return known ? sort_of(module.symbols[{static_cast<std::uint32_t>(leaf.value)}].type) : Sort::None;
            }};
}

void check_member(const System& system, bool in_main, const System::Symbol& symbol, const System::MemberSymbol& member,
                  Faults& faults) {
    const std::string where = "`" + symbol.name + "`";
    if (!in_main) return faults.push_back(where + " refers to a symbol of an instance, but is not in the main module");
    if (!system.instances.contains(member.instance))
        return faults.push_back(where + " refers to an instance that does not exist");
    const Id<System::Module> module = system.instances[member.instance].module;
    if (!system.modules.contains(module) || !system.modules[module].symbols.contains(member.symbol))
        return faults.push_back(where + " refers to a symbol that its instance does not have");
    if (system.modules[module].symbols[member.symbol].type != symbol.type)
        faults.push_back(where + " has a type that differs from the one of its symbol");
}

void check_symbols(const System& system, Id<System::Module> id, Sorts& sorts, Faults& faults) {
    const System::Module& module = system.modules[id];
    std::unordered_set<std::string_view> names;
    bool parameters_over = false;
    for (const System::Symbol& symbol : module.symbols) {
        const std::string where = module.name + ": `" + symbol.name + "`";
        if (symbol.name.empty() || !names.insert(symbol.name).second)
            faults.push_back(where + " does not have a unique name");
        const auto width = static_cast<std::size_t>(symbol.type.high - symbol.type.low + 1);
        if (!symbol.values.empty() && (symbol.type.boolean || symbol.values.size() != width))
            faults.push_back(where + " does not have exactly one name for each value");
        if (symbol.type.low > symbol.type.high) faults.push_back(where + " has an empty range");
        const bool parameter = std::holds_alternative<System::ParameterSymbol>(symbol.kind);
        if (parameter && (parameters_over || id == system.main)) faults.push_back(where + " is a misplaced parameter");
        parameters_over = parameters_over || !parameter;
        std::visit(overloaded{
                       [](const System::ParameterSymbol&) {},
                       [&](const System::StateSymbol& state) {
                           if (state.initial)
                               sorts.check(*state.initial, sort_of(symbol.type), where + ": initial", faults);
                           if (state.next) sorts.check(*state.next, sort_of(symbol.type), where + ": next", faults);
                       },
                       [](const System::ChoiceSymbol&) {},
                       [&](const System::DefineSymbol& define) {
                           sorts.check(define.value, sort_of(symbol.type), where + ": definition", faults);
                       },
                       [&](const System::MemberSymbol& member) {
                           check_member(system, id == system.main, symbol, member, faults);
                       },
                   },
                   symbol.kind);
    }
    for (const Id<Expr> term : module.invariants) sorts.check(term, Sort::Boolean, module.name + ": invariant", faults);
    for (const Id<Expr> term : module.transitions)
        sorts.check(term, Sort::Boolean, module.name + ": transition", faults);
    for (const Id<Expr> term : module.justice) sorts.check(term, Sort::Boolean, module.name + ": justice", faults);
}

/// Checks that the definitions of a module, or its initial values, are acyclic (Kahn's algorithm: repeatedly remove
/// symbols without remaining dependencies).
void check_acyclic(const System& system, const System::Module& module, bool initial, Faults& faults) {
    std::vector<std::size_t> open(module.symbols.size());
    std::vector<std::vector<std::uint32_t>> dependents(module.symbols.size());
    for (const Id<System::Symbol> id : module.symbols.ids()) {
        Id<Expr> value;
        if (const auto* define = std::get_if<System::DefineSymbol>(&module.symbols[id].kind)) value = define->value;
        else if (const auto* state = std::get_if<System::StateSymbol>(&module.symbols[id].kind))
            if (initial && state->initial) value = *state->initial;
        if (!value.valid() || !system.exprs.contains(value)) continue;
        for (const Id<Expr> leaf : leaves(system.exprs, value)) {
            const auto read = static_cast<std::size_t>(system.exprs[leaf].value);
            if (read >= dependents.size()) continue;
            dependents[read].push_back(id.index);
            ++open[id.index];
        }
    }
    std::vector<std::uint32_t> ready;
    for (std::uint32_t index = 0; index < open.size(); ++index)
        if (open[index] == 0) ready.push_back(index);
    std::size_t done = 0;
    for (; done < ready.size(); ++done)
        for (const std::uint32_t dependent : dependents[ready[done]])
            if (--open[dependent] == 0) ready.push_back(dependent);
    if (done != open.size())
        faults.push_back(module.name +
                         (initial ? ": initial values depend on themselves" : ": definitions depend on themselves"));
}

void check_instances(const System& system, Faults& faults) {
    const System::Module& main = system.modules[system.main];
    for (const System::Instance& instance : system.instances) {
        const std::string where = "instance `" + instance.name + "`";
        if (!system.modules.contains(instance.module) || instance.module == system.main) {
            faults.push_back(where + " has no module that can be instantiated");
            continue;
        }
        std::vector<Type> parameters;
        for (const System::Symbol& symbol : system.modules[instance.module].symbols)
            if (std::holds_alternative<System::ParameterSymbol>(symbol.kind)) parameters.push_back(symbol.type);
        if (parameters.size() != instance.arguments.size()) {
            faults.push_back(where +
                             " has a number of arguments that differs from the number of parameters of its module");
            continue;
        }
        for (std::size_t i = 0; i < parameters.size(); ++i)
            if (!main.symbols.contains(instance.arguments[i]) ||
                main.symbols[instance.arguments[i]].type != parameters[i])
                faults.push_back(where +
                                 ": an argument is not a symbol of the main module with the type of the parameter");
    }
}

/// Returns the number of operands of a property with this pattern; empty if the pattern has any number of operands, but
/// at least one.
std::optional<std::size_t> arity(Pattern pattern) {
    switch (pattern) {
    case Pattern::Always:
    case Pattern::Never:
    case Pattern::Reachable:
    case Pattern::Inevitable:
    case Pattern::AlwaysPossible: return 1;
    case Pattern::LeadsTo: return 2;
    case Pattern::ExactlyOneOf: return {};
    case Pattern::NoDeadlock:
    case Pattern::NoTimelock:
    case Pattern::ReachableAllSteps:
    case Pattern::Watched:
    case Pattern::RawUppaal:
    case Pattern::RawCtl:
    case Pattern::RawLtl: return 0;
    }
    unreachable();
}

void check_properties(const System& system, Sorts& sorts, Faults& faults) {
    for (const Property& property : system.properties) {
        const std::string where = "property `" + property.name + "`";
        const auto expected = arity(property.pattern);
        if (expected ? property.operands.size() != *expected : property.operands.empty())
            faults.push_back(where + " has the wrong number of operands");
        const bool foreign = property.pattern == Pattern::NoDeadlock || property.pattern == Pattern::NoTimelock ||
                             property.pattern == Pattern::RawUppaal || property.pattern == Pattern::ReachableAllSteps ||
                             property.pattern == Pattern::Watched;
        if (foreign) faults.push_back(where + " has a pattern that transition systems do not support");
        for (const Id<Expr> operand : property.operands)
            sorts.check(operand, Sort::Boolean, where + ": operand", faults);
    }
    if (system.settled.valid()) sorts.check(system.settled, Sort::Boolean, "settled", faults);
    for (const System::Omitted& omitted : system.omitted)
        if (omitted.before > system.properties.size()) faults.push_back("an omitted property has an invalid position");
}

/// True for each symbol whose value depends on a choice, per module.
using Chosen = std::vector<std::vector<bool>>;

bool reads_choice(const System& system, const std::vector<bool>& chosen, Id<Expr> term) {
    return std::ranges::any_of(leaves(system.exprs, term), [&](Id<Expr> leaf) {
        return chosen[static_cast<std::size_t>(system.exprs[leaf].value)];
    });
}

/// True if `symbol` depends on a choice according to the current entries of `chosen`.
bool is_chosen(const System& system, const Chosen& chosen, Id<System::Module> module, Id<System::Symbol> symbol) {
    return std::visit(overloaded{
                          [&](const System::ParameterSymbol&) {
                              return std::ranges::any_of(system.instances, [&](const System::Instance& instance) {
                                  return instance.module == module &&
                                         chosen[system.main.index][instance.arguments[symbol.index].index];
                              });
                          },
                          [](const System::StateSymbol&) { return false; },
                          [](const System::ChoiceSymbol&) { return true; },
                          [&](const System::DefineSymbol& define) {
                              return reads_choice(system, chosen[module.index], define.value);
                          },
                          [&](const System::MemberSymbol& member) -> bool {
                              return chosen[system.instances[member.instance].module.index][member.symbol.index];
                          },
                      },
                      system.modules[module].symbols[symbol].kind);
}

Chosen chosen_symbols(const System& system) {
    Chosen chosen;
    for (const System::Module& module : system.modules) chosen.emplace_back(module.symbols.size());
    for (bool grew = true; grew;) {
        grew = false;
        for (const Id<System::Module> module : system.modules.ids())
            for (const Id<System::Symbol> symbol : system.modules[module].symbols.ids()) {
                if (chosen[module.index][symbol.index] || !is_chosen(system, chosen, module, symbol)) continue;
                chosen[module.index][symbol.index] = true;
                grew = true;
            }
    }
    return chosen;
}

/// Checks that conditions on states do not read choices. Requires that the system is otherwise well formed.
void check_choices(const System& system, Faults& faults) {
    const Chosen chosen = chosen_symbols(system);
    const auto check = [&](Id<System::Module> module, Id<Expr> term, const std::string& what) {
        if (reads_choice(system, chosen[module.index], term)) faults.push_back(what + " reads a choice");
    };
    for (const Id<System::Module> id : system.modules.ids()) {
        const System::Module& module = system.modules[id];
        for (const System::Symbol& symbol : module.symbols)
            if (const auto* state = std::get_if<System::StateSymbol>(&symbol.kind); state && state->initial)
                check(id, *state->initial, module.name + ": the initial value of `" + symbol.name + "`");
        for (const Id<Expr> term : module.invariants) check(id, term, module.name + ": an invariant");
        for (const Id<Expr> term : module.justice) check(id, term, module.name + ": a justice condition");
    }
    for (const Property& property : system.properties)
        for (const Id<Expr> operand : property.operands)
            check(system.main, operand, "property `" + property.name + "`");
    if (system.settled.valid()) check(system.main, system.settled, "settled");
}

/// Checks the data that map a run to charts and plant: symbols of main and conditions over these symbols.
void check_names(const System& system, Sorts& sorts, Faults& faults) {
    const Table<System::Symbol>& symbols = system.modules[system.main].symbols;
    const auto known = [&](Id<System::Symbol> symbol, const std::string& where) {
        if (!symbols.contains(symbol)) faults.push_back(where + " is not a symbol of the main module");
    };
    const auto each = [&](const std::vector<System::Named>& list, const std::string& where) {
        for (const System::Named& named : list) known(named.variable, where + ": `" + named.name + "`");
    };
    for (const Id<System::Instance> observer : system.observers)
        if (!system.instances.contains(observer))
            faults.push_back("an observer refers to an instance that does not exist");
    const auto condition = [&](Id<Expr> term, const std::string& where) {
        if (term.valid()) sorts.check(term, Sort::Boolean, where, faults);
    };
    for (const System::Controller& controller : system.controllers) {
        const ControllerWords<System::Symbol>& words = controller.words;
        const std::string where = "controller `" + words.name + "`";
        for (const auto& [name, variable] : words.steps) known(variable, where + ": `" + name.text() + "`");
        for (const auto* list : {&words.transitions, &words.inputs, &words.outputs, &words.internals})
            each(*list, where);
        for (const auto& timer : words.timers) {
            known(timer.end, where + ": a timer output");
            if (timer.step && *timer.step >= words.steps.size())
                faults.push_back(where + ": a timer refers to an unknown step");
        }
        for (const Id<System::Symbol> held : words.held) known(held, where + ": a held input");
        for (const Id<Expr> term :
             {controller.starts, controller.scans, controller.samples, controller.evolves, controller.writes})
            condition(term, where);
    }
    for (const System::Component& component : system.components) {
        const std::string where = "component `" + component.name + "`";
        if (component.location.valid()) known(component.location, where + ": its location");
        each(component.variables, where);
        each(component.inputs, where);
    }
    condition(system.ticks, "ticks");
}

}  // namespace

std::vector<std::string> verify(const TransitionSystem& system) {
    if (!system.modules.contains(system.main)) return {"there is no main module"};
    Faults faults;
    for (const Id<System::Module> id : system.modules.ids()) {
        Sorts sorts = sorts_in(system.exprs, system.modules[id]);
        check_symbols(system, id, sorts, faults);
        if (id == system.main) {
            check_properties(system, sorts, faults);
            check_names(system, sorts, faults);
        }
        check_acyclic(system, system.modules[id], false, faults);
        check_acyclic(system, system.modules[id], true, faults);
    }
    check_instances(system, faults);
    if (faults.empty()) check_choices(system, faults);
    return faults;
}

}  // namespace grafverif
