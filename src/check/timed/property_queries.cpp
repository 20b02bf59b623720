// SPDX-License-Identifier: MIT
// Compiles properties to code and monitors. The code includes `at stable`: for `always` and `exactly one of`, the
// monitor searches for a state in which `settled` is true and the property is violated; an operand p of any other
// pattern is replaced by `settled` and p.
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

bool is_selected(const TimedOptions& options, const Property& property) {
    return options.properties.empty() || about_time(property) ||
           std::ranges::find(options.properties, property.name) != options.properties.end();
}

PropertyQueries::PropertyQueries(const Network& network, Machine& machine, PropertyMonitor& watch, bool abstracted)
    : network_(network), machine_(machine), watch_(watch), abstracted_(abstracted), inexact_(inexact_place(network)) {}

std::uint32_t PropertyQueries::settled_and(const Property& property, Id<Expr> operand) {
    const std::uint32_t code = machine_.compiler().condition(operand, Program::yes, Program::no);
    return property.at_stable ? machine_.compiler().condition(network_.settled, code, Program::no) : code;
}

std::uint32_t PropertyQueries::settled_but_not(const Property& property, Id<Expr> operand) {
    const std::uint32_t code = machine_.compiler().condition(operand, Program::no, Program::yes);
    return property.at_stable ? machine_.compiler().condition(network_.settled, code, Program::no) : code;
}

/// Returns code that ends in Yes if none or at least two of the operands hold. The code is generated from the last
/// operand backwards, for two cases: no previous operand holds, or one previous operand holds.
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
    const std::uint32_t settled =
        property.at_stable ? machine_.compiler().condition(network_.settled, Program::yes, Program::no) : Program::yes;
    for (const Id<Network::Variable> step : steps) {
        PropertyQuery question = prototype;
        question.verdict.property += "." + step_variable_name(network_, step);
        question.watch = watch_.add_bit(machine_.layout().variables[step.index], settled);
        questions_.push_back(std::move(question));
    }
}

void PropertyQueries::add_query(Id<Property> about, const Property& property) {
    PropertyQuery question{.property = &property, .at_stable = property.at_stable};
    question.verdict = verdict_on(about, property);
    if (property.at_stable && is_checked(property.pattern) && !network_.settled.valid()) {
        set_unknown(question.verdict, UnknownReason::Unsupported, "this network does not define quiescent states");
        questions_.push_back(std::move(question));
        return;
    }
    if (property.at_stable && is_checked(property.pattern) && settled_watch_ == none)
        settled_watch_ = watch_.add(machine_.compiler().condition(network_.settled, Program::yes, Program::no));
    if (property.pattern == Pattern::ReachableAllSteps) return query_step_states(property, question);
    compile(question);
    questions_.push_back(std::move(question));
}

bool PropertyQueries::follow_edges() const {
    return std::ranges::any_of(questions_, [](const PropertyQuery& question) {
        const Pattern pattern = question.property->pattern;
        return is_liveness(pattern) || pattern == Pattern::AlwaysPossible;
    });
}

bool PropertyQueries::are_about_single_states() const {
    return std::ranges::all_of(
        questions_, [](const PropertyQuery& question) { return is_about_states(question.property->pattern); });
}

void PropertyQueries::compile(PropertyQuery& question) {
    const Property& property = *question.property;
    switch (property.pattern) {
    case Pattern::Always: question.watch = watch_.add(settled_but_not(property, property.operands[0])); return;
    case Pattern::Never:
    case Pattern::Reachable: question.watch = watch_.add(settled_and(property, property.operands[0])); return;
    case Pattern::ExactlyOneOf: question.watch = watch_.add(not_exactly_one(property)); return;
    case Pattern::Inevitable: question.q = settled_and(property, property.operands[0]); return;
    case Pattern::LeadsTo:
        question.p = settled_and(property, property.operands[0]);
        question.q = settled_and(property, property.operands[1]);
        question.watch = watch_.add(question.p);
        return;
    case Pattern::AlwaysPossible: question.p = settled_and(property, property.operands[0]); return;
    case Pattern::NoDeadlock:
    case Pattern::NoTimelock:
        question.p = property.at_stable ? machine_.compiler().condition(network_.settled, Program::yes, Program::no)
                                        : Program::yes;
        return;
    case Pattern::ReachableAllSteps: return;
    case Pattern::RawUppaal:
    case Pattern::RawCtl:
    case Pattern::Watched:
    case Pattern::RawLtl:
        set_unknown(question.verdict, UnknownReason::Unsupported, "the timed engine does not support formulas");
        return;
    }
    unreachable();
}

}  // namespace grafverif::timed
