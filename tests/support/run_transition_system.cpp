// SPDX-License-Identifier: MIT
#include "support/run_transition_system.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "support/overloaded.hpp"

namespace grafverif {

namespace {

using System = TransitionSystem;

/// A symbol of the main module or, if `instance` is set, of the instance with this index.
struct Site {
    std::optional<std::size_t> instance = {};
    Id<System::Symbol> symbol = {};
};

const System::Module& module_at(const System& system, std::optional<std::size_t> instance) {
    if (!instance) return system.modules[system.main];
    return system.modules[system.instances[{static_cast<std::uint32_t>(*instance)}].module];
}

/// Returns the state symbol or definition that `place` denotes after parameters and members are resolved.
Site resolved(const System& system, Site place) {
    const System::Symbol& symbol = module_at(system, place.instance).symbols[place.symbol];
    if (std::holds_alternative<System::ParameterSymbol>(symbol.kind)) {
        const System::Instance& instance = system.instances[{static_cast<std::uint32_t>(*place.instance)}];
        return resolved(system, {{}, instance.arguments[place.symbol.index]});
    }
    if (const auto* member = std::get_if<System::MemberSymbol>(&symbol.kind))
        return resolved(system, {member->instance.index, member->symbol});
    return place;
}

std::string path_of(const System& system, Site place) {
    const std::string& own = module_at(system, place.instance).symbols[place.symbol].name;
    if (!place.instance) return own;
    return system.instances[{static_cast<std::uint32_t>(*place.instance)}].name + "." + own;
}

/// Evaluates symbols and terms. `state` returns the value of each symbol that is not a definition.
struct Evaluator {
    const System& system;
    std::function<std::int64_t(Site)> state;

    std::int64_t at(Site place) const {
        place = resolved(system, place);
        const System::Symbol& symbol = module_at(system, place.instance).symbols[place.symbol];
        if (const auto* define = std::get_if<System::DefineSymbol>(&symbol.kind))
            return term(define->value, place.instance);
        return state(place);
    }

