// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "ir/network_family.hpp"

namespace grafverif {

namespace {

/// Calls `visit` for each process of an expanded network and each list of its clock constraints, in the order of
/// ClockConstants.
template <class Of, class Visit>
void for_each_list(Of& network, const Visit& visit) {
    for (auto& process : network.processes) {
        auto& automaton = network.templates[process.automaton];
        for (auto& location : automaton.locations) visit(process, location.invariant);
        for (auto& edge : automaton.edges) visit(process, edge.constraint);
    }
}

bool has_lower(Op relation) { return relation != Op::Less && relation != Op::LessEqual; }
bool has_upper(Op relation) { return relation != Op::Greater && relation != Op::GreaterEqual; }

}  // namespace

FamilyMember member_of(const Network& network) {
    Network flat = expand(network);
    ClockConstants constants;
    const Id<Expr> none = flat.exprs.integer(0);
    for_each_list(flat, [&](const Network::Process& process, std::vector<Network::ClockConstraint>& list) {
        for (Network::ClockConstraint& constraint : list) {
            constants.push_back(bound_value(flat, process, constraint.bound));
            constraint.bound = none;
        }
    });
    flat.constants.clear();
    return {expand(flat), std::move(constants)};  // this expansion omits the terms of the removed constants
}

Network with_only(const Network& frame, const std::string& name) {
    Network one = frame;
    one.properties = {};
    for (const Property& property : frame.properties)
        if (property.name == name) one.properties.add(property);
    return expand(one);
}

std::uint64_t hash_of(const Network& frame) {
    std::uint64_t hash = 14695981039346656037U;
    const auto add = [&](std::int64_t value) { hash = (hash ^ static_cast<std::uint64_t>(value)) * 1099511628211U; };
    for (std::uint32_t index = 0; index < frame.exprs.size(); ++index) {
        const Expr& node = frame.exprs[Id<Expr>{index}];
        add(static_cast<std::int64_t>(node.op));
        add(node.value);
        for (const Id<Expr> operand : frame.exprs.operands(node)) add(operand.index);
    }
    for (const Network::Variable& variable : frame.variables) {
        add(variable.type.low);
        add(variable.type.high);
        add(variable.initial);
    }
    return hash;
}

Relaxation relaxation_of(const Network& frame, const std::vector<const ClockConstants*>& members) {
    Relaxation made{*members.front(), *members.front()};
    for (const ClockConstants* constants : members)
        for (std::size_t i = 0; i < constants->size(); ++i) {
            made.least[i] = std::min(made.least[i], (*constants)[i]);
            made.greatest[i] = std::max(made.greatest[i], (*constants)[i]);
        }
    std::size_t next = 0;
    for_each_list(frame, [&](const Network::Process&, const std::vector<Network::ClockConstraint>& list) {
        for (const Network::ClockConstraint& constraint : list) {
            if (!has_lower(constraint.relation)) made.least[next] = made.greatest[next];
            if (!has_upper(constraint.relation)) made.greatest[next] = made.least[next];
            ++next;
        }
    });
    return made;
}

Network network_of(const Network& frame, const ClockConstants& constants) {
    return network_of(frame, Relaxation{constants, constants});
}

Network network_of(const Network& frame, const Relaxation& relaxation) {
    Network network = frame;
    std::size_t next = 0;
    for_each_list(network, [&](const Network::Process&, std::vector<Network::ClockConstraint>& list) {
        std::vector<Network::ClockConstraint> made;
        for (Network::ClockConstraint constraint : list) {
            const std::int64_t least = relaxation.least[next], greatest = relaxation.greatest[next];
            ++next;
            if (least != greatest) constraint.relation = Op::GreaterEqual;
            constraint.bound = network.exprs.integer(least);
            made.push_back(constraint);
            if (least == greatest) continue;
            constraint.relation = Op::LessEqual;
            constraint.bound = network.exprs.integer(greatest);
            made.push_back(constraint);
        }
        list = std::move(made);
    });
    return network;
}

ClockFacts::ClockFacts(const Network& network) {
    const std::vector<ProcessClocks> clocks = analyse_clocks(network);
    for_each_list(network, [&](const Network::Process&, const std::vector<Network::ClockConstraint>& list) {
        for (const Network::ClockConstraint& constraint : list)
            strict_ = strict_ || constraint.relation == Op::Less || constraint.relation == Op::Greater;
    });
    for (const Id<Network::Process> id : network.processes.ids()) {
        const Network::Template& automaton = network.templates[network.processes[id].automaton];
        for (const Network::Location& location : automaton.locations)
            for (const Network::ClockConstraint& bound : location.invariant)
                late_.push_back(admitted(network, bound).high >= 1);
        for (const Network::Edge& edge : automaton.edges) {
            const EdgeTiming timing = timing_of(network, clocks[id.index], automaton, edge);
            edges_.push_back({timing.frees, timing.at_last && automaton.locations[edge.from].invariant.empty()});
        }
    }
}

bool ClockFacts::releases_bounds_of(const ClockFacts& relaxation) const {
    for (std::size_t i = 0; i < edges_.size(); ++i)
        if ((relaxation.edges_[i].frees & ~edges_[i].frees) != 0) return false;
    for (std::size_t i = 0; i < late_.size(); ++i)
        if (relaxation.late_[i] && !late_[i]) return false;
    return true;
}

bool ClockFacts::keeps_edges_of(const ClockFacts& relaxation) const {
    for (std::size_t i = 0; i < edges_.size(); ++i)
        if (relaxation.edges_[i].at_last && !edges_[i].at_last) return false;
    return true;
}

}  // namespace grafverif
