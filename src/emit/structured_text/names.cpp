// SPDX-License-Identifier: MIT
#include "emit/structured_text/names.hpp"

#include <unordered_set>
#include <utility>

namespace grafverif::structured_text {

namespace {

using Role = Equations::Role;

/// The names inside a block. All preferred names are collected before the first name is assigned, so that the total
/// cost is linear in the number of names.
class Inner {
public:
    /// Requests a name. `place` receives the name after all names are collected; its address must remain valid until
    /// then.
    void wish(std::string name, std::string& place) {
        wishes_.push_back(std::move(name));
        places_.push_back(&place);
    }

    void grant(const InterfaceNames& interface) {
        std::unordered_set<std::string> taken(interface.variables.begin(), interface.variables.end());
        taken.insert(interface.block);
        std::vector<std::string> made = legal_names(Target::StructuredText, wishes_, taken);
        for (std::size_t k = 0; k < made.size(); ++k) *places_[k] = std::move(made[k]);
    }

private:
    std::vector<std::string> wishes_ = {};
    std::vector<std::string*> places_ = {};
};

void wish_timers(const Equations& equations, Inner& inner, Names& names) {
    names.timers.resize(equations.timers.size());
    for (std::size_t k = 0; k < names.timers.size(); ++k) {
        const Equations::Timer& timer = equations.timers[k];
        if (timer.rise_ms != 0) inner.wish(timer.name, names.timers[k].on);
        if (timer.rise_ms != 0 && timer.fall_ms != 0) inner.wish(timer.name + "_L", names.timers[k].lasted);
        if (timer.fall_ms != 0) inner.wish(timer.name + "_OFF", names.timers[k].off);
    }
}

}  // namespace

InterfaceNames interface_names(const std::string& chart, std::span<const std::string> inputs,
                               std::span<const std::string> outputs) {
    std::vector<std::string> wishes(inputs.begin(), inputs.end());
    wishes.insert(wishes.end(), outputs.begin(), outputs.end());
    wishes.push_back(chart);
    InterfaceNames names{{}, legal_names(Target::StructuredText, wishes)};
    names.block = std::move(names.variables.back());
    names.variables.pop_back();
    return names;
}

Names names_of(const Equations& equations) {
    std::vector<std::string> inputs, outputs, all;
    for (const Equations::Variable& variable : equations.variables) {
        all.push_back(variable.name);
        if (variable.role == Role::Input) inputs.push_back(variable.name);
        if (variable.role == Role::Output) outputs.push_back(variable.name);
    }
    const InterfaceNames interface = interface_names(equations.name, inputs, outputs);
    Names names;
    names.block = interface.block;
    names.variables.resize(all.size());
    names.storage.resize(all.size());
    names.fresh.resize(all.size());
    Inner inner;
    std::size_t input = 0, output = inputs.size();
    for (const Id<Equations::Variable> id : equations.variables.ids()) {
        const Role role = equations.variables[id].role;
        if (role == Role::Input) names.variables[id.index] = interface.variables[input++];
        else if (role == Role::Output) names.variables[id.index] = interface.variables[output++];
        else inner.wish(all[id.index], names.variables[id.index]);
        inner.wish("N_" + all[id.index], names.fresh[id.index]);
    }
    for (const Equations::Stored& stored : equations.stored)
        if (equations.variables[stored.variable].role == Role::Output)
            inner.wish("M_" + all[stored.variable.index], names.storage[stored.variable.index]);
    wish_timers(equations, inner, names);
    inner.wish("started", names.started);
    inner.wish("stable", names.stable);
    inner.wish("evolutions", names.evolutions);
    inner.wish("MAX_EVOLUTIONS", names.limit);
    inner.wish("FAULT", names.fault);
    inner.grant(interface);
    for (std::size_t k = 0; k < all.size(); ++k)
        if (names.storage[k].empty()) names.storage[k] = names.variables[k];
    names.changed = renamings(all, names.variables);
    return names;
}

}  // namespace grafverif::structured_text
