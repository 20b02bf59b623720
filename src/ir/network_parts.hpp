// SPDX-License-Identifier: MIT
// Sub-loops: the parts of a Network that share nothing but time.
//
// Two processes are of one part when one of them writes a variable that the other reads or writes, and the parts are the
// least classes that this makes. Clocks belong to one process. What carries nothing from one process to another ties
// nothing: a variable that nobody writes, a scratch variable, and the flag `race`, which is looked at as one flag per
// part, for a state in which it is set is the end of a run. A process without edges and invariants does nothing and is
// put with the first part.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

struct NetworkParts {
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    std::uint32_t count = 0;                      ///< parts are numbered by their first process
    std::vector<std::uint32_t> of_process = {};   ///< per process, its part
    std::vector<std::uint32_t> of_variable = {};  ///< per variable: whose it is; none: it ties nothing
    /// Per part, the conjuncts of `settled` that read nothing else. Empty: there is none, or one of them reads several.
    std::vector<std::vector<Id<Expr>>> settled = {};
};

NetworkParts parts_of(const Network& network);

/// The parts whose variables and locations `terms` read, in order.
std::vector<std::uint32_t> parts_read(const Network& network, const NetworkParts& parts,
                                      const std::vector<Id<Expr>>& terms);

/// What users call a part: its controllers, or its first instance.
std::string name_of_part(const Network& network, const NetworkParts& parts, std::uint32_t part);

/// Some parts of a network as a network of their own, without properties. Of controllers it keeps their names and
/// processes, of `settled` what is said of these parts.
struct SubNetwork {
    Network network = {};
    std::vector<Id<Network::Process>> processes = {};  ///< what its processes are in the whole
    std::vector<Id<Network::Variable>> variables = {};
};

/// Terms of the whole network in terms of one of its parts; they read no other part.
class SubNetworkBuilder {
public:
    /// `network` is expanded and outlives this; `chosen` are parts of it, in order.
    SubNetworkBuilder(const Network& network, const NetworkParts& parts, const std::vector<std::uint32_t>& chosen);
    SubNetworkBuilder(const SubNetworkBuilder&) = delete;
    SubNetworkBuilder& operator=(const SubNetworkBuilder&) = delete;

    /// A property of the whole, as one of the part.
    void ask(Property property);
    SubNetwork build() && { return std::move(made_); }

private:
    Id<Expr> leaf(const Expr& node);
    Id<Network::Variable> here(Id<Network::Variable> variable);
    void add_process(Id<Network::Process> id);
    void add_controller(const Network::Controller& controller);
    const Network& whole_;
    SubNetwork made_ = {};
    std::vector<std::uint32_t> process_ = {};   // of the whole -> of the part
    std::vector<std::uint32_t> variable_ = {};  // likewise
    TermCopier copy_;
};

/// A run of a part in terms of the whole: the same moves.
Run in_whole(const SubNetwork& part, Run run);

}  // namespace grafverif
