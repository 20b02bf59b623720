// SPDX-License-Identifier: MIT
#include "check/clocks.hpp"

namespace grafverif::timed {

namespace {

bool strict(const Network::ClockConstraint& constraint) {
    return constraint.relation == Op::Less || constraint.relation == Op::Greater;
}

}  // namespace

std::optional<std::string> inexact_place(const Network& network) {
    for (const Network::Process& process : network.processes) {
        const Network::Template& automaton = network.templates[process.automaton];
        for (const Network::Location& location : automaton.locations)
            for (const Network::ClockConstraint& bound : location.invariant)
                if (strict(bound))
                    return "the strict bound on clock `" + automaton.clocks[bound.clock].name + "` at `" + process.name + "." + location.name + "`";
        for (const Network::Edge& edge : automaton.edges) {
            const std::string place = "`" + process.name + "`, edge `" + automaton.locations[edge.from].name + " -> " +
                                      automaton.locations[edge.to].name + "`";
            for (const Network::ClockConstraint& constraint : edge.constraint)
                if (strict(constraint)) return "the strict constraint on clock `" + automaton.clocks[constraint.clock].name + "` of " + place;
            if (edge.urgent && !keeps_target_invariant(network, process, edge))
                return "the urgent edge that time may switch off, of " + place;
        }
    }
    return {};
}

}  // namespace grafverif::timed
