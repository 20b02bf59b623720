// SPDX-License-Identifier: MIT
// Independent subsystems ("parts") of a Network: sets of processes that share no variables and interact only because
// time passes for all of them.
//
// Two processes belong to the same part if one of them writes a variable that the other reads or writes. Parts are the
// equivalence classes of the transitive closure of this relation. Clocks belong to one process. Three types of
// variables do not transfer information between processes and create no dependency: variables without writers, scratch
// variables, and the flag `race`. The flag `race` can be separate for each part, because a race in any part ends the
// run. A process that has neither edges nor invariants belongs to the first part.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

struct NetworkSubsystems {
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    std::uint32_t count = 0;                      ///< number of parts, which are ordered by their first process
    std::vector<std::uint32_t> of_process = {};   ///< part of each process
    std::vector<std::uint32_t> of_variable = {};  ///< part of each variable; `none`: the variable has no part

    /// For each part: the conjuncts of Network::settled that read only this part. `settled` is empty if
    /// Network::settled is invalid or one of its conjuncts reads several parts.
    std::vector<std::vector<Id<Expr>>> settled = {};
};

NetworkSubsystems parts_of(const Network& network);

/// Returns the parts whose variables and locations `terms` read, in order.
std::vector<std::uint32_t> parts_read(const Network& network, const NetworkSubsystems& parts,
                                      const std::vector<Id<Expr>>& terms);

/// Returns the displayed name of a part: the names of its controllers or, without controllers, the name of its first
/// instance.
std::string name_of_part(const Network& network, const NetworkSubsystems& parts, std::uint32_t part);

/// A separate network that consists of some parts of a network. The subnetwork contains the processes of these parts,
/// the data about their controllers, and the conjuncts of `settled` that read these parts. The properties of the
/// subnetwork are the properties that SubNetworkBuilder::add_property added.
struct SubNetwork {
    Network network = {};
    std::vector<Id<Network::Process>> processes = {};  ///< for each process: its id in the complete network
    std::vector<Id<Network::Variable>> variables = {};
};

/// Builds a subnetwork, and translates terms of the complete network to terms of the subnetwork. Requires that these
/// terms read only parts of the subnetwork.
class SubNetworkBuilder {
public:
    /// `chosen` contains parts of `network`, in order. Requires that `network` is expanded and outlives this object.
    SubNetworkBuilder(const Network& network, const NetworkSubsystems& parts, const std::vector<std::uint32_t>& chosen);
    SubNetworkBuilder(const SubNetworkBuilder&) = delete;
    SubNetworkBuilder& operator=(const SubNetworkBuilder&) = delete;

    /// Adds a property of the complete network to the subnetwork.
    void add_property(Property property);
    SubNetwork build() && { return std::move(made_); }

private:
    Id<Expr> leaf(const Expr& node);
    Id<Network::Variable> here(Id<Network::Variable> variable);
    void add_process(Id<Network::Process> id);
    void add_controller(const Network::Controller& controller);
    const Network& whole_;
    SubNetwork made_ = {};
    std::vector<std::uint32_t> process_ = {};   // maps processes of the complete network to processes of the subnetwork
    std::vector<std::uint32_t> variable_ = {};  // maps variables of the complete network to variables of the subnetwork
    TermCopier copy_;
};

/// Converts a run of a subnetwork to a run of the complete network, with the same moves.
Run in_complete(const SubNetwork& part, Run run);

}  // namespace grafverif
