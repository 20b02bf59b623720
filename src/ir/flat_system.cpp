// SPDX-License-Identifier: MIT
#include "ir/flat_system.hpp"

#include <cassert>

#include "support/overloaded.hpp"

namespace grafverif {

namespace {

using System = TransitionSystem;

/// Site: a symbol, and the instance that contains it. The instance is invalid for a symbol of main.
struct Site {
    Id<System::Instance> instance = {};
    Id<System::Symbol> symbol = {};
};

class Flattening {
public:
    explicit Flattening(const System& system) : system_(system) {
        std::size_t size = main().symbols.size();
        for (const System::Instance& instance : system.instances) {
            offsets_.push_back(size);
            size += system.modules[instance.module].symbols.size();
        }
        known_.resize(size);
    }

    FlatSystem result() {
        each_site([&](Site site) { add_variable(site); });
        each_site([&](Site site) { resolve(site); });
        each_site([&](Site site) { set_values(site); });
        for (const Id<System::Symbol> id : main().symbols.ids()) flat_.symbols.push_back(known_[index(Site{{}, id})]);
        add_constraints({});
        for (const Id<System::Instance> id : system_.instances.ids()) add_constraints(id);
        return std::move(flat_);
    }

private:
    const System::Module& main() const { return system_.modules[system_.main]; }
    const System::Module& module(Id<System::Instance> instance) const {
        return instance.valid() ? system_.modules[system_.instances[instance].module] : main();
    }
    const System::Symbol& symbol(Site site) const { return module(site.instance).symbols[site.symbol]; }
    std::size_t index(Site site) const {
        return (site.instance.valid() ? offsets_[site.instance.index] : 0) + site.symbol.index;
    }

    template <class Visit>
    void each_site(const Visit& visit) const {
        for (const Id<System::Symbol> id : main().symbols.ids()) visit(Site{{}, id});
        for (const Id<System::Instance> instance : system_.instances.ids())
            for (const Id<System::Symbol> id : module(instance).symbols.ids()) visit(Site{instance, id});
    }

    void add_variable(Site site) {
        const System::Symbol& here = symbol(site);
        const bool choice = std::holds_alternative<System::ChoiceSymbol>(here.kind);
        if (!choice && !std::holds_alternative<System::StateSymbol>(here.kind)) return;
        const std::string path = site.instance.valid() ? system_.instances[site.instance].name + "." : "";
        const auto id = flat_.variables.add({path + here.name, here.type, choice, {}, {}, here.origin});
        known_[index(site)] = flat_.exprs.leaf(Op::Variable, id.index);
    }

    /// Returns the sites (symbols of main or of instances) that the definition of `site` reads.
    std::vector<Site> sources(Site site) const {
        return std::visit(
            overloaded{
                [](const System::StateSymbol&) { return std::vector<Site>{}; },
                [](const System::ChoiceSymbol&) { return std::vector<Site>{}; },
                [&](const System::ParameterSymbol&) {
                    return std::vector<Site>{{{}, system_.instances[site.instance].arguments[site.symbol.index]}};
                },
                [&](const System::MemberSymbol& member) {
                    return std::vector<Site>{{member.instance, member.symbol}};
                },
                [&](const System::DefineSymbol& define) {
                    std::vector<Site> read;
                    for (const Id<Expr> leaf : leaves(system_.exprs, define.value))
                        read.push_back({site.instance, {static_cast<std::uint32_t>(system_.exprs[leaf].value)}});
                    return read;
                }},
            symbol(site).kind);
    }

    /// Computes the value of `wanted` after the values of all sites (symbols) that its definition reads. The
    /// traversal is iterative, because chains of definitions can be arbitrarily long.
    void resolve(Site wanted) {
        std::vector<Site> open{wanted};
        while (!open.empty()) {
            const Site site = open.back();
            const std::size_t before = open.size();
            if (!known_[index(site)].valid())
                for (const Site source : sources(site))
                    if (!known_[index(source)].valid()) open.push_back(source);
            assert(open.size() <= known_.size() * known_.size() + 1);  // bounded: definitions are acyclic
            if (open.size() != before) continue;
            open.pop_back();
            if (known_[index(site)].valid()) continue;
            const auto* define = std::get_if<System::DefineSymbol>(&symbol(site).kind);
            known_[index(site)] =
                define != nullptr ? in_place(site.instance, define->value) : known_[index(sources(site).front())];
        }
    }

    /// Translates a term of the module of `instance` to the variables of the flat system.
    Id<Expr> in_place(Id<System::Instance> instance, Id<Expr> term) {
        return translate(system_.exprs, term, flat_.exprs, [&](const Expr& node) {
            return known_[index(Site{instance, {static_cast<std::uint32_t>(node.value)}})];
        });
    }

    void set_values(Site site) {
        const auto* state = std::get_if<System::StateSymbol>(&symbol(site).kind);
        if (state == nullptr) return;
        const Expr& leaf = flat_.exprs[known_[index(site)]];
        const Id<FlatSystem::Variable> id{static_cast<std::uint32_t>(leaf.value)};
        if (state->initial) flat_.variables[id].initial = in_place(site.instance, *state->initial);
        if (state->next) flat_.variables[id].next = in_place(site.instance, *state->next);
    }

    void add_constraints(Id<System::Instance> instance) {
        const System::Module& here = module(instance);
        for (const Id<Expr> term : here.invariants) flat_.invariants.push_back(in_place(instance, term));
        for (const Id<Expr> term : here.transitions) flat_.transitions.push_back(in_place(instance, term));
        for (const Id<Expr> term : here.justice) flat_.justice.push_back(in_place(instance, term));
    }

    const System& system_;
    FlatSystem flat_ = {};
    std::vector<std::size_t> offsets_ = {};  ///< index of the first symbol of each instance in `known_`
    std::vector<Id<Expr>> known_ = {};       ///< value of each site as a term over the variables of the flat system
};

}  // namespace

FlatSystem flattened(const System& system) { return Flattening(system).result(); }

Id<Expr> flattened(const System& system, FlatSystem& flat, Id<Expr> term) {
    return translate(system.exprs, term, flat.exprs,
                     [&](const Expr& node) { return flat.symbols[static_cast<std::size_t>(node.value)]; });
}

std::string_view word(SystemFault::Kind kind) {
    switch (kind) {
    case SystemFault::Kind::NoInitialState: return "no-initial-state";
    case SystemFault::Kind::DeadEnd: return "dead-end";
    case SystemFault::Kind::OutOfRange: return "out-of-range";
    }
    unreachable();
}

std::vector<std::int64_t> symbol_values(const FlatSystem& flat, std::span<const std::int64_t> variables) {
    const std::vector<std::optional<std::int64_t>> values =
        evaluate_all(flat.exprs, [&](const Expr& node) { return variables[static_cast<std::size_t>(node.value)]; });
    std::vector<std::int64_t> result;
    for (const Id<Expr> term : flat.symbols) result.push_back(values[term.index].value_or(0));
    return result;
}

SystemRun system_run(const FlatSystem& flat, const FlatRun& run) {
    SystemRun made{{}, run.loop};
    for (const std::vector<std::int64_t>& state : run.states) made.states.push_back(symbol_values(flat, state));
    return made;
}

std::int64_t value_in(const System& system, const std::vector<std::int64_t>& state, Id<Expr> term) {
    return evaluate(system.exprs, term, [&](const Expr& node) { return state[static_cast<std::size_t>(node.value)]; })
        .value_or(0);
}

}  // namespace grafverif
