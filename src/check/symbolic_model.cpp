// SPDX-License-Identifier: MIT
#include "check/symbolic_model.hpp"

#include <utility>

#include "check/variable_order.hpp"

namespace grafverif::symbolic {

namespace {

using Variable = FlatSystem::Variable;

Bdd together(std::vector<Bdd> operands) {   // in pairs, so that no operand is much larger than its partner
    if (operands.empty()) return Bdd::constant(true);
    for (; operands.size() > 1; operands.resize((operands.size() + 1) / 2))
        for (std::size_t i = 0; i < operands.size(); i += 2)
            operands[i / 2] = i + 1 < operands.size() ? operands[i] & operands[i + 1] : operands[i];
    return operands.front();
}

}  // namespace

StateSpace::StateSpace(const FlatSystem& flat, BddSpace& space) : flat_(flat), space_(space) {
    add_words();
    BddTerms all = terms();
    constrain(all);
    add_steps(all);
}

BddTerms StateSpace::terms() const {
    return {flat_.exprs, [this](const Expr& leaf) { return term_of(space_, words_[static_cast<std::size_t>(leaf.value)]); }};
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
        for (const Id<Expr> term : conditions) list.push_back(equal(terms(term), bdd_boolean(Bdd::constant(true))));
        for (const Id<Variable> id : flat_.variables.ids())
            if (flat_.variables[id].choice == choice) list.push_back(in_range(space_, words_[id.index]));
        return together(std::move(list));
    };
    invariant_ = all_of(flat_.invariants, false);
    offered_ = all_of(flat_.transitions, true);
    std::vector<Bdd> initial{invariant_};
    for (const Id<Variable> id : flat_.variables.ids())
        if (const auto& term = flat_.variables[id].initial)
            initial.push_back(equal(term_of(space_, words_[id.index]), terms(*term)));
    initial_ = together(std::move(initial));
}

void StateSpace::add_steps(BddTerms& terms) {
    std::vector<bdd::NextBit> next_bits;
    for (const Id<Variable> id : flat_.variables.ids()) {
        const Variable& variable = flat_.variables[id];
        if (variable.choice || !variable.next) continue;
        const BddTerm& next = terms(*variable.next);
        const Bdd leak = ~within(next, variable.type.low, variable.type.high);
        if (!leak.is_false()) leaks_.push_back({id, leak});
        const std::vector<Bdd> bits = word_bits(next, variable.type);
        for (std::size_t place = 0; place < bits.size(); ++place) next_bits.push_back({words_[id.index].bits[place], bits[place]});
    }
    relation_.emplace(space_, std::move(next_bits), offered_);
    std::vector<std::uint32_t> gone = state_bits_;
    gone.insert(gone.end(), choice_bits_.begin(), choice_bits_.end());
    stepped_ = relation_->quantified(gone);
}

Bdd StateSpace::image(const Bdd& states) const { return relation_->image(states, stepped_) & invariant_; }

Bdd StateSpace::preimage(const Bdd& states) const {
    return exists(relation_->preimage(exists(states & invariant_, free_)), choices_) & invariant_;
}

std::optional<StateSpace::Leak> StateSpace::leak(const Bdd& states) const {
    for (const Leak& each : leaks_) {
        const Bdd found = states & exists(each.states & offered_, choices_);
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

std::vector<std::int64_t> StateSpace::values(const State& state, const State* next) const {
    State all = state;
    const Bdd here = only(state);
    Bdd chosen = cofactor(offered_, here);
    for (const bdd::NextBit& bit : relation_->bits()) {
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
