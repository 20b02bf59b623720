// SPDX-License-Identifier: MIT
#include "check/symbolic/property_queries.hpp"

#include <algorithm>
#include <new>
#include <utility>

#include "check/symbolic/dead_transitions.hpp"
#include "check/unsupported.hpp"
#include "ir/patterns.hpp"

namespace grafverif::symbolic {

namespace {}  // namespace

std::vector<State> shortest_trace(const StateSpace& model, ReachableSet& search, const Bdd& goal) {
    if ((search.rings.reached & goal).is_false()) grow(model, search.rings, model.invariant(), goal);
    return shortest_path(model, search.rings, goal);
}

PropertyQueries::PropertyQueries(const TransitionSystem& system, FlatSystem& flat) : system_(system), flat_(flat) {
    if (system.settled.valid()) settled_ = flattened(system, flat, system.settled);
}

Id<Expr> PropertyQueries::settled_and(const Property& property, Id<Expr> operand) {
    return property.at_stable ? flat_.exprs.conjunction(settled_, operand) : operand;
}

Id<Expr> PropertyQueries::exactly_one(const std::vector<Id<Expr>>& operands) {
    Exprs& exprs = flat_.exprs;
    Id<Expr> none = exprs.constant(true), one = exprs.constant(false);
    for (const Id<Expr> operand : operands) {
        one = exprs.disjunction(exprs.conjunction(one, exprs.negation(operand)), exprs.conjunction(none, operand));
        none = exprs.conjunction(none, exprs.negation(operand));
    }
    return one;
}

void PropertyQueries::add_query(Id<Property> about) {
    const Property& property = system_.properties[about];
    PropertyQuery question{about, {}};
    for (const Id<Expr> operand : property.operands) question.operands.push_back(flattened(system_, flat_, operand));
    Exprs& exprs = flat_.exprs;
    // The operand of a property about all states is negated: the check searches for a state that violates the property.
    if (property.pattern == Pattern::ExactlyOneOf) question.operands = {exprs.negation(exactly_one(question.operands))};
    if (property.pattern == Pattern::Always) question.operands = {exprs.negation(question.operands.front())};
    for (Id<Expr>& operand : question.operands) operand = settled_and(property, operand);
    questions_.push_back(std::move(question));
}

std::vector<QueryResult> PropertyQueries::answers(const StateSpace* model, ReachableSet& search,
                                                  const SymbolicOptions& options) {
    std::vector<QueryResult> all;
    UnknownReason obstacle =
        model == nullptr ? search.obstacle : UnknownReason::None;  // if not None, this obstacle applies to all
                                                                   // following queries
    std::string reason = search.reason;
    for (const PropertyQuery& question : questions_) {
        QueryResult found{verdict_on(question.about, of(question)), {}};
        const auto exhausted = [&](UnknownReason what, std::string why) {
            set_unknown(found.verdict, what, why);
            if (what != UnknownReason::Stopped) return;  // another query may need less memory
            obstacle = what;
            reason = std::move(why);
        };
        try {
            if (obstacle == UnknownReason::None) found = answer(question, *model, search);
            else set_unknown(found.verdict, obstacle, reason);
        } catch (const BddExhausted& failure) {
            if (failure.cause() == BddExhausted::Cause::Memory)
                exhausted(UnknownReason::Memory, memory_limit_reached(options.max_memory));
            else exhausted(UnknownReason::Stopped, "stopped");
        } catch (const std::bad_alloc&) {
            exhausted(UnknownReason::Memory, memory_limit_reached(options.max_memory));
        }
        all.push_back(std::move(found));
    }
    // Explanations are computed after all verdicts, because an explanation may need time or memory that a verdict also
    // needs.
    for (QueryResult& found : all) {
        if (!found.dead_state) continue;
        std::string words = what_is_dead(*model, search, *found.dead_state);
        if (!words.empty()) found.verdict.notes.push_back(std::move(words));
    }
    return all;
}

PropertyQueries::Sets PropertyQueries::sets(const PropertyQuery& question, const StateSpace& model,
                                            ReachableSet& search) const {
    Sets sets;
    BddTerms terms = model.terms();
    for (const Id<Expr> operand : question.operands) {
        const BddTerm& term = terms(operand);
        sets.undefined = sets.undefined || !(search.reached & term.undefined).is_false();
        sets.operands.push_back(search.reached & term.bits.front());
    }
    return sets;
}

QueryResult PropertyQueries::answer(const PropertyQuery& question, const StateSpace& model, ReachableSet& search) {
    QueryResult found{verdict_on(question.about, of(question)), {}};
    Verdict& verdict = found.verdict;
    const Pattern pattern = of(question).pattern;
    if (const std::string reason = unsupported_reason(pattern); !reason.empty()) {
        set_unknown(verdict, UnknownReason::Unsupported, reason);
        return found;
    }
    const Sets here = sets(question, model, search);
    if (here.undefined) {
        set_unknown(verdict, UnknownReason::Faulty,
                    "the condition of the property divides by zero in some reachable state");
        return found;
    }
    if (is_about_single_states(pattern)) result_state(found, question, here, model, search);
    else if (search.obstacle != UnknownReason::None) set_unknown(verdict, search.obstacle, search.reason);
    else decide_paths(found, question, here, model, search);
    if (verdict.outcome == Outcome::Holds) mark_vacuous(verdict, question, here, model, search);
    return found;
}

void PropertyQueries::result_state(QueryResult& found, const PropertyQuery& question, const Sets& sets,
                                   const StateSpace& model, ReachableSet& search) {
    Verdict& verdict = found.verdict;
    const bool seen = !sets.operands.front().is_false();
    if (!seen && search.obstacle != UnknownReason::None) return set_unknown(verdict, search.obstacle, search.reason);
    const bool wanted = of(question).pattern == Pattern::Reachable;
    verdict.outcome = seen == wanted ? Outcome::Holds : Outcome::Violated;
    if (seen && (search.witnesses || verdict.outcome == Outcome::Violated))
        found.run = run_of(model, {shortest_trace(model, search, sets.operands.front()), {}});
}

void PropertyQueries::prepare(const StateSpace& model, ReachableSet& search) {
    if (prepared_) return;
    BddTerms terms = model.terms();
    std::vector<Bdd> justice;
    for (const Id<Expr> term : flat_.justice) justice.push_back(search.reached & terms(term).bits.front());
    fair_ = justice.empty() ? search.reached : can_stay(model, search.reached, justice);
    justice_ = std::move(justice);
    prepared_ = true;
}

void PropertyQueries::decide_paths(QueryResult& found, const PropertyQuery& question, const Sets& sets,
                                   const StateSpace& model, ReachableSet& search) {
    prepare(model, search);
    const Bdd& p = sets.operands.front();
    Verdict& verdict = found.verdict;
    verdict.outcome = Outcome::Holds;
    if (of(question).pattern == Pattern::AlwaysPossible) {
        const Bdd dead = fair_ & ~can_reach(model, search.reached, p & fair_);
        if (dead.is_false()) return;
        verdict.outcome = Outcome::Violated;
        verdict.notes.emplace_back("after the last state of the trace, the condition can never become true");
        const std::vector<State> trace = shortest_trace(model, search, dead);
        found.run = run_of(model, {trace, {}});
        found.dead_state = trace.back();
        return;
    }
    const bool leads = of(question).pattern == Pattern::LeadsTo;
    const Bdd without = search.reached & ~(leads ? sets.operands[1] : p);
    const Bdd staying = can_stay(model, without, justice_);
    const Bdd from = staying & (leads ? p : model.initial());
    if (from.is_false()) return;
    verdict.outcome = Outcome::Violated;
    found.run = run_of(model, lasso(model, search, from, staying));
}

/// Returns the note on dead transitions, which are never cleared again after `from`. Returns an empty string if the
/// computation of the note reaches the limit of memory or time.
std::string PropertyQueries::what_is_dead(const StateSpace& model, const ReachableSet& search, const State& from) {
    try {
        return dead_transitions_note(system_, flat_, model, search.reached, from);
    } catch (const BddExhausted&) {
        return {};
    } catch (const std::bad_alloc&) {
        return {};
    }
}

Path PropertyQueries::lasso(const StateSpace& model, ReachableSet& search, const Bdd& from, const Bdd& staying) const {
    Path path{shortest_trace(model, search, from), {}};
    const std::size_t stem = path.states.size() - 1;
    const Path forever = stay(model, path.states.back(), staying, justice_);
    path.states.insert(path.states.end(), forever.states.begin() + 1, forever.states.end());
    path.loop = *forever.loop + stem;
    return path;
}

void PropertyQueries::mark_vacuous(Verdict& verdict, const PropertyQuery& question, const Sets& sets,
                                   const StateSpace& model, ReachableSet& search) {
    const Property& property = of(question);
    const auto vacuous = [&](const char* why) {
        verdict.vacuous = true;
        verdict.notes.emplace_back(why);
    };
    if (is_about_all_states(property.pattern) && property.at_stable) {
        BddTerms terms = model.terms();
        if ((search.reached & terms(settled_).bits.front()).is_false()) vacuous("no state is quiescent");
    }
    if (is_declared_response(property) && sets.operands.front().is_false()) vacuous("the premise is never true");
    if (!is_about_single_states(property.pattern) && !justice_.empty() && (fair_ & model.initial()).is_false())
        vacuous("no run is fair: the fairness conditions cannot all hold infinitely often");
}

}  // namespace grafverif::symbolic
