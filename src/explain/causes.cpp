// SPDX-License-Identifier: MIT
#include "explain/causes.hpp"

#include <algorithm>
#include <functional>
#include <map>

namespace grafverif {

namespace {

using Terms = std::vector<Id<Expr>>;

/// A run in which terms are evaluated: its distinct states, and a function for the value of a term in a state.
struct States {
    const Exprs& exprs;
    Id<Expr> settled = {};
    std::size_t count = 0;
    std::optional<std::size_t> loop = {};  ///< index of the state that follows the last state
    std::function<std::optional<std::int64_t>(std::size_t state, Id<Expr> term)> value = {};
};

/// Explains why a term that must be true in a state of a run is false.
class RequiredTerm {
public:
    RequiredTerm(const Exprs& exprs, Id<Expr> formula) : exprs_(exprs), formula_(formula) { collect(formula, true); }

    /// Finds the terms whose values cause the required term to be false in `state`. Returns false if a value is
    /// undefined, or if the required term is true.
    bool explain(const States& states, std::size_t state, std::size_t most, Terms& found, bool& exact) {
        values_.clear();
        for (const Id<Expr> term : terms_) {
            const auto now = states.value(state, term);
            if (!now) return false;
            values_.push_back(*now != 0);
        }
        if (holds(formula_)) return false;
        std::vector<std::size_t> bottom;
        for (std::size_t k = 0; k < terms_.size(); ++k)
            if (values_[k] ? negative_[k] : positive_[k]) bottom.push_back(k);
        const bool once = std::ranges::none_of(twice_, [](bool each) { return each; });
        if (!once && bottom.size() > most) exact = false;
        std::vector<bool> causes(terms_.size(), false);
        if (once || bottom.size() > most) by_rule(formula_, true, causes);
        else by_definition(bottom, causes);
        for (std::size_t k = 0; k < terms_.size(); ++k)
            if (causes[k]) found.push_back(terms_[k]);
        return true;
    }

private:
    void collect(Id<Expr> term, bool wanted) {
        const Op op = exprs_[term].op;
        if (op == Op::Not) return collect(exprs_.operands(term)[0], !wanted);
        if (op == Op::And || op == Op::Or) {
            for (const Id<Expr> operand : exprs_.operands(term)) collect(operand, wanted);
            return;
        }
        if (is_constant(op)) return;
        const auto [place, is_new] = places_.emplace(term.index, terms_.size());
        if (is_new) {
            terms_.push_back(term);
            positive_.push_back(false);
            negative_.push_back(false);
            twice_.push_back(false);
        } else {
            twice_[place->second] = true;
        }
        (wanted ? positive_ : negative_)[place->second] = true;
    }

    bool holds(Id<Expr> term) const {
        const Op op = exprs_[term].op;
        const auto operands = exprs_.operands(term);
        const auto so = [this](Id<Expr> each) { return holds(each); };
        if (op == Op::Not) return !holds(operands[0]);
        if (op == Op::And) return std::ranges::all_of(operands, so);
        if (op == Op::Or) return std::ranges::any_of(operands, so);
        if (is_constant(op)) return op == Op::True;
        return values_[places_.at(term.index)];
    }

    /// Applies the rule of Beer et al. (causes.hpp) to a `term` whose value is not `wanted`. For a conjunction that
    /// should be true, the causes are the false operands; for a disjunction, all operands.
    void by_rule(Id<Expr> term, bool wanted, std::vector<bool>& causes) const {
        const Op op = exprs_[term].op;
        if (op == Op::Not) return by_rule(exprs_.operands(term)[0], !wanted, causes);
        if (op == Op::And || op == Op::Or) {
            for (const Id<Expr> operand : exprs_.operands(term))
                if (holds(operand) != wanted) by_rule(operand, wanted, causes);
            return;
        }
        if (!is_constant(op)) causes[places_.at(term.index)] = true;
    }

    void by_definition(const std::vector<std::size_t>& bottom, std::vector<bool>& causes) {
        const std::vector<bool> before = values_;
        std::vector<bool> mended(std::size_t{1} << bottom.size());
        for (std::size_t set = 0; set < mended.size(); ++set) {
            values_ = before;
            for (std::size_t k = 0; k < bottom.size(); ++k)
                if ((set >> k & 1U) != 0) values_[bottom[k]] = !before[bottom[k]];
            mended[set] = holds(formula_);
        }
        values_ = before;
        for (std::size_t set = 0; set < mended.size(); ++set)
            for (std::size_t k = 0; k < bottom.size() && !mended[set]; ++k)
                if ((set >> k & 1U) == 0 && mended[set | std::size_t{1} << k]) causes[bottom[k]] = true;
    }

