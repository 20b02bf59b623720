// SPDX-License-Identifier: MIT
#include "compose/vacuity.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "ir/junction.hpp"
#include "ir/probes.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

namespace {

using Scope = Sentence::Scope;

/// The premise of a property: a condition that must be true in some state of a scope. Otherwise, the property holds
/// vacuously in this scope.
struct Premise {
    Id<Expr> term = {};
    /// Note that is reported if the condition is never true; empty if the condition is true in every state.
    std::string never = {};
};

Premise premise_of(Exprs& exprs, const Sentence& sentence, const std::vector<Id<Expr>>& operands) {
    const std::string premise = "the premise is never true", response = "the response is never needed";
    switch (sentence.kind) {
    case Sentence::Kind::Absence:
    case Sentence::Kind::Universality:
    case Sentence::Kind::Existence: return {exprs.constant(true)};
    case Sentence::Kind::Response:
    case Sentence::Kind::HoldsFor:
    case Sentence::Kind::HoldsAtMost:
    case Sentence::Kind::Since:
    case Sentence::Kind::Occurrences: return {operands[0], premise};
    case Sentence::Kind::Precedence: return {operands[1], response};
    case Sentence::Kind::Recurrence: return {exprs.negation(operands[0]), response};
    }
    unreachable();
}

/// True if only scopes that close are relevant for properties with this type of scope.
bool must_close(Scope scope) { return scope == Scope::Before || scope == Scope::Between; }

/// The terms that open and close the scope of a property.
class ScopeTerms {
public:
    ScopeTerms(Network& network, const Property& property, const ObserverTerms& terms)
        : exprs_(network.exprs), terms_(terms), scope_(property.watch.scope) {
        const bool pair = scope_ == Scope::Between || scope_ == Scope::AfterUntil;
        const std::size_t count = terms.operands.size();
        if (scope_ == Scope::Before) closes = terms.operands[count - 1];
        if (scope_ == Scope::After) opens = terms.operands[count - 1];
        if (!pair) return;
        closes = terms.operands[count - 1];
        opens = exprs_.conjunction(terms.operands[count - 2], exprs_.negation(closes));
    }

    Id<Expr> opens = {}, closes = {};  ///< invalid if the type of scope has no such term

    /// Returns a term that is true when the observer reads a relevant state in which `term` holds.
    Id<Expr> observed(Id<Expr> term) { return exprs_.conjunction(std::vector{terms_.active, terms_.considered, term}); }

private:
    Exprs& exprs_;
    const ObserverTerms& terms_;
    Scope scope_;
};

constexpr std::int64_t none_yet = 0, met = 1, over = 2;  ///< values of the variable that records the state of the scope

}  // namespace

Id<Network::Variable> follow_scope(Network& network, UniqueNames& names, const Property& property,
                                   const ObserverTerms& terms, Network::Template& automaton) {
    Exprs& exprs = network.exprs;
    const Scope scope = property.watch.scope;
    std::vector<bool> seen(exprs.size());
    const auto divides = [&](Id<Expr> term) { return may_divide(exprs, term, seen); };
    if (!must_close(scope) || std::ranges::any_of(terms.operands, divides)) return {};
    const Id<Network::Variable> variable =
        network.variables.add({.name = names.fresh(property.name + "_scope"),
                               .role = Network::Role::Flag,
                               .type = integer_type(none_yet, scope == Scope::Before ? over : met),
                               .initial = none_yet});
    const Id<Expr> now = exprs.leaf(Op::Variable, variable.index);
    const ScopeTerms in(network, property, terms);
    const Id<Expr> premise = premise_of(exprs, property.watch, terms.operands).term;
    const auto then = [&](Id<Expr> when, std::int64_t value, Id<Expr> otherwise) {
        return exprs.conditional(when, exprs.integer(value), otherwise);
    };
    const auto next = [&](bool opening) {
        const Id<Expr> meets = opening ? exprs.conjunction(in.opens, premise) : premise;
        const Id<Expr> open = then(in.closes, scope == Scope::Before ? over : none_yet, then(meets, met, now));
        if (scope == Scope::Between) return exprs.conditional(terms.considered, open, now);
        const Id<Expr> is_open = exprs.apply(Op::NotEqual, now, exprs.integer(over));
        return exprs.conditional(exprs.conjunction(terms.considered, is_open), open, now);
    };
    for (Network::Edge& edge : automaton.edges)
        if (edge.urgent)
            edge.assignments.push_back({now, next(scope == Scope::Between && edge.from == automaton.initial)});
    return variable;
}

std::vector<Property> vacuity_probes(Network& network, const Property& property, const ObserverTerms& terms,
                                     Id<Network::Process> observer, Id<Network::Variable> followed) {
    Exprs& exprs = network.exprs;
    std::vector<Property> probes;
    const auto add = [&](const char* kind, Id<Expr> term, std::string never) {
        probes.push_back(probe_of(property, kind, term, std::move(never)));
    };
    ScopeTerms in(network, property, terms);
    const Premise premise = premise_of(exprs, property.watch, terms.operands);
    if (property.at_stable) add("settled", in.observed(exprs.constant(true)), "no state is quiescent");
    switch (property.watch.scope) {
    case Scope::Globally: add("premise", in.observed(premise.term), premise.never); break;
    case Scope::After:
    case Scope::AfterUntil: {
        add("scope", in.observed(in.opens), "the scope never opens");
        if (premise.never.empty()) break;
        const Network::Template& automaton = network.templates[network.processes[observer].automaton];
        const Id<Expr> outside = exprs.at(observer.index, automaton.initial.index);
        Id<Expr> inside = exprs.disjunction(exprs.negation(outside), in.opens);
        if (in.closes.valid()) inside = exprs.conjunction(inside, exprs.negation(in.closes));
        add("premise", in.observed(exprs.conjunction(inside, premise.term)), premise.never + " within the scope");
        break;
    }
    case Scope::Before:
    case Scope::Between:
        if (in.opens.valid()) add("scope", in.observed(in.opens), "the scope never opens");
        else add("scope", in.observed(in.closes), "the scope never closes");
        if (!followed.valid()) break;
        const Id<Expr> is_met = exprs.apply(Op::Equal, exprs.leaf(Op::Variable, followed.index), exprs.integer(met));
        std::string never = in.opens.valid() ? "the scope never closes" : "the scope is always empty";
        if (!premise.never.empty()) never = premise.never + " within a scope that closes";
        add("premise", in.observed(exprs.conjunction(in.closes, is_met)), std::move(never));
        break;
    }
    return probes;
}

}  // namespace grafverif
