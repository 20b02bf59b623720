// SPDX-License-Identifier: MIT
#include "emit/controller/names.hpp"

#include <unordered_set>
#include <utility>

namespace grafverif::controller {

namespace {

using Role = Equations::Role;

/// Assigns the names inside a block. All preferred names are collected before the first name is assigned, so that the
/// total cost is linear in the number of names.
class Inner {
public:
    /// Requests a name. `place` receives the name after all names are collected; its address must remain valid until
    /// then.
    void request(std::string name, std::string& place) {
        requested_.push_back(std::move(name));
        places_.push_back(&place);
    }

    void grant(const InterfaceNames& interface, Target target, std::span<const std::string_view> reserved) {
        std::unordered_set<std::string> taken(interface.variables.begin(), interface.variables.end());
        taken.insert(interface.block);
        for (const std::string_view word : reserved) taken.emplace(word);
        std::vector<std::string> made = legal_names(target, requested_, taken);
        for (std::size_t k = 0; k < made.size(); ++k) *places_[k] = std::move(made[k]);
    }

private:
    std::vector<std::string> requested_ = {};
    std::vector<std::string*> places_ = {};
};

void request_timers(const Equations& equations, Inner& inner, Names& names) {
    names.timers.resize(equations.timers.size());
    for (std::size_t k = 0; k < names.timers.size(); ++k) {
        const Equations::Timer& timer = equations.timers[k];
        if (timer.rise_ms != 0) inner.request(timer.name, names.timers[k].on);
        if (timer.rise_ms != 0 && timer.fall_ms != 0) inner.request(timer.name + "_L", names.timers[k].lasted);
        if (timer.fall_ms != 0) inner.request(timer.name + "_OFF", names.timers[k].off);
    }
}

}  // namespace

InterfaceNames interface_names(const std::string& chart, std::span<const std::string> inputs,
                               std::span<const std::string> outputs, Target target,
                               std::span<const std::string_view> reserved) {
    std::vector<std::string> preferred_names(inputs.begin(), inputs.end());
    preferred_names.insert(preferred_names.end(), outputs.begin(), outputs.end());
    preferred_names.push_back(chart);
    std::unordered_set<std::string> taken;
    for (const std::string_view word : reserved) taken.emplace(word);
    InterfaceNames names{{}, legal_names(target, preferred_names, taken)};
    names.block = std::move(names.variables.back());
    names.variables.pop_back();
    return names;
}

Names names_of(const Equations& equations, Target target, std::span<const std::string_view> reserved) {
    std::vector<std::string> inputs, outputs, all;
    for (const Equations::Variable& variable : equations.variables) {
        all.push_back(variable.name);
        if (variable.role == Role::Input) inputs.push_back(variable.name);
        if (variable.role == Role::Output) outputs.push_back(variable.name);
    }
    const InterfaceNames interface = interface_names(equations.name, inputs, outputs, target, reserved);
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
        else inner.request(all[id.index], names.variables[id.index]);
        inner.request("N_" + all[id.index], names.fresh[id.index]);
    }
    for (const Equations::Stored& stored : equations.stored)
        if (equations.variables[stored.variable].role == Role::Output)
            inner.request("M_" + all[stored.variable.index], names.storage[stored.variable.index]);
    request_timers(equations, inner, names);
    inner.request("started", names.started);
    inner.request("stable", names.stable);
    inner.request("evolutions", names.evolutions);
    inner.request("MAX_EVOLUTIONS", names.limit);
    inner.request("FAULT", names.fault);
    inner.grant(interface, target, reserved);
    for (std::size_t k = 0; k < all.size(); ++k)
        if (names.storage[k].empty()) names.storage[k] = names.variables[k];
    names.changed = renamings(all, names.variables);
    return names;
}

}  // namespace grafverif::controller