    std::int64_t term(Id<Expr> root, std::optional<std::size_t> instance) const {
        const auto found = evaluate(system.exprs, root, [&](const Expr& leaf) {
            return at({instance, {static_cast<std::uint32_t>(leaf.value)}});
        });
        EXPECT_TRUE(found.has_value()) << "a term of " << module_at(system, instance).name << " has no value";
        return found.value_or(0);
    }
};

std::int64_t& slot(SystemState& state, Site place) {
    return place.instance ? state.instances[*place.instance][place.symbol.index] : state.main[place.symbol.index];
}

Evaluator in_state(const System& system, const SystemState& state) {
    return {system, [&state](Site place) {
                return place.instance ? state.instances[*place.instance][place.symbol.index]
                                      : state.main[place.symbol.index];
            }};
}

/// Calls `visit` for the main module and then for every instance.
template <class Visit>
void each_module(const System& system, const Visit& visit) {
    visit(std::optional<std::size_t>{}, module_at(system, {}));
    for (std::size_t i = 0; i < system.instances.size(); ++i) visit(std::optional(i), module_at(system, i));
}

template <class Visit>
void each_state_symbol(const System& system, const Visit& visit) {
    each_module(system, [&](std::optional<std::size_t> instance, const System::Module& module) {
        for (const Id<System::Symbol> id : module.symbols.ids())
            if (const auto* state = std::get_if<System::StateSymbol>(&module.symbols[id].kind))
                visit(Site{instance, id}, module.symbols[id], *state);
    });
}

SystemState blank(const System& system) {
    SystemState state;
    state.main.resize(module_at(system, {}).symbols.size());
    for (std::size_t i = 0; i < system.instances.size(); ++i)
        state.instances.emplace_back(module_at(system, i).symbols.size());
    return state;
}

void expect_in_range(const System::Symbol& symbol, std::int64_t value) {
    EXPECT_LE(symbol.type.low, value) << symbol.name;
    EXPECT_GE(symbol.type.high, value) << symbol.name;
}

std::optional<Site> site_of(const System& system, std::string_view path) {
    const std::size_t dot = path.find('.');
    std::optional<std::size_t> instance;
    if (dot != std::string_view::npos) {
        for (std::size_t i = 0; i < system.instances.size(); ++i)
            if (system.instances[{static_cast<std::uint32_t>(i)}].name == path.substr(0, dot)) instance = i;
        if (!instance) return {};
        path.remove_prefix(dot + 1);
    }
    const System::Module& module = module_at(system, instance);
    for (const Id<System::Symbol> id : module.symbols.ids())
        if (module.symbols[id].name == path) return Site{instance, id};
    return {};
}

}  // namespace

SystemState first_state(const System& system, const Choose& choose) {
    SystemState state = blank(system), known = blank(system);
    std::function<std::int64_t(Site)> initial;
    const Evaluator evaluator{system, [&](Site place) { return initial(place); }};
    initial = [&](Site place) {
        if (slot(known, place) != 0) return slot(state, place);
        const System::Symbol& symbol = module_at(system, place.instance).symbols[place.symbol];
        const auto& kind = std::get<System::StateSymbol>(symbol.kind);
        const std::int64_t value =
            kind.initial ? evaluator.term(*kind.initial, place.instance) : choose(path_of(system, place), symbol.type);
        expect_in_range(symbol, value);
        slot(known, place) = 1;
        return slot(state, place) = value;
    };
    each_state_symbol(system, [&](Site place, const System::Symbol&, const System::StateSymbol&) { initial(place); });
    return state;
}

SystemState next_state(const System& system, const SystemState& state, const Choose& choose) {
    const auto next = step_taken(system, state, choose);
    EXPECT_TRUE(next.has_value()) << "the step is not possible";
    return next.value_or(state);
}

std::optional<SystemState> step_taken(const System& system, const SystemState& state, const Choose& choose) {
    SystemState before = state;  // the state, with the choices in the slots of their symbols
    each_module(system, [&](std::optional<std::size_t> instance, const System::Module& module) {
        for (const Id<System::Symbol> id : module.symbols.ids())
            if (std::holds_alternative<System::ChoiceSymbol>(module.symbols[id].kind))
                slot(before, {instance, id}) = choose(path_of(system, {instance, id}), module.symbols[id].type);
    });
    SystemState next = blank(system);
    const Evaluator evaluator = in_state(system, before);
    each_state_symbol(system, [&](Site place, const System::Symbol& symbol, const System::StateSymbol& kind) {
        const std::int64_t value =
            kind.next ? evaluator.term(*kind.next, place.instance) : choose(path_of(system, place), symbol.type);
        slot(next, place) = value;
    });
    bool offered = true;
    each_module(system, [&](std::optional<std::size_t> instance, const System::Module& module) {
        for (const Id<Expr> term : module.transitions) offered = offered && evaluator.term(term, instance) != 0;
    });
    if (!offered || !is_allowed(system, next)) return {};
    each_state_symbol(system, [&](Site place, const System::Symbol& symbol, const System::StateSymbol&) {
        expect_in_range(symbol, slot(next, place));
    });
    return next;
}

namespace {

/// Enumerates all combinations of values of some symbols.
struct Valuations {
    std::vector<Site> sites = {};
    std::vector<Type> types = {};

