// SPDX-License-Identifier: MIT
// Hand-written small networks, one template per process, for tests of the timed engine.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "check/timed/timed.hpp"
#include "grafverif/ir/network.hpp"

namespace grafverif {

class Sketch {
public:
    struct Constraint {
        std::uint32_t clock = 0;
        Op relation = Op::LessEqual;
        std::int64_t bound = 0;
    };
    struct Arrow {
        std::uint32_t from = 0, to = 0;
        bool urgent = false;
        Id<Expr> guard = {};  // an invalid id means true
        std::vector<Constraint> when = {};
        std::vector<std::pair<Id<Network::Variable>, Id<Expr>>> set = {};
        std::vector<std::uint32_t> reset = {};
    };

    Id<Network::Variable> boolean(const std::string& name, bool initial = false);
    Id<Network::Variable> integer(const std::string& name, std::int64_t low, std::int64_t high,
                                  std::int64_t initial = 0);
    /// Adds a process with locations `l0`, `l1`, ... and clocks `c0`, `c1`, ...
    Id<Network::Process> process(const std::string& name, std::uint32_t locations, std::uint32_t clocks = 0);
    void invariant(Id<Network::Process> process, std::uint32_t location, Constraint bound);
    void edge(Id<Network::Process> process, const Arrow& arrow);

    Id<Expr> is(Id<Network::Variable> variable) { return network.exprs.leaf(Op::Variable, variable.index); }
    Id<Expr> no(Id<Expr> term) { return network.exprs.negation(term); }
    Id<Expr> at(Id<Network::Process> process, std::uint32_t location) {
        return network.exprs.at(process.index, location);
    }
    Id<Expr> number(std::int64_t value) { return network.exprs.integer(value); }
    Id<Expr> yes() { return network.exprs.constant(true); }
    Id<Expr> op(Op op, Id<Expr> left, Id<Expr> right) { return network.exprs.apply(op, left, right); }

    void property(const std::string& name, Pattern pattern, std::vector<Id<Expr>> operands = {},
                  bool at_stable = false);

    Network network = {};
};

/// Verifies that the network is well formed, checks its properties, and replays every run to a
/// state in which the property is violated or witnessed.
TimedResult checked(const Network& network, const TimedOptions& options = {});
/// Checks that the run of the verdict can be replayed and ends in a state that proves the verdict.
void confirm(const Network& network, const Property& property, const Verdict& verdict);
/// Returns the verdict on one property.
const Verdict& verdict(const TimedResult& result, const std::string& property);
/// Returns `holds`, `violated` or `unknown (inexact)`, followed by `, vacuous` if the verdict is vacuous.
std::string outcome_text(const TimedResult& result, const std::string& property);

/// Returns the same network with a time unit that is finer by `factor`.
Network refined(Network network, std::int64_t factor);

}  // namespace grafverif
