// SPDX-License-Identifier: MIT
#include "unit/check/networks.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "ir/network_run.hpp"

namespace grafverif {

Id<Network::Variable> Sketch::boolean(const std::string& name, bool initial) {
    return network.variables.add({.name = name, .initial = initial ? 1 : 0});
}

Id<Network::Variable> Sketch::integer(const std::string& name, std::int64_t low, std::int64_t high,
                                      std::int64_t initial) {
    return network.variables.add({.name = name, .type = integer_type(low, high), .initial = initial});
}

Id<Network::Process> Sketch::process(const std::string& name, std::uint32_t locations, std::uint32_t clocks) {
    Network::Template automaton{.name = name};
    for (std::uint32_t i = 0; i < locations; ++i) automaton.locations.add({.name = "l" + std::to_string(i)});
    for (std::uint32_t i = 0; i < clocks; ++i) automaton.clocks.add({"c" + std::to_string(i)});
    automaton.initial = {0};
    const Id<Network::Template> id = network.templates.add(std::move(automaton));
    return network.processes.add({.name = name, .automaton = id, .initial = {0}});
}

void Sketch::invariant(Id<Network::Process> process, std::uint32_t location, Constraint bound) {
    const Id<Expr> value = number(bound.bound);
    network.templates[network.processes[process].automaton].locations[{location}].invariant.push_back(
        {{bound.clock}, bound.relation, value});
}

void Sketch::edge(Id<Network::Process> process, const Arrow& arrow) {
    Network::Edge edge{.from = {arrow.from}, .to = {arrow.to}, .urgent = arrow.urgent};
    edge.guard = arrow.guard.valid() ? arrow.guard : yes();
    for (const Constraint& one : arrow.when) edge.constraint.push_back({{one.clock}, one.relation, number(one.bound)});
    for (const auto& [target, value] : arrow.set) edge.assignments.push_back({is(target), value});
    for (const std::uint32_t clock : arrow.reset) edge.resets.push_back({clock});
    network.templates[network.processes[process].automaton].edges.add(std::move(edge));
}

void Sketch::property(const std::string& name, Pattern pattern, std::vector<Id<Expr>> operands, bool at_stable) {
    network.properties.add({.name = name, .pattern = pattern, .operands = std::move(operands), .at_stable = at_stable});
}

namespace {

bool holds_at(const Network& network, const Property& property, std::size_t operand, const NetworkState& state) {
    const bool settled = !property.at_stable || value(network, state, network.settled).value_or(0) != 0;
    return settled && value(network, state, property.operands[operand]).value_or(0) != 0;
}

}  // namespace

void confirm(const Network& network, const Property& property, const Verdict& verdict) {
    const auto states = replay(network, *verdict.run);
    ASSERT_TRUE(states) << "the run fails the replay";
    const NetworkState& last = states->back();
    const auto holds = [&](std::size_t operand, const NetworkState& state) {
        return holds_at(network, property, operand, state);
    };
    const bool settled = !property.at_stable || value(network, last, network.settled).value_or(0) != 0;
    const bool ends = enabled(network, last).empty() && !may_delay(network, last);
    const auto count = std::ranges::count_if(
        property.operands, [&](Id<Expr> operand) { return value(network, last, operand).value_or(0) != 0; });
    switch (property.pattern) {
    case Pattern::Always: EXPECT_TRUE(settled && value(network, last, property.operands[0]) == 0); return;
    case Pattern::Never:
    case Pattern::Reachable: EXPECT_TRUE(holds(0, last)); return;
    case Pattern::ExactlyOneOf: EXPECT_TRUE(settled && count != 1); return;
    case Pattern::Inevitable:
        EXPECT_TRUE(verdict.run->loop || ends);
        for (const NetworkState& state : *states) EXPECT_FALSE(holds(0, state));
        return;
    case Pattern::LeadsTo: {
        EXPECT_TRUE(verdict.run->loop || ends);
        bool shown = false;
        for (std::size_t i = 0; i < states->size() && !shown; ++i)
            shown =
                holds(0, (*states)[i]) && std::none_of(states->begin() + static_cast<std::ptrdiff_t>(i), states->end(),
                                                       [&](const NetworkState& state) { return holds(1, state); });
        EXPECT_TRUE(shown);
        return;
    }
    case Pattern::NoDeadlock: EXPECT_TRUE(enabled(network, last).empty()); return;
    case Pattern::NoTimelock: EXPECT_FALSE(may_delay(network, last)); return;
    case Pattern::ReachableAllSteps:
    case Pattern::AlwaysPossible:
    case Pattern::Watched:
    case Pattern::RawUppaal:
    case Pattern::RawCtl:
    case Pattern::RawLtl: return;
    }
}

TimedResult checked(const Network& network, const TimedOptions& options) {
    EXPECT_EQ(verify(network), std::vector<std::string>{});
    TimedResult result = check_timed(network, options);
    for (const Verdict& verdict : result.verdicts) {
        SCOPED_TRACE(verdict.property);
        EXPECT_EQ(verdict.outcome == Outcome::Unknown, verdict.obstacle != UnknownReason::None);
        EXPECT_EQ(verdict.outcome == Outcome::Unknown, !verdict.reason.empty());
        EXPECT_EQ(verdict.about.valid(), verdict.declared);
        if (verdict.about.valid()) {
            EXPECT_TRUE(verdict.property.starts_with(network.properties[verdict.about].name));
        }
        if (!verdict.run) continue;
        const auto property = std::ranges::find(network.properties, verdict.property, &Property::name);
        if (property != network.properties.end()) confirm(network, *property, verdict);
        else EXPECT_TRUE(replay(network, *verdict.run));
    }
    for (const ModelError& error : result.errors) EXPECT_TRUE(replay(network, error.run));
    return result;
}

const Verdict& verdict(const TimedResult& result, const std::string& property) {
    const auto found = std::ranges::find(result.verdicts, property, &Verdict::property);
    if (found == result.verdicts.end()) throw std::out_of_range("no verdict on " + property);
    return *found;
}

std::string outcome_text(const TimedResult& result, const std::string& property) {
    const Verdict& found = verdict(result, property);
    std::string text(word(found.outcome));
    if (found.obstacle != UnknownReason::None) text += " (" + std::string(word(found.obstacle)) + ")";
    return found.vacuous ? text + ", vacuous" : text;
}

Network refined(Network network, std::int64_t factor) {
    const Id<Expr> times = network.exprs.integer(factor);
    const auto refine = [&](std::vector<Network::ClockConstraint>& constraints) {
        for (Network::ClockConstraint& constraint : constraints)
            constraint.bound = network.exprs.apply(Op::Times, constraint.bound, times);
    };
    for (Network::Template& automaton : network.templates) {
        for (Network::Location& location : automaton.locations) refine(location.invariant);
        for (Network::Edge& edge : automaton.edges) refine(edge.constraint);
    }
    return network;
}

}  // namespace grafverif
