// SPDX-License-Identifier: MIT
// VariableUsers: the processes that write and read each variable of a network, and the processes of the PLCs.
#pragma once

#include <set>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "ir/slots.hpp"

namespace grafverif {

struct VariableUsers {
    std::vector<std::set<Id<Network::Process>>> writers, readers;  ///< one set per variable
    std::set<Id<Network::Process>> plcs = {};

    explicit VariableUsers(const Network& network)
        : writers(network.variables.size()), readers(network.variables.size()) {
        for (const Id<Network::Process> id : network.processes.ids()) {
            const Slots slots(network, id);
            for (const Id<Network::Variable> variable : slots.written()) writers[variable.index].insert(id);
            for (const Id<Network::Variable> variable : slots.read()) readers[variable.index].insert(id);
        }
        for (const Network::Controller& controller : network.controllers) plcs.insert(controller.process);
    }
};

}  // namespace grafverif
