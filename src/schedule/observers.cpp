// SPDX-License-Identifier: MIT
#include "schedule/observers.hpp"

#include <memory>
#include <unordered_map>

namespace grafverif::schedule {

namespace {

using System = TransitionSystem;

/// `location 101` is no word of NuSMV's; the state of that name is.
std::vector<std::string> value_names(const ObserverShape& shape) {
    std::vector<std::string> names;
    for (const std::string& location : shape.locations) {
        const bool number = !location.empty() && location.front() >= '0' && location.front() <= '9';
        names.push_back(number ? "state_" + location : location);
    }
    return names;
}

/// Observers that read what the model does not have, or an observer of that kind: properties cannot read them.
void find_broken(System& system, const ClosedLoop& loop, const LoopMeaning& meaning, std::vector<std::string>& broken) {
    for (bool grew = true; grew;) {
        grew = false;
        for (const Id<ClosedLoop::Observer> id : loop.observers.ids())
            for (const ClosedLoop::ObserverEdge& edge : loop.observers[id].edges) {
                std::string reason;
                if (!broken[id.index].empty() || term_of(system, loop, meaning, edge.guard, reason).valid()) continue;
                broken[id.index] = "observer `" + loop.observers[id].name + "`: " + reason;
                grew = true;
            }
    }
}

}  // namespace

ObserverInstance declare_observer(Members& members, const ObserverShape& shape, UniqueNames& names,
                                  UniqueNames& modules) {
    System& system = members.system;
    System::Module module;
    module.name = modules.fresh("observer_" + shape.name);
    const auto last = static_cast<std::int64_t>(shape.locations.size()) - 1;
    const Id<Expr> initial = system.exprs.integer(shape.initial);
    const Id<Symbol> location = module.symbols.add(
        {"location", integer_type(0, last), System::StateSymbol{initial, initial}, "", shape.origin, value_names(shape)});
    const Id<System::Module> id = system.modules.add(std::move(module));
    const Id<System::Instance> instance = system.instances.add({names.fresh(shape.name), id, {}});
    system.observers.push_back(instance);
    return {instance, member(members, instance, location)};
}

void watch(Members& members, const ObserverInstance& observer, std::span<const ObserverGuard> edges) {
    System& system = members.system;
    const Id<System::Module> id = system.instances[observer.instance].module;
    const Id<Symbol> kept{0};   // its location, the only symbol so far
    Table<Symbol> symbols;
    UniqueNames names;
    names.fresh("location");
    std::unordered_map<std::uint32_t, Id<Symbol>> parameters;   // per symbol of main
    for (const ObserverGuard& edge : edges)
        for (const Id<Expr> leaf : leaves(system.exprs, edge.guard)) {
            const auto outer = static_cast<std::uint32_t>(system.exprs[leaf].value);
            const auto [known, fresh] = parameters.try_emplace(outer);
            if (!fresh) continue;
            const Symbol& read = system.modules[system.main].symbols[{outer}];
            const std::string own = read.name.substr(read.name.rfind('.') + 1);
            known->second = symbols.add({names.fresh(own), read.type, System::ParameterSymbol{}, "", {}, read.values});
            system.instances[observer.instance].arguments.push_back({outer});
        }
    Symbol location = system.modules[id].symbols[kept];
    const Id<Symbol> here = symbols.add(location);
    Exprs& exprs = system.exprs;
    const Id<Expr> now = exprs.leaf(Op::Variable, here.index);
    Id<Expr> next = now;
    for (std::size_t k = edges.size(); k-- > 0;) {
        const Id<Expr> guard = translate(exprs, edges[k].guard, exprs, [&](const Expr& leaf) {
            return exprs.leaf(Op::Variable, parameters.at(static_cast<std::uint32_t>(leaf.value)).index);
        });
        const Id<Expr> taken = exprs.conjunction(exprs.apply(Op::Equal, now, exprs.integer(edges[k].from)), guard);
        next = exprs.conditional(taken, exprs.integer(edges[k].to), next);
    }
    std::get<System::StateSymbol>(symbols[here].kind).next = next;
    system.modules[id].symbols = std::move(symbols);
    std::get<System::MemberSymbol>(system.modules[system.main].symbols[observer.location].kind).symbol = here;
}

Id<Expr> is_at(System& system, const ObserverInstance& observer, std::uint32_t location) {
    return system.exprs.apply(Op::Equal, system.exprs.leaf(Op::Variable, observer.location.index),
                              system.exprs.integer(location));
}

void add_observers(Members& members, const ClosedLoop& loop, LoopMeaning& meaning, UniqueNames& names,
                   UniqueNames& modules, Id<Expr> when) {
    std::vector<ObserverInstance> declared;
    for (const ClosedLoop::Observer& observer : loop.observers) {
        ObserverShape shape{observer.name, {}, observer.initial.index, observer.origin};
        for (const ClosedLoop::ObserverLocation& location : observer.locations)
            shape.locations.push_back(location.name);
        declared.push_back(declare_observer(members, shape, names, modules));
    }
    System& system = members.system;
    const auto broken = std::make_shared<std::vector<std::string>>(declared.size());
    meaning.term = [before = meaning.term, declared, broken, &system](const ClosedLoop::Symbol& symbol,
                                                                      std::string& reason) {
        const auto* observed = std::get_if<ClosedLoop::ObserverSymbol>(&symbol);
        if (observed == nullptr) return before(symbol, reason);
        reason = (*broken)[observed->observer.index];
        return reason.empty() ? is_at(system, declared[observed->observer.index], observed->location.index) : Id<Expr>{};
    };
    find_broken(system, loop, meaning, *broken);
    for (const Id<ClosedLoop::Observer> id : loop.observers.ids()) {
        std::vector<ObserverGuard> edges;
        for (const ClosedLoop::ObserverEdge& edge : loop.observers[id].edges) {
            std::string reason;
            Id<Expr> guard = term_of(system, loop, meaning, edge.guard, reason);
            if (guard.valid() && when.valid()) guard = system.exprs.conjunction(when, guard);
            if (guard.valid()) edges.push_back({edge.from.index, edge.to.index, guard});
        }
        watch(members, declared[id.index], edges);
    }
}

}  // namespace grafverif::schedule
