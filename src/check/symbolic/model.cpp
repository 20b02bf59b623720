// SPDX-License-Identifier: MIT
#include "check/symbolic/model.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "ir/flat_system.hpp"
#include "support/force.hpp"

namespace grafverif::symbolic {

namespace {

// A static order of the variables of a system for decision diagrams: variables that one term reads together stand near
// each other.
// FORCE with a hyperedge for each operator with its operands, and for each variable with its next value. Terms take part
// as members of their own, so a wide disjunction does not weld all that it reads into one block.

class Edges {
public:
    explicit Edges(const FlatSystem& flat) : flat_(flat), variables_(flat.variables.size()) {
        vertex_.assign(flat.exprs.size(), none);
        for (const FlatSystem::Variable& variable : flat.variables)
            for (const auto& term : {variable.initial, variable.next})
                if (term) add(*term);
        for (const auto* terms : {&flat.invariants, &flat.transitions})
            for (const Id<Expr> term : *terms) add(term);
        for (const Id<FlatSystem::Variable> id : flat.variables.ids())
            if (const auto& next = flat.variables[id].next; next && !is_constant(flat.exprs[*next].op))
                edges_.push_back({id.index, vertex_[next->index]});
    }

    std::vector<Id<FlatSystem::Variable>> order() {
        const std::vector<double> best = force_places(vertices_, edges_);
        std::vector<Id<FlatSystem::Variable>> result;
        for (const Id<FlatSystem::Variable> id : flat_.variables.ids()) result.push_back(id);
        std::ranges::stable_sort(result, {}, [&](Id<FlatSystem::Variable> id) { return best[id.index]; });
        return result;
    }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    /// A vertex for each term below `root`, a hyperedge for each operator. Variables are the first vertices.
    void add(Id<Expr> root) {
        std::vector<Id<Expr>> open{root};
        while (!open.empty()) {
            const Id<Expr> term = open.back();
            open.pop_back();
            const Expr& node = flat_.exprs[term];
            if (is_constant(node.op) || vertex_[term.index] != none) continue;
            vertex_[term.index] = node.op == Op::Variable ? static_cast<std::uint32_t>(node.value)
                                                          : static_cast<std::uint32_t>(vertices_++);
            for (const Id<Expr> operand : flat_.exprs.operands(term)) open.push_back(operand);
            if (node.op != Op::Variable) operators_.push_back(term);
        }
        for (; !operators_.empty(); operators_.pop_back()) {
            std::vector<std::uint32_t> edge{vertex_[operators_.back().index]};
            for (const Id<Expr> operand : flat_.exprs.operands(operators_.back()))
                if (vertex_[operand.index] != none) edge.push_back(vertex_[operand.index]);
            edges_.push_back(std::move(edge));
        }
    }

    const FlatSystem& flat_;
    std::size_t variables_ = 0;
    std::size_t vertices_ = variables_;
    std::vector<std::uint32_t> vertex_ = {};  ///< per term
    std::vector<Id<Expr>> operators_ = {};
    std::vector<ForceEdge> edges_ = {};
};

/// Every variable once, the topmost first.
std::vector<Id<FlatSystem::Variable>> variable_order(const FlatSystem& flat) { return Edges(flat).order(); }

using Variable = FlatSystem::Variable;

Bdd together(std::vector<Bdd> operands) {  // in pairs, so that no operand is much larger than its partner
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
        for (std::size_t place = 0; place < bits.size(); ++place)
            next_bits.push_back({words_[id.index].bits[place], bits[place]});
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
