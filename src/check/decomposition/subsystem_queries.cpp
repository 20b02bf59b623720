// SPDX-License-Identifier: MIT
#include "check/decomposition/subsystem_queries.hpp"

#include <numeric>
#include <utility>

#include "check/timed/property_queries.hpp"
#include "ir/step_names.hpp"

namespace grafverif {

namespace {

/// Returns the parts that the operands of `property` read. If an operand reads a variable that has copies in several
/// parts, the result contains all parts.
PartNumbers read_by(const Network& network, const NetworkSubsystems& parts, const Property& property) {
    for (const Id<Expr> operand : property.operands)
        for (const Id<Expr> leaf : leaves(network.exprs, operand)) {
            const Expr& node = network.exprs[leaf];
            const Id<Network::Variable> variable{static_cast<std::uint32_t>(node.value)};
            if (node.op != Op::Variable) continue;
            if (variable != network.race && !network.variables[variable].scratch) continue;
            PartNumbers all(parts.count);
            std::iota(all.begin(), all.end(), 0U);
            return all;
        }
    return parts_read(network, parts, property.operands);
}

/// Adds to `list` a separate query for each step that `question` names.
void add_steps(const Network& network, const NetworkSubsystems& parts, const SubsystemQuery& question,
               std::vector<SubsystemQuery>& list) {
    for (const Id<Expr> step : question.property.operands) {
        SubsystemQuery one = question;
        one.verdict.property +=
            "." + step_variable_name(network, {static_cast<std::uint32_t>(network.exprs[step].value)});
        one.property.name = one.verdict.property;
        one.property.pattern = Pattern::Reachable;
        one.property.operands = {step};
        one.reads = read_by(network, parts, one.property);
        list.push_back(std::move(one));
    }
}

}  // namespace

std::vector<SubsystemQuery> subsystem_queries(const Network& network, const NetworkSubsystems& parts,
                                              const TimedOptions& options) {
    std::vector<SubsystemQuery> list;
    bool timelock_requested = !options.timelock;
    for (const Id<Property> id : network.properties.ids()) {
        const Property& property = network.properties[id];
        if (!timed::is_selected(options, property)) continue;
        timelock_requested = timelock_requested || timed::about_time(property);
        SubsystemQuery question{property, verdict_on(id, property), read_by(network, parts, property)};
        if (property.pattern == Pattern::ReachableAllSteps) {
            add_steps(network, parts, question, list);
            continue;
        }
        const bool of_moves = property.pattern == Pattern::NoDeadlock || property.pattern == Pattern::NoTimelock;
        question.race = timed::about_race(network, property);
        question.each = question.race || (of_moves && !property.at_stable);
        list.push_back(std::move(question));
    }
    if (timelock_requested) return list;
    const Property timelock = timed::undeclared_timelock(network);
    list.push_back({.property = timelock, .verdict = verdict_on({}, timelock), .each = true});
    return list;
}

}  // namespace grafverif