    std::size_t count() const {
        std::size_t valuations = 1;
        for (const Type& type : types)
            if (valuations < 1'000'000'000) valuations *= static_cast<std::size_t>(type.high - type.low + 1);
        return valuations;
    }
    void put(std::size_t valuation, SystemState& state) const {
        for (std::size_t k = 0; k < sites.size(); ++k) {
            const auto width = static_cast<std::size_t>(types[k].high - types[k].low + 1);
            slot(state, sites[k]) = types[k].low + static_cast<std::int64_t>(valuation % width);
            valuation /= width;
        }
    }
};

Valuations choices_of(const System& system, std::optional<std::size_t> instance) {
    Valuations valuations;
    const System::Module& module = module_at(system, instance);
    for (const Id<System::Symbol> id : module.symbols.ids())
        if (std::holds_alternative<System::ChoiceSymbol>(module.symbols[id].kind)) {
            valuations.sites.push_back({instance, id});
            valuations.types.push_back(module.symbols[id].type);
        }
    return valuations;
}

Valuations free_variables(const System& system, bool at_first) {
    Valuations valuations;
    each_state_symbol(system, [&](Site place, const System::Symbol& symbol, const System::StateSymbol& kind) {
        if (at_first ? kind.initial.has_value() : kind.next.has_value()) return;
        valuations.sites.push_back(place);
        valuations.types.push_back(symbol.type);
    });
    return valuations;
}

bool offers(const System& system, const SystemState& state, std::optional<std::size_t> instance) {
    const Evaluator evaluator = in_state(system, state);
    for (const Id<Expr> term : module_at(system, instance).transitions)
        if (evaluator.term(term, instance) == 0) return false;
    return true;
}

/// Returns every permitted combination of choices, with those of the main module first, as states that contain them.
/// Returns nothing if more than `limit` combinations would have to be stored.
std::optional<std::vector<SystemState>> offered_choices(const System& system, const SystemState& state,
                                                        std::size_t limit) {
    std::vector<SystemState> found;
    const Valuations main = choices_of(system, {});
    if (main.count() > limit) return {};
    for (std::size_t valuation = 0; valuation < main.count(); ++valuation) {
        std::vector<SystemState> open{state};
        main.put(valuation, open.front());
        for (std::size_t instance = 0; instance < system.instances.size(); ++instance) {
            const Valuations own = choices_of(system, instance);
            std::vector<SystemState> further;
            for (const SystemState& so_far : open)
                for (std::size_t one = 0; one < own.count() && further.size() <= limit; ++one) {
                    SystemState next = so_far;
                    own.put(one, next);
                    if (offers(system, next, instance)) further.push_back(std::move(next));
                }
            if (further.size() > limit) return {};
            open = std::move(further);
        }
        for (SystemState& whole : open)
            if (offers(system, whole, {})) found.push_back(std::move(whole));
        if (found.size() > limit) return {};
    }
    return found;
}

void make_unique(std::vector<SystemState>& states) {
    std::ranges::sort(states);
    states.erase(std::ranges::unique(states).begin(), states.end());
}

}  // namespace

std::optional<std::vector<SystemState>> successors(const System& system, const SystemState& state, std::size_t limit) {
    const Valuations free = free_variables(system, false);
    const auto choices = offered_choices(system, state, limit);
    if (!choices || free.count() * choices->size() > limit) return {};
    std::vector<SystemState> found;
    for (const SystemState& chosen : *choices) {
        SystemState next = blank(system);
        const Evaluator evaluator = in_state(system, chosen);
        each_state_symbol(system, [&](Site place, const System::Symbol& symbol, const System::StateSymbol& kind) {
            if (!kind.next) return;
            slot(next, place) = evaluator.term(*kind.next, place.instance);
            expect_in_range(symbol, slot(next, place));
        });
        for (std::size_t valuation = 0; valuation < free.count(); ++valuation) {
            free.put(valuation, next);
            if (is_allowed(system, next)) found.push_back(next);
        }
    }
    make_unique(found);
    return found;
}

std::optional<std::vector<SystemState>> first_states(const System& system, std::size_t limit) {
    const Valuations free = free_variables(system, true);
    if (free.count() > limit) return {};
    std::vector<SystemState> found;
    for (std::size_t valuation = 0; valuation < free.count(); ++valuation) {
        SystemState chosen = blank(system);
        free.put(valuation, chosen);
        const SystemState state =
            first_state(system, [&](std::string_view path, Type) { return slot(chosen, *site_of(system, path)); });
        if (is_allowed(system, state)) found.push_back(state);
    }
    make_unique(found);
    return found;
}

bool is_allowed(const System& system, const SystemState& state) {
    bool allowed = true;
    const Evaluator evaluator = in_state(system, state);
    each_module(system, [&](std::optional<std::size_t> instance, const System::Module& module) {
        for (const Id<Expr> term : module.invariants) allowed = allowed && evaluator.term(term, instance) != 0;
    });
    return allowed;
}

std::int64_t value_of(const System& system, const SystemState& state, Id<Expr> term) {
    return in_state(system, state).term(term, {});
}

std::int64_t value_of(const System& system, const SystemState& state, std::string_view path) {
    const auto site = site_of(system, path);
    if (!site) {
        ADD_FAILURE() << "unknown symbol " << path;
        return 0;
    }
    return in_state(system, state).at(*site);
}

void set_value(const System& system, SystemState& state, std::string_view path, std::int64_t value) {
    const auto site = site_of(system, path);
    ASSERT_TRUE(site) << "unknown symbol " << path;
    slot(state, *site) = value;
}

bool has_symbol(const System& system, std::string_view path) { return site_of(system, path).has_value(); }

}  // namespace grafverif