    const Exprs& exprs_;
    Id<Expr> formula_;
    Terms terms_ = {};
    std::map<std::uint32_t, std::size_t> places_ = {};
    std::vector<bool> positive_ = {}, negative_ = {}, twice_ = {}, values_ = {};
};

/// Returns, for a property about single states, the term that is true in every state if the property holds.
Id<Expr> safe(const Property& property, Exprs& exprs) {
    const Terms& p = property.operands;
    if (property.pattern == Pattern::Always) return p[0];
    if (property.pattern == Pattern::Never) return exprs.negation(p[0]);
    Terms all = {exprs.disjunction(p)};
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t k = i + 1; k < p.size(); ++k) {
            const Terms both = {p[i], p[k]};
            all.push_back(exprs.negation(exprs.conjunction(both)));
        }
    return exprs.conjunction(all);
}

/// Returns the indices of the states that the run visits from `state` on, including `state`.
std::vector<std::size_t> states_from(std::size_t state, std::size_t count, std::optional<std::size_t> loop) {
    std::vector<std::size_t> list;
    for (std::size_t k = loop ? std::min(state, *loop) : state; k < count; ++k) list.push_back(k);
    return list;
}

class CauseSearch {
public:
    CauseSearch(const Property& property, const States& states, std::size_t most)
        : property_(property),
          states_(states),
          count_(states.count),
          loop_(states.loop),
          most_(most),
          exprs_(states.exprs) {}

    std::optional<Causes> causes() {
        switch (property_.pattern) {
        case Pattern::Always:
        case Pattern::Never:
        case Pattern::ExactlyOneOf: return safety();
        case Pattern::LeadsTo: return response();
        default: return {};
        }
    }

private:
    std::optional<Causes> safety() {
        RequiredTerm demand(exprs_, safe(property_, exprs_));
        for (std::size_t state = 0; state < count_; ++state)
            if (is_considered(state) && explain(demand, state)) return std::move(causes_);
        return {};
    }

    std::optional<Causes> response() {
        const Id<Expr> p = property_.operands[0], q = property_.operands[1];
        std::size_t premise_state = count_;
        for (std::size_t state = 0; state < count_ && premise_state == count_; ++state) {
            const auto later = states_from(state, count_, loop_);
            const auto is = [&](Id<Expr> term, std::size_t at) {
                return is_considered(at) && states_.value(at, term).value_or(0) != 0;
            };
            if (is(p, state) && std::ranges::none_of(later, [&](std::size_t at) { return is(q, at); }))
                premise_state = state;
        }
        if (premise_state == count_) return {};
        const Id<Expr> answered = exprs_.disjunction(exprs_.negation(p), q);
        RequiredTerm here(exprs_, answered), there(exprs_, q);
        for (const std::size_t state : states_from(premise_state, count_, loop_))
            if (is_considered(state) && !explain(state == premise_state ? here : there, state)) return {};
        return std::move(causes_);
    }

    bool is_considered(std::size_t state) const {
        return !property_.at_stable || states_.value(state, states_.settled) == 1;
    }

    bool explain(RequiredTerm& demand, std::size_t state) {
        Terms found;
        if (!demand.explain(states_, state, most_, found, causes_.exact)) return false;
        for (const Id<Expr> term : found) causes_.pairs.push_back({term, state});
        return true;
    }

    const Property& property_;
    const States& states_;
    std::size_t count_;
    std::optional<std::size_t> loop_;
    std::size_t most_;
    Exprs exprs_;
    Causes causes_ = {};
};

}  // namespace

std::optional<Causes> causes_of(const Network& network, const Property& property,
                                const std::vector<NetworkState>& states, std::optional<std::size_t> loop,
                                std::size_t most) {
    const States seen{.exprs = network.exprs,
                      .settled = network.settled,
                      // For a run with a loop, the last state is omitted, because it equals the first state of the
                      // loop.
                      .count = loop ? states.size() - 1 : states.size(),
                      .loop = loop,
                      .value = [&](std::size_t state, Id<Expr> term) { return value(network, states[state], term); }};
    return CauseSearch(property, seen, most).causes();
}

std::optional<Causes> causes_of(const TransitionSystem& system, const Property& property, const SystemRun& run,
                                std::size_t most) {
    const auto value = [&](std::size_t state, Id<Expr> term) {
        return evaluate(system.exprs, term,
                        [&](const Expr& leaf) { return run.states[state][static_cast<std::size_t>(leaf.value)]; });
    };
    const States seen{
        .exprs = system.exprs, .settled = system.settled, .count = run.states.size(), .loop = run.loop, .value = value};
    return CauseSearch(property, seen, most).causes();
}

}  // namespace grafverif
