// SPDX-License-Identifier: MIT
#include "check/symbolic/model.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "check/symbolic/event_clusters.hpp"
#include "check/symbolic/order.hpp"
#include "ir/flat_system.hpp"

namespace grafverif::symbolic {

namespace {

using Variable = FlatSystem::Variable;

/// A term, or its negation if `positive` is false.
struct Signed {
    Id<Expr> term = {};
    bool positive = true;
};

/// Returns the operands of a nested conjunction, or of a nested disjunction if `disjunction` is true. If `root` is
/// another kind of term, the result contains only `root`.
std::vector<Signed> operands_of(const Exprs& exprs, Signed root, bool disjunction) {
    std::vector<Signed> open{root}, found;
    while (!open.empty()) {
        const Signed next = open.back();
        open.pop_back();
        const Op op = exprs[next.term].op;
        const bool splits = op == Op::Not || op == (disjunction == next.positive ? Op::Or : Op::And);
        if (!splits) found.push_back(next);
        else
            for (const Id<Expr> operand : exprs.operands(next.term))
                open.push_back({operand, next.positive != (op == Op::Not)});
    }
    return found;
}

/// Splits `condition` into conjuncts. Their conjunction is true for exactly the assignments for which `condition` is
/// true and defined. For example, the conjuncts of `a -> b and not (c or d)` are `a -> b`, `a -> not c` and `a -> not
/// d`. Undefined operands need not be considered separately: if `condition` is defined although an operand is
/// undefined, an earlier operand determines the value of `condition`.
std::vector<Bdd> conjuncts(const Exprs& exprs, BddTerms& terms, Id<Expr> condition) {
    const BddTerm& whole = terms(condition);
    if (!whole.undefined.is_false()) return {whole.bits.front() & ~whole.undefined};
    const auto value = [&](Signed term) {
        const Bdd& bit = terms(term.term).bits.front();
        return term.positive ? bit : ~bit;
    };
    std::vector<Bdd> found;
    for (const Signed& conjunct : operands_of(exprs, {condition}, false)) {
        const std::vector<Signed> disjuncts = operands_of(exprs, conjunct, true);
        std::vector<std::vector<Signed>> parts;  // operands of each disjunct, as a conjunction
        for (const Signed& disjunct : disjuncts) parts.push_back(operands_of(exprs, disjunct, false));
        const auto longest = std::ranges::max_element(parts, {}, &std::vector<Signed>::size);
        Bdd others;
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (parts.begin() + static_cast<std::ptrdiff_t>(i) != longest) others |= value(disjuncts[i]);
        for (const Signed& part : *longest) found.push_back(others | value(part));
    }
    return found;
}

Bdd together(std::vector<Bdd> operands) {  // conjoins adjacent pairs, so that the operands have similar sizes
    if (operands.empty()) return Bdd::constant(true);
    for (; operands.size() > 1; operands.resize((operands.size() + 1) / 2))
        for (std::size_t i = 0; i < operands.size(); i += 2)
            operands[i / 2] = i + 1 < operands.size() ? operands[i] & operands[i + 1] : operands[i];
    return operands.front();
}

}  // namespace

StateSpace::StateSpace(const FlatSystem& flat, BddSpace& space, bool by_kind)
    : flat_(flat), space_(space), by_kind_(by_kind) {
    add_words();
    BddTerms all = terms();
    constrain(all);
    add_next_bits(all);
    steps_ = steps_where(Bdd::constant(true));
}

BddTerms StateSpace::terms() const {
    return {flat_.exprs,
            [this](const Expr& leaf) { return term_of(space_, words_[static_cast<std::size_t>(leaf.value)]); }};
}

void StateSpace::add_words() {
    words_.resize(flat_.variables.size());
    std::vector<std::uint32_t> free;
    for (const Id<Variable> id : variable_order(flat_)) {
        const Variable& variable = flat_.variables[id];
        const bool paired = !variable.choice && variable.next.has_value();
        const std::size_t bits = bit_count(variable.type);
        const std::uint32_t first = space_.add_variables(paired ? 2 * bits : bits);
        BddWord& word = words_[id.index];
        word.type = variable.type;
        for (std::uint32_t bit = 0; bit < bits; ++bit) {
            const std::uint32_t before = paired ? first + 2 * bit : first + bit;
            word.bits.push_back(before);
            (variable.choice ? choice_bits_ : state_bits_).push_back(before);
            if (!paired && !variable.choice) free.push_back(before);
        }
    }
    choices_ = variable_set(space_, choice_bits_);
    free_ = variable_set(space_, free);
}

void StateSpace::constrain(BddTerms& terms) {
    const auto all_of = [&](const std::vector<Id<Expr>>& conditions, bool choice) {
        std::vector<Bdd> list;
        for (const Id<Expr> term : conditions)
            std::ranges::move(conjuncts(flat_.exprs, terms, term), std::back_inserter(list));
        for (const Id<Variable> id : flat_.variables.ids())
            if (flat_.variables[id].choice == choice) list.push_back(in_range(space_, words_[id.index]));
        return list;
    };
    invariant_ = together(all_of(flat_.invariants, false));
    offered_ = all_of(flat_.transitions, true);
    std::vector<Bdd> initial{invariant_};
    for (const Id<Variable> id : flat_.variables.ids())
        if (const auto& term = flat_.variables[id].initial)
            initial.push_back(equal(term_of(space_, words_[id.index]), terms(*term)));
    initial_ = together(std::move(initial));
}

void StateSpace::add_next_bits(BddTerms& terms) {
    for (const Id<Variable> id : flat_.variables.ids()) {
        const Variable& variable = flat_.variables[id];
        if (variable.choice || !variable.next) continue;
        const BddTerm& next = terms(*variable.next);
        const Bdd leak = ~within(next, variable.type.low, variable.type.high);
        if (!leak.is_false()) leaks_.push_back({id, leak});
        const std::vector<Bdd> bits = word_bits(next, variable.type);
        for (std::size_t place = 0; place < bits.size(); ++place)
            next_bits_.push_back({words_[id.index].bits[place], bits[place]});
    }
}

/// If the system has free inputs, all steps form one cluster. Reason: the steps of a cluster must leave all other bits
/// unchanged, but a free input may change in every step.
std::deque<bdd::ClusterSteps> StateSpace::steps_where(const Bdd& condition,
                                                      const std::vector<std::uint32_t>& kept) const {
    EventCluster all{offered_, next_bits_};
    all.conditions.push_back(condition);
    const auto is_kept = [&](std::uint32_t bit) { return std::ranges::find(kept, bit) != kept.end(); };
    std::vector<std::uint32_t> eliminated = choice_bits_;
    std::erase_if(eliminated, is_kept);
    std::vector<EventCluster> found;
    if (by_kind_ && free_.is_true()) {
        std::vector<BddWord> choices;
        for (const Id<Variable> id : flat_.variables.ids())
            if (flat_.variables[id].choice && std::ranges::none_of(words_[id.index].bits, is_kept))
                choices.push_back(words_[id.index]);
        found = kinds(space_, all, choices);
    }
    if (found.empty()) found.push_back(std::move(all));
    std::deque<bdd::ClusterSteps> steps;
    for (EventCluster& kind : found)
        steps.emplace_back(space_, std::move(kind.bits), std::move(kind.conditions), eliminated, support(free_));
    return steps;
}

Bdd StateSpace::image(const Bdd& states, const std::deque<bdd::ClusterSteps>& steps) const {
    Bdd result;
    for (const bdd::ClusterSteps& kind : steps) result |= kind.relation.image(states, kind.quantified);
    return result & invariant_;
}

Bdd StateSpace::preimage(const Bdd& states, const std::deque<bdd::ClusterSteps>& steps) const {
    const Bdd to = exists(states & invariant_, free_);
    Bdd result;
    for (const bdd::ClusterSteps& kind : steps) result |= kind.relation.preimage(to);
    return result & invariant_;
}

Bdd StateSpace::still() const {
    Bdd result;
    for (const bdd::ClusterSteps& kind : steps_)
        if (kind.relation.bits().empty()) result |= kind.relation.preimage(Bdd::constant(true));
    return result & invariant_;
}

Bdd StateSpace::closure(const Bdd& states) const { return bdd::Saturation(space_, steps_).closure(states); }

std::optional<StateSpace::Leak> StateSpace::leak(const Bdd& states) const {
    for (const Leak& each : leaks_) {
        Bdd leaking = each.states & states;
        for (const Bdd& condition : offered_) leaking &= condition;
        const Bdd found = exists(leaking, choices_);
        if (!found.is_false()) return Leak{each.variable, found};
    }
    return {};
}

State StateSpace::pick(const Bdd& states, const State& near) const {
    State state(near);
    state.resize(space_.variables());
    for (Bdd rest = states; !rest.is_constant();) {
        const std::uint32_t bit = rest.top();
        if ((state[bit] ? rest.high() : rest.low()).is_false()) state[bit] = !state[bit];
        rest = state[bit] ? rest.high() : rest.low();
    }
    return state;
}

Bdd StateSpace::only(const State& state) const {
    std::vector<BddLiteral> literals;
    for (const std::uint32_t bit : state_bits_) literals.push_back({bit, state[bit]});
    return cube(space_, literals);
}

State StateSpace::state_of(const std::vector<std::int64_t>& values) const {
    State state(space_.variables());
    for (std::size_t word = 0; word < words_.size(); ++word) {
        const Type type = words_[word].type;
        const auto offset = static_cast<std::uint64_t>(values[word] - (type.boolean ? 0 : type.low));
        for (std::size_t place = 0; place < words_[word].bits.size(); ++place)
            state[words_[word].bits[place]] = ((offset >> place) & 1U) != 0;
    }
    return state;
}

std::vector<std::int64_t> StateSpace::values(const State& state, const State* next, const Bdd& condition) const {
    State all = state;
    const Bdd here = only(state);
    Bdd chosen = cofactor(condition, here);
    for (const Bdd& each : offered_) chosen &= cofactor(each, here);
    for (const bdd::NextBit& bit : next_bits_) {
        if (next == nullptr) break;
        const Bdd value = cofactor(bit.value, here);
        chosen &= (*next)[bit.before] ? value : ~value;
    }
    for (const BddLiteral& literal : one_cube(chosen).value_or(std::vector<BddLiteral>{}))
        all[literal.variable] = literal.value;
    std::vector<std::int64_t> values;
    for (const BddWord& word : words_) values.push_back(value_of(word, all));
    return values;
}

}  // namespace grafverif::symbolic
