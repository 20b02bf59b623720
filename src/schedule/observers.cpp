// SPDX-License-Identifier: MIT
// Declares all observers first, as instances of modules with only a location, because guards may read the locations of
// all observers. Then replaces each module by the complete module with parameters and edges.
#include "schedule/observers.hpp"

#include <unordered_map>

namespace grafverif::schedule {

namespace {

using System = TransitionSystem;

/// Returns the names of the locations as identifiers of NuSMV: `101` becomes `state_101`.
std::vector<std::string> value_names(const ClosedLoop::Observer& observer) {
    std::vector<std::string> names;
    for (const auto& [name, origin] : observer.locations) {
        const bool number = !name.empty() && name.front() >= '0' && name.front() <= '9';
        names.push_back(number ? "state_" + name : name);
    }
    return names;
}

struct Guarded {
    Id<ClosedLoop::ObserverLocation> from = {}, to = {};
    Id<Expr> guard = {};  ///< guard as a term over symbols of main
};

/// For a symbol `instance.symbol` of main, returns its name in the module of the instance (`symbol`). For any other
/// symbol, returns its name in main.
const std::string& own_name(const System& system, const Symbol& symbol) {
    const auto* const member = std::get_if<System::MemberSymbol>(&symbol.kind);
    if (member == nullptr) return symbol.name;
    return system.modules[system.instances[member->instance].module].symbols[member->symbol].name;
}

/// Adds a parameter to the observer's module for each symbol of main that guards read, and the argument to the
/// instance.
std::unordered_map<std::uint32_t, Id<Symbol>> add_parameters(Main& main, Id<System::Instance> instance, Draft& draft,
                                                             const std::vector<Guarded>& edges) {
    std::unordered_map<std::uint32_t, Id<Symbol>> parameters;
    for (const Guarded& edge : edges)
        for (const Id<Expr> leaf : leaves(draft.exprs, edge.guard)) {
            const auto outer = static_cast<std::uint32_t>(draft.exprs[leaf].value);
            const auto [known, fresh] = parameters.try_emplace(outer);
            if (!fresh) continue;
            const Symbol& read = main.draft.module.symbols[{outer}];
            known->second = draft.add(own_name(main.system, read), read.type, System::ParameterSymbol{});
            draft.module.symbols[known->second].values = read.values;
            main.system.instances[instance].arguments.push_back({outer});
        }
    return parameters;
}

/// Adds an observer as an instance of a module without edges. Returns the location of the observer, which is the first
/// symbol of the module, as a symbol of main.
Id<Symbol> declare(Main& main, const ClosedLoop::Observer& observer) {
    System::Module module{.name = "observer_" + observer.name};
    const auto last = static_cast<std::int64_t>(observer.locations.size()) - 1;
    const Id<Expr> initial = main.system.exprs.integer(observer.initial.index);
    const Id<Symbol> location =
        module.symbols.add({"location", integer_type(0, last), System::StateSymbol{initial, initial}, "",
                            observer.origin, value_names(observer)});
    const Id<System::Instance> instance = main.add_instance(observer.name, main.add_module(std::move(module)));
    main.system.observers.push_back(instance);
    return main.member(instance, location);
}

/// Adds the edges of an observer. `location` is the result of `declare`.
void watch(Main& main, Id<Symbol> location, const std::vector<Guarded>& edges) {
    auto& known = std::get<System::MemberSymbol>(main.draft.module.symbols[location].kind);
    System::Module& module = main.system.modules[main.system.instances[known.instance].module];
    Draft draft{main.system.exprs, {.name = module.name}};
    draft.names.take("location");
    const auto parameters = add_parameters(main, known.instance, draft, edges);
    const Id<Symbol> here = draft.module.symbols.add(module.symbols[known.symbol]);
    Id<Expr> next = draft.leaf(here);
    for (auto edge = edges.rbegin(); edge != edges.rend(); ++edge) {
        const Id<Expr> guard = translate(draft.exprs, edge->guard, draft.exprs, [&](const Expr& leaf) {
            return draft.leaf(parameters.at(static_cast<std::uint32_t>(leaf.value)));
        });
        next = draft.exprs.conditional(draft.exprs.conjunction(draft.is(here, edge->from.index), guard),
                                       draft.exprs.integer(edge->to.index), next);
    }
    std::get<System::StateSymbol>(draft.module.symbols[here].kind).next = next;
    module = std::move(draft.module);
    known.symbol = here;
}

/// Determines the observers that depend, directly or through other observers, on names that do not exist in the model.
/// Properties cannot read these observers.
void find_unobserved(LoopMeaning& meaning) {
    const ClosedLoop& loop = meaning.loop;
    for (bool grew = true; grew;) {
        grew = false;
        for (const Id<ClosedLoop::Observer> id : loop.observers.ids())
            for (const ClosedLoop::ObserverEdge& edge : loop.observers[id].edges) {
                std::string reason;
                if (!meaning.unobserved[id.index].empty() || term_of(meaning, edge.guard, reason).valid()) continue;
                meaning.unobserved[id.index] = "observer `" + loop.observers[id].name + "`: " + reason;
                grew = true;
            }
    }
}

}  // namespace

void add_observers(LoopMeaning& meaning, Id<Expr> when) {
    const Table<ClosedLoop::Observer>& observers = meaning.loop.observers;
    for (const ClosedLoop::Observer& observer : observers) meaning.observers.push_back(declare(meaning.main, observer));
    meaning.unobserved.resize(observers.size());
    find_unobserved(meaning);
    for (const Id<ClosedLoop::Observer> id : observers.ids()) {
        std::vector<Guarded> edges;
        for (const ClosedLoop::ObserverEdge& edge : observers[id].edges) {
            std::string reason;
            Id<Expr> guard = term_of(meaning, edge.guard, reason);
            if (guard.valid() && when.valid()) guard = meaning.main.system.exprs.conjunction(when, guard);
            if (guard.valid()) edges.push_back({edge.from, edge.to, guard});
        }
        watch(meaning.main, meaning.observers[id.index], edges);
    }
}

}  // namespace grafverif::schedule
