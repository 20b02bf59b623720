// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>
#include <utility>

#include "ir/junction.hpp"
#include "ir/network_subsystems.hpp"
#include "ir/network_terms.hpp"
#include "ir/slots.hpp"

namespace grafverif {

namespace {

/// Union-find structure over processes.
class Classes {
public:
    explicit Classes(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }

    std::uint32_t of(std::uint32_t one) {
        while (parent_[one] != one) one = parent_[one] = parent_[parent_[one]];
        return one;
    }
    /// Merges two classes. The member with the least index represents the merged class.
    void join(std::uint32_t one, std::uint32_t other) {
        const auto [least, greatest] = std::minmax({of(one), of(other)});
        parent_[greatest] = least;
    }

private:
    std::vector<std::uint32_t> parent_;
};

bool does_nothing(const Network::Template& automaton) {
    return automaton.edges.empty() && std::ranges::all_of(automaton.locations, [](const Network::Location& location) {
               return location.invariant.empty();
           });
}

std::vector<std::vector<Id<Expr>>> settled_by_parts(const Network& network, const NetworkSubsystems& parts) {
    if (!network.settled.valid()) return {};
    std::vector<std::vector<Id<Expr>>> settled(parts.count);
    for (const Id<Expr> conjunct : operands_of(network.exprs, network.settled, Op::And)) {
        const std::vector<std::uint32_t> read = parts_read(network, parts, {conjunct});
        if (read.size() > 1) return {};
        for (std::uint32_t part = 0; part < parts.count; ++part)
            if (read.empty() || read.front() == part) settled[part].push_back(conjunct);
    }
    return settled;
}

}  // namespace

NetworkSubsystems parts_of(const Network& network) {
    constexpr std::uint32_t none = NetworkSubsystems::none;
    std::vector<bool> ties(network.variables.size(), false);
    for (const Id<Network::Process> id : network.processes.ids())
        for (const Id<Network::Variable> variable : Slots(network, id).written())
            ties[variable.index] = !network.variables[variable].scratch && variable != network.race;

    Classes classes(network.processes.size());
    std::vector<std::uint32_t> user(network.variables.size(), none);
    for (const Id<Network::Process> id : network.processes.ids()) {
        const Slots slots(network, id);
        if (does_nothing(slots.automaton)) classes.join(0, id.index);
        for (const Id<Network::Variable> variable : slots.used()) {
            if (!ties[variable.index]) continue;
            if (user[variable.index] == none) user[variable.index] = id.index;
            else classes.join(user[variable.index], id.index);
        }
    }

    NetworkSubsystems parts;
    std::vector<std::uint32_t> number(network.processes.size(), none);
    for (std::uint32_t process = 0; process < network.processes.size(); ++process) {
        std::uint32_t& part = number[classes.of(process)];
        if (part == none) part = parts.count++;
        parts.of_process.push_back(part);
    }
    for (const std::uint32_t process : user)
        parts.of_variable.push_back(process == none ? none : parts.of_process[process]);
    parts.settled = settled_by_parts(network, parts);
    return parts;
}

std::vector<std::uint32_t> parts_read(const Network& network, const NetworkSubsystems& parts,
                                      const std::vector<Id<Expr>>& terms) {
    std::vector<std::uint32_t> read;
    for (const Id<Expr> term : terms)
        for (const Id<Expr> leaf : leaves(network.exprs, term)) {
            const Expr& node = network.exprs[leaf];
            std::uint32_t part = NetworkSubsystems::none;
            if (node.op == Op::At) part = parts.of_process[at_process(node)];
            if (node.op == Op::Variable) part = parts.of_variable[static_cast<std::size_t>(node.value)];
            if (part != NetworkSubsystems::none) read.push_back(part);
        }
    std::ranges::sort(read);
    read.erase(std::unique(read.begin(), read.end()), read.end());
    return read;
}

std::string name_of_part(const Network& network, const NetworkSubsystems& parts, std::uint32_t part) {
    std::string name;
    for (const Network::Controller& controller : network.controllers)
        if (parts.of_process[controller.process.index] == part)
            name += (name.empty() ? "" : " and ") + controller.words.name;
    if (!name.empty()) return name;
    const auto first = std::ranges::find(parts.of_process, part) - parts.of_process.begin();
    return network.processes[{static_cast<std::uint32_t>(first)}].name;
}

SubNetworkBuilder::SubNetworkBuilder(const Network& network, const NetworkSubsystems& parts,
                                     const std::vector<std::uint32_t>& chosen)
    : whole_(network),
      process_(network.processes.size(), NetworkSubsystems::none),
      variable_(network.variables.size(), NetworkSubsystems::none),
      copy_(network.exprs, made_.network.exprs, [this](const Expr& node) { return leaf(node); }) {
    made_.network.name = network.name;
    made_.network.grain = network.grain;
    made_.network.time_unit_ms = network.time_unit_ms;
    for (const Id<Network::Process> id : network.processes.ids())
        if (std::ranges::binary_search(chosen, parts.of_process[id.index])) {
            process_[id.index] = static_cast<std::uint32_t>(made_.processes.size());
            made_.processes.push_back(id);
        }
    for (const Id<Network::Process> id : made_.processes) add_process(id);
    for (const Network::Controller& controller : network.controllers)
        if (process_[controller.process.index] != NetworkSubsystems::none) add_controller(controller);
    if (network.race.valid() && variable_[network.race.index] != NetworkSubsystems::none)
        made_.network.race = {variable_[network.race.index]};
    if (parts.settled.empty()) return;
    std::vector<Id<Expr>> settled;
    for (const std::uint32_t part : chosen)
        for (const Id<Expr> conjunct : parts.settled[part]) settled.push_back(copy_(conjunct));
    made_.network.settled = made_.network.exprs.conjunction(settled);
}

Id<Expr> SubNetworkBuilder::leaf(const Expr& node) {
    if (node.op == Op::At) return made_.network.exprs.at(process_[at_process(node)], at_location(node));
    const Id<Network::Variable> variable = here({static_cast<std::uint32_t>(node.value)});
    return made_.network.exprs.leaf(Op::Variable, variable.index);
}

Id<Network::Variable> SubNetworkBuilder::here(Id<Network::Variable> variable) {
    std::uint32_t& here = variable_[variable.index];
    if (here == NetworkSubsystems::none) {
        here = made_.network.variables.add(whole_.variables[variable]).index;
        made_.variables.push_back(variable);
    }
    return {here};
}

void SubNetworkBuilder::add_process(Id<Network::Process> id) {
    Network::Process process = whole_.processes[id];
    Network::Template automaton = whole_.templates[process.automaton];
    replace_terms(automaton, copy_);
    process.automaton = made_.network.templates.add(std::move(automaton));
    made_.network.processes.add(std::move(process));
}

void SubNetworkBuilder::add_controller(const Network::Controller& controller) {
    Network::Controller made{.process = {process_[controller.process.index]},
                             .waiting = controller.waiting,
                             .stable = here(controller.stable)};
    made.words.name = controller.words.name;
    for (const Network::Timer& timer : controller.timers)
        made.timers.push_back({.process = {process_[timer.process.index]}});
    made_.network.controllers.add(std::move(made));
}

void SubNetworkBuilder::add_property(Property property) {
    for (Id<Expr>& operand : property.operands) operand = copy_(operand);
    made_.network.properties.add(std::move(property));
}

Run in_complete(const SubNetwork& part, Run run) {
    for (Move& move : run.moves)
        if (Fire* const fire = std::get_if<Fire>(&move)) fire->process = part.processes[fire->process.index];
    return run;
}

}  // namespace grafverif
