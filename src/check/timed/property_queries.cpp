// SPDX-License-Identifier: MIT
// Compiles properties to code and to searches of the property monitor. The code includes the condition of quiescence
// (Network::settled) of a property with `at stable`. For `always` and `exactly one of`, the monitor searches for a
// quiescent state that violates the property. For any other pattern, each operand p is replaced by the conjunction of
// Network::settled and p.
#include "check/timed/property_queries.hpp"

#include <algorithm>

#include "ir/patterns.hpp"
#include "ir/step_names.hpp"
#include "support/overloaded.hpp"

namespace grafverif::timed {

namespace {

/// True if `at stable` restricts the states in which a property of this pattern is checked.
bool is_checked(Pattern pattern) {
    return pattern != Pattern::Watched && pattern != Pattern::RawUppaal && pattern != Pattern::RawCtl &&
           pattern != Pattern::RawLtl;
}

}  // namespace

Property undeclared_timelock(const Network& network) {
    Property property{.name = "no_timelock", .pattern = Pattern::NoTimelock};
    while (std::ranges::any_of(network.properties, [&](const Property& other) { return other.name == property.name; }))
        property.name += "_";
    return property;
}

bool about_time(const Property& property) { return property.pattern == Pattern::NoTimelock && !property.at_stable; }

bool about_race(const Network& network, const Property& property) {
    if (!network.race.valid() || property.pattern != Pattern::Never || property.at_stable) return false;
    const Expr& operand = network.exprs[property.operands[0]];
    return operand.op == Op::Variable && operand.value == network.race.index;
}

bool is_selected(const TimedOptions& options, const Property& property) {
    return options.properties.empty() || about_time(property) ||
           std::ranges::find(options.properties, property.name) != options.properties.end();
}

PropertyQueries::PropertyQueries(const Network& network, Machine& machine, PropertyMonitor& monitor, bool abstracted)
    : network_(network),
      machine_(machine),
      monitor_(monitor),
      abstracted_(abstracted),
      inexact_(inexact_place(network)) {}

std::uint32_t PropertyQueries::quiescent_and(const Property& property, Id<Expr> operand) {
    const std::uint32_t code = machine_.compiler().condition(operand, Program::yes, Program::no);
    return property.at_stable ? machine_.compiler().condition(network_.settled, code, Program::no) : code;
}

std::uint32_t PropertyQueries::quiescent_but_not(const Property& property, Id<Expr> operand) {
    const std::uint32_t code = machine_.compiler().condition(operand, Program::no, Program::yes);
    return property.at_stable ? machine_.compiler().condition(network_.settled, code, Program::no) : code;
}

/// Returns code that ends in Yes if no operand or at least two operands hold. The code is generated backwards,
/// beginning with the last operand. For each operand, the function generates code for two cases: no previous operand
/// holds, or one previous operand holds.
std::uint32_t PropertyQueries::not_exactly_one(const Property& property) {
    Compiler& compiler = machine_.compiler();
    std::uint32_t after_none = Program::yes;
    std::uint32_t after_one = Program::no;
    for (auto operand = property.operands.rbegin(); operand != property.operands.rend(); ++operand) {
        after_none = compiler.condition(*operand, after_one, after_none);
        after_one = compiler.condition(*operand, Program::yes, after_one);
    }
    return property.at_stable ? compiler.condition(network_.settled, after_none, Program::no) : after_none;
}

void PropertyQueries::query_step_states(const Property& property, const PropertyQuery& prototype) {
    std::vector<Id<Network::Variable>> steps;
    for (const Id<Expr> operand : property.operands)
        steps.push_back({static_cast<std::uint32_t>(network_.exprs[operand].value)});
    if (steps.empty())
        for (const Id<Network::Variable> variable : network_.variables.ids())
            if (network_.variables[variable].role == Network::Role::Step) steps.push_back(variable);
    const std::uint32_t quiescent =
        property.at_stable ? machine_.compiler().condition(network_.settled, Program::yes, Program::no) : Program::yes;
    for (const Id<Network::Variable> step : steps) {
        PropertyQuery query = prototype;
        query.verdict.property += "." + step_variable_name(network_, step);
        query.search = monitor_.add_bit(machine_.layout().variables[step.index], quiescent);
        queries_.push_back(std::move(query));
    }
}

void PropertyQueries::add_query(Id<Property> about, const Property& property) {
    PropertyQuery query{.property = &property, .at_stable = property.at_stable};
    query.verdict = verdict_on(about, property);
    if (property.at_stable && is_checked(property.pattern) && !network_.settled.valid()) {
        set_unknown(query.verdict, UnknownReason::Unsupported, "this network does not define quiescent states");
        queries_.push_back(std::move(query));
        return;
    }
    if (property.at_stable && is_checked(property.pattern) && quiescent_search_ == none)
        quiescent_search_ = monitor_.add(machine_.compiler().condition(network_.settled, Program::yes, Program::no));
    if (property.pattern == Pattern::ReachableAllSteps) return query_step_states(property, query);
    compile(query);
    queries_.push_back(std::move(query));
}

bool PropertyQueries::follow_edges() const {
    return std::ranges::any_of(queries_, [](const PropertyQuery& query) {
        const Pattern pattern = query.property->pattern;
        return is_liveness(pattern) || pattern == Pattern::AlwaysPossible;
    });
}

void PropertyQueries::compile(PropertyQuery& query) {
    const Property& property = *query.property;
    switch (property.pattern) {
    case Pattern::Always: query.search = monitor_.add(quiescent_but_not(property, property.operands[0])); return;
    case Pattern::Never:
    case Pattern::Reachable: query.search = monitor_.add(quiescent_and(property, property.operands[0])); return;
    case Pattern::ExactlyOneOf: query.search = monitor_.add(not_exactly_one(property)); return;
    case Pattern::Inevitable: query.q = quiescent_and(property, property.operands[0]); return;
    case Pattern::LeadsTo:
        query.p = quiescent_and(property, property.operands[0]);
        query.q = quiescent_and(property, property.operands[1]);
        query.search = monitor_.add(query.p);
        return;
    case Pattern::AlwaysPossible: query.p = quiescent_and(property, property.operands[0]); return;
    case Pattern::NoDeadlock:
    case Pattern::NoTimelock:
        query.p = property.at_stable ? machine_.compiler().condition(network_.settled, Program::yes, Program::no)
                                     : Program::yes;
        return;
    case Pattern::ReachableAllSteps: return;
    case Pattern::RawUppaal:
    case Pattern::RawCtl:
    case Pattern::Watched:
    case Pattern::RawLtl:
        set_unknown(query.verdict, UnknownReason::Unsupported, "the timed engine does not support formulas");
        return;
    }
    unreachable();
}

}  // namespace grafverif::timed
