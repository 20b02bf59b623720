// SPDX-License-Identifier: MIT
// Guards may read where observers are, of others and their own. So all are declared before any is given its edges: an
// instance of a module that has its location alone. The module is then made anew, with its parameters.
#include "schedule/observers.hpp"

#include <unordered_map>

namespace grafverif::schedule {

namespace {

using System = TransitionSystem;

/// `location 101` is no word of NuSMV's; the state of that name is.
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
    Id<Expr> guard = {};               ///< over symbols of main
};

class Declared {
public:
    Declared(Members& members, const ClosedLoop::Observer& observer, UniqueNames& names, UniqueNames& modules)
        : system_(members.system) {
        System::Module module;
        module.name = modules.fresh("observer_" + observer.name);
        const auto last = static_cast<std::int64_t>(observer.locations.size()) - 1;
        const Id<Expr> initial = system_.exprs.integer(observer.initial.index);
        const Id<Symbol> kept =
            module.symbols.add({"location", integer_type(0, last), System::StateSymbol{initial, initial}, "",
                                observer.origin, value_names(observer)});
        module_ = system_.modules.add(std::move(module));
        instance_ = system_.instances.add({names.fresh(observer.name), module_, {}});
        system_.observers.push_back(instance_);
        location_ = member(members, instance_, kept);
    }

    /// In main.
    Id<Symbol> location() const { return location_; }

    void watch(const std::vector<Guarded>& edges) {
        Exprs& exprs = system_.exprs;
        Table<Symbol> symbols;
        const std::unordered_map<std::uint32_t, Id<Symbol>> parameters = add_parameters(symbols, edges);
        const Id<Symbol> here = symbols.add(system_.modules[module_].symbols[{0}]);
        const Id<Expr> now = exprs.leaf(Op::Variable, here.index);
        Id<Expr> next = now;
        for (std::size_t k = edges.size(); k-- > 0;) {
            const Id<Expr> guard = translate(exprs, edges[k].guard, exprs, [&](const Expr& leaf) {
                return exprs.leaf(Op::Variable, parameters.at(static_cast<std::uint32_t>(leaf.value)).index);
            });
            const Id<Expr> from = exprs.apply(Op::Equal, now, exprs.integer(edges[k].from.index));
            next = exprs.conditional(exprs.conjunction(from, guard), exprs.integer(edges[k].to.index), next);
        }
        std::get<System::StateSymbol>(symbols[here].kind).next = next;
        system_.modules[module_].symbols = std::move(symbols);
        std::get<System::MemberSymbol>(system_.modules[system_.main].symbols[location_].kind).symbol = here;
    }

private:
    /// Per symbol of main that a guard reads; the instance gets its arguments.
    std::unordered_map<std::uint32_t, Id<Symbol>> add_parameters(Table<Symbol>& symbols, const std::vector<Guarded>& edges) {
        std::unordered_map<std::uint32_t, Id<Symbol>> parameters;
        UniqueNames names;
        names.fresh("location");
        for (const Guarded& edge : edges)
            for (const Id<Expr> leaf : leaves(system_.exprs, edge.guard)) {
                const auto outer = static_cast<std::uint32_t>(system_.exprs[leaf].value);
                const auto [known, fresh] = parameters.try_emplace(outer);
                if (!fresh) continue;
                const Symbol& read = system_.modules[system_.main].symbols[{outer}];
                const std::string own = read.name.substr(read.name.rfind('.') + 1);
                known->second = symbols.add({names.fresh(own), read.type, System::ParameterSymbol{}, "", {}, read.values});
                system_.instances[instance_].arguments.push_back({outer});
            }
        return parameters;
    }

    System& system_;
    Id<System::Module> module_ = {};
    Id<System::Instance> instance_ = {};
    Id<Symbol> location_ = {};
};

/// Finds the observers that read what the model does not have, or an observer of that kind: properties cannot read them.
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

void add_observers(Members& members, LoopMeaning& meaning, UniqueNames& names, UniqueNames& modules, Id<Expr> when) {
    std::vector<Declared> declared;
    for (const ClosedLoop::Observer& observer : meaning.loop.observers) {
        declared.emplace_back(members, observer, names, modules);
        meaning.observers.push_back(declared.back().location());
    }
    meaning.unobserved.resize(declared.size());
    find_unobserved(meaning);
    for (const Id<ClosedLoop::Observer> id : meaning.loop.observers.ids()) {
        std::vector<Guarded> edges;
        for (const ClosedLoop::ObserverEdge& edge : meaning.loop.observers[id].edges) {
            std::string reason;
            Id<Expr> guard = term_of(meaning, edge.guard, reason);
            if (guard.valid() && when.valid()) guard = members.system.exprs.conjunction(when, guard);
            if (guard.valid()) edges.push_back({edge.from, edge.to, guard});
        }
        declared[id.index].watch(edges);
    }
}

}  // namespace grafverif::schedule
