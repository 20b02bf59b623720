// SPDX-License-Identifier: MIT
#include "analyse/machine.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "analyse/order.hpp"
#include "ir/junction.hpp"

namespace grafverif::analysis {

namespace {

using Role = Equations::Role;
using Variable = Equations::Variable;

Bdd falsehood() { return Bdd::constant(false); }

/// Returns the points at which `term` has a value outside `type`. Points at which `term` is undefined are not included.
Bdd outside(const BddTerm& term, Type type) {
    return type.boolean ? falsehood() : ~within(term, type.low, type.high) & ~term.undefined;
}

BddTerm constant_term(Type type, std::int64_t value) {
    return type.boolean ? bdd_boolean(Bdd::constant(value != 0)) : bdd_integer(value);
}

/// Returns the points at which `term` has a value other than `value`.
Bdd unequal(const BddTerm& term, std::int64_t value) { return ~equals(term, value) & ~term.undefined; }

/// Returns the minimum of `term` and `most`.
BddTerm at_most(const BddTerm& term, std::int64_t most) {
    const Bdd more = ~within(term, std::numeric_limits<std::int64_t>::min(), most) & ~term.undefined;
    return conditional(bdd_boolean(more), bdd_integer(most), term);
}

}  // namespace

Machine::Machine(const Equations& equations, const AnalyseOptions& options, const Cone& cone, BddSpace& space)
    : equations_(equations),
      space_(space),
      cone_(cone),
      whole_(std::ranges::find(cone, false) == cone.end()),
      clocks_(equations.timers) {
    std::erase_if(clocks_, [&](const Equations::Timer& clock) { return !cone_[clock.end.index]; });
    search_inside();
    choose_counters(options);
    add_words(options);
    terms_.emplace(equations.exprs, [this](const Expr& leaf) { return before(leaf); });
    first_terms_.emplace(equations.exprs, [this](const Expr& leaf) { return initially(leaf); });
    restrict_inputs(options);
    add_firings();
    add_steps();
    add_stored();
    add_unwritten();
    add_remembered();
    add_timers();
    add_stability();
    relate();
    start();
}

// -- the cone ---------------------------------------------------------------------------------------------------------

/// Determines the terms that read only variables of the cone. Two passes are sufficient, because a firing condition
/// does not read other firing conditions.
void Machine::search_inside() {
    std::vector<bool> known(cone_);
    for (const Equations::Firing& firing : equations_.firings) known[firing.variable.index] = false;
    for (int pass = 0; pass < 2; ++pass) {
        inside_.assign(equations_.exprs.size(), true);
        for (std::uint32_t term = 0; term < inside_.size(); ++term) {
            const Expr& node = equations_.exprs[Id<Expr>{term}];
            if (node.op == Op::Variable) inside_[term] = known[static_cast<std::size_t>(node.value)];
            for (const Id<Expr> operand : equations_.exprs.operands(node))
                if (!inside_[operand.index]) inside_[term] = false;
        }
        for (const Equations::Firing& firing : equations_.firings)
            known[firing.variable.index] = inside_[firing.condition.index];
    }
}

void Machine::choose_counters(const AnalyseOptions& options) {
    counters_ = counters(equations_);
    exact_evolutions_ = std::numeric_limits<std::int64_t>::max();
    for (std::size_t variable = 0; variable < counters_.size(); ++variable) {
        std::optional<Counter>& counter = counters_[variable];
        if (!counter || !cone_[variable]) continue;
        if (counter->safe < options.longest_count) counter.reset();
        else exact_evolutions_ = std::min(exact_evolutions_, counter->safe);
    }
}

// -- variables --------------------------------------------------------------------------------------------------------

void Machine::add_words(const AnalyseOptions& options) {
    matters_ = variables_that_matter(equations_);
    for (std::size_t variable = 0; variable < matters_.size(); ++variable)
        if (!cone_[variable]) matters_[variable] = false;
    for (const Exclusion& exclusion : options.exclusions)
        for (const Id<Chart::Variable> input : {exclusion.first, exclusion.second}) matters_[input.index] = true;
    for (const Equations::Assumption& assumption : equations_.assumptions)
        for (const Id<Expr> leaf : leaves(equations_.exprs, assumption.condition))
            matters_[static_cast<std::size_t>(equations_.exprs[leaf].value)] = true;
    for (const Equations::ObservedTerm& watch : equations_.watches)
        remembers_ = remembers_ || matters_[watch.variable.index];
    for (const Equations::Previous& previous : equations_.previous)
        remembers_ = remembers_ || matters_[previous.variable.index];
    words_.resize(equations_.variables.size());
    firing_of_.resize(equations_.variables.size());
    const std::vector<std::uint32_t> group = integer_groups(equations_);
    std::vector<Id<Variable>> together;
    for (const Id<Variable> id : variable_order(equations_, matters_)) {
        if (!together.empty() && group[together.front().index] != group[id.index])
            add_word_bits(std::exchange(together, {}));
        together.push_back(id);
    }
    add_word_bits(together);
    inputs_ = variable_set(space_, input_bits_);
}

/// Adds the bits of several variables in interleaved order, so that bits of equal significance, which are compared or
/// added, are adjacent.
void Machine::add_word_bits(const std::vector<Id<Variable>>& together) {
    std::size_t most = 0;
    for (const Id<Variable> id : together) {
        words_[id.index].type = counters_[id.index] ? counters_[id.index]->type : equations_.variables[id].type;
        most = std::max(most, bit_count(words_[id.index].type));
    }
    for (std::size_t bit = 0; bit < most; ++bit)
        for (const Id<Variable> id : together) {
            if (bit >= bit_count(words_[id.index].type)) continue;
            const bool input = equations_.variables[id].role == Role::Input;
            const std::uint32_t place = space_.add_variables(input ? 1 : 2);
            words_[id.index].bits.push_back(place);
            (input ? input_bits_ : kept_bits_).push_back(place);
        }
}

BddTerm Machine::word_term(Id<Variable> variable) const { return term_of(space_, words_[variable.index]); }

BddTerm Machine::before(const Expr& leaf) const {
    const Id<Variable> id{static_cast<std::uint32_t>(leaf.value)};
    const Variable& variable = equations_.variables[id];
    if (variable.role == Role::FiringCondition) return bdd_boolean(fires_[*firing_of_[id.index]]);
    if (!matters_[id.index]) return constant_term(variable.type, variable.initial);
    return word_term(id);
}

/// Returns the value of a leaf in the first evolution, in which no transition is cleared and no timer has expired.
BddTerm Machine::initially(const Expr& leaf) const {
    const Id<Variable> id{static_cast<std::uint32_t>(leaf.value)};
    const Variable& variable = equations_.variables[id];
    if (variable.role == Role::Input) return before(leaf);
    return constant_term(variable.type, variable.role == Role::FiringCondition ? 0 : variable.initial);
}

void Machine::restrict_inputs(const AnalyseOptions& options) {
    possible_ = Bdd::constant(true);
    for (const Id<Variable> id : equations_.variables.ids())
        if (matters_[id.index] && equations_.variables[id].role == Role::Input)
            possible_ &= in_range(space_, words_[id.index]);
    for (const Equations::Assumption& assumption : equations_.assumptions) possible_ &= holds(assumption.condition);
    for (const Exclusion& exclusion : options.exclusions)
        possible_ &= ~(word_term({exclusion.first.index}).bits[0] & word_term({exclusion.second.index}).bits[0]);
}

// -- one evolution ----------------------------------------------------------------------------------------------------

void Machine::add_break(FaultCondition found) {
    const Bdd later = found.race | found.out_of_range | found.no_value;
    const Bdd first = found.first_race | found.first_out_of_range | found.first_no_value;
    if (!later.is_false()) sound_.push_back(~later);
    breaks_at_first_ |= first;
    if (!later.is_false() || !first.is_false() || !found.beyond.is_false()) all_breaks_.push_back(std::move(found));
}

void Machine::keep(Next next) {
    const BddWord& word = words_[next.variable.index];
    const std::vector<Bdd> later = word_bits(next.value, word.type), first = word_bits(next.first, word.type);
    for (std::size_t bit = 0; bit < word.bits.size(); ++bit) kept_.push_back({word.bits[bit], later[bit], first[bit]});
    nexts_.push_back(std::move(next));
}

void Machine::add_firings() {
    FaultCondition found;
    for (std::size_t k = 0; k < equations_.firings.size(); ++k) {
        const Equations::Firing& firing = equations_.firings[k];
        fires_.emplace_back();
        if (!covers_firing(k)) continue;
        const BddTerm& term = (*terms_)(firing.condition);
        found.no_value |= term.undefined;
        fires_.back() = term.bits.front() & ~term.undefined;
        firing_of_[firing.variable.index] = k;
    }
    add_break(std::move(found));
}

void Machine::add_steps() {
    for (const Equations::StepActivity& step : equations_.steps) {
        value_of_step_.emplace_back();
        if (!covers(step.variable)) continue;
        value_of_step_.back() = word_term(step.variable).bits.front();
        const BddTerm initial = constant_term({}, equations_.variables[step.variable].initial);
        keep({step.variable, (*terms_)(step.next), initial});
    }
    for (const Equations::Conflict& conflict : equations_.conflicts) {
        conflicts_.emplace_back();
        if (!covers(conflict.condition)) continue;
        conflicts_.back() = holds(conflict.condition);
        if (!conflicts_.back().is_false()) sound_.push_back(~conflicts_.back());
    }
}

void Machine::add_stored() {
    Bdd obeyed = Bdd::constant(true);
    for (const Bdd& conflict : conflicts_) obeyed &= ~conflict;
    for (const Equations::Stored& stored : equations_.stored) {
        if (!covers(stored.variable)) continue;
        add_break(break_of(stored, obeyed));
        if (!matters_[stored.variable.index]) continue;
        const std::optional<Counter>& counter = counters_[stored.variable.index];
        const BddTerm& next = (*terms_)(stored.next);
        keep({stored.variable, counter ? at_most(next, counter->type.high) : next, (*first_terms_)(stored.first)});
    }
}

/// Returns the conditions for faults in the new value of a stored variable. At points outside of `obeyed`, two forcing
/// orders conflict, so that the evolution is undefined; no further fault is reported for such an evolution.
Machine::FaultCondition Machine::break_of(const Equations::Stored& stored, const Bdd& obeyed) {
    const Type type = equations_.variables[stored.variable].type;
    const std::optional<Counter>& counter = counters_[stored.variable.index];
    const BddTerm &race = (*terms_)(stored.race), &first_race = (*first_terms_)(stored.first_race);
    FaultCondition found{stored.variable};
    found.race = race.bits.front() & ~race.undefined & obeyed;
    found.first_race = first_race.bits.front() & ~first_race.undefined;
    found.no_value = race.undefined;
    found.first_no_value = (*first_terms_)(stored.first).undefined | first_race.undefined;
    for (const Equations::Write& write : stored.writes) {
        if (is_constant(equations_.exprs[write.value].op) && type.boolean) continue;
        if (write.initial) {
            const BddTerm& value = (*first_terms_)(write.value);
            found.first_no_value |= value.undefined;
            found.first_out_of_range |= outside(value, type);
        }
        const BddTerm& value = (*terms_)(write.value);
        const Bdd trigger = holds(write.trigger), beyond = outside(value, type);
        found.no_value |= trigger & value.undefined;
        found.out_of_range |= trigger & beyond & obeyed;
        if (counter) found.beyond |= trigger & outside(value, counter->type) & ~beyond & obeyed;
    }
    if (counter) found.safe = counter->safe;
    return found;
}

/// Adds the variables that are never written, which keep their values.
void Machine::add_unwritten() {
    for (const Id<Variable> id : equations_.variables.ids()) {
        const Variable& variable = equations_.variables[id];
        if (!matters_[id.index] || (variable.role != Role::Internal && variable.role != Role::Output)) continue;
        if (std::ranges::find(equations_.stored, id, &Equations::Stored::variable) != equations_.stored.end()) continue;
        const BddTerm initial = constant_term(variable.type, variable.initial);
        keep({id, initial, initial});
    }
}

/// Adds the remembered values (previous values of terms, and watched levels), which depend on the new values of steps
/// and stored variables.
void Machine::add_remembered() {
    std::vector<const Next*> next(equations_.variables.size());
    const auto after = [&](bool first) {
        return [this, &next, first](const Expr& leaf) {
            const auto index = static_cast<std::size_t>(leaf.value);
            if (next[index] == nullptr) return first ? initially(leaf) : before(leaf);
            return first ? next[index]->first : next[index]->value;
        };
    };
    for (const Next& each : nexts_) next[each.variable.index] = &each;
    BddTerms later(equations_.exprs, after(false)), at_first(equations_.exprs, after(true));
    std::vector<Next> found;
    for (const Kept& each : remembered(equations_)) {
        if (!matters_[each.variable.index] || !covers(each.next)) continue;
        BddTerms& terms = each.after ? later : *terms_;
        BddTerms& firsts = each.after ? at_first : *first_terms_;
        const BddTerm &value = terms(each.next), &first = firsts(each.next);
        FaultCondition undefined;
        undefined.no_value = value.undefined;
        undefined.first_no_value = first.undefined;
        add_break(std::move(undefined));
        found.push_back({each.variable, bdd_boolean(value.bits.front()), bdd_boolean(first.bits.front())});
    }
    for (Next& each : found) keep(std::move(each));
}

/// Adds the next values of timer outputs. No time passes during an evolution. A timer output remains true while its
/// watched level is true; the output of a timer with a fall time may remain true longer. The output of a timer without
/// a rise time becomes true immediately.
void Machine::add_timers() {
    for (const Equations::Timer& clock : clocks_) {
        if (!matters_[clock.end.index]) continue;
        const auto watched = std::ranges::find(nexts_, clock.watched, [](const Next& next) { return next.variable; });
        const Bdd end = word_term(clock.end).bits.front();
        const Bdd level = watched->value.bits.front(), first = watched->first.bits.front();
        Next next{clock.end, bdd_boolean(end), bdd_boolean(falsehood())};
        if (clock.fall_ms == 0) next.value = bdd_boolean(end & level);
        if (clock.rise_ms == 0) next = {clock.end, bdd_boolean(end | level), bdd_boolean(first)};
        keep(std::move(next));
    }
}

/// Adds the conditions of stability: no transition of the cone is cleared, and no other change occurs in the cone that
/// the stability condition of the equations excludes.
void Machine::add_stability() {
    for (std::size_t k = 0; k < fires_.size(); ++k)
        if (!fires_[k].is_false()) calm_.push_back(~fires_[k]);
    const Exprs& exprs = equations_.exprs;
    if (exprs[equations_.stable].op != Op::Not) return;
    for (const Id<Expr> change : operands_of(exprs, exprs.operands(equations_.stable)[0], Op::Or)) {
        if (exprs[change].op == Op::Variable || (!whole_ && !inside_[change.index])) continue;
        const BddTerm& occurs = (*terms_)(change);
        calm_.push_back(~occurs.bits.front() & ~occurs.undefined);
    }
}

void Machine::relate() {
    std::vector<bdd::NextBit> bits;
    for (const KeptBit& bit : kept_) bits.push_back({bit.before, bit.next});
    relation_.emplace(space_, std::move(bits));
    kept_quantified_ = relation_->quantified(kept_bits_);
    std::vector<std::uint32_t> all = kept_bits_;
    all.insert(all.end(), input_bits_.begin(), input_bits_.end());
    all_quantified_ = relation_->quantified(all);
}

void Machine::start() {
    started_ = possible_ & ~breaks_at_first_;
    breaks_at_first_ &= possible_;
    for (const KeptBit& bit : kept_) started_ &= iff(space_.variable(bit.before), bit.first);
}

Bdd Machine::stable(const Bdd& points) const {
    Bdd result = points;
    for (const Bdd& each : calm_) result &= each;
    return result;
}

Bdd Machine::unbroken(const Bdd& points) const {
    Bdd result = points;
    for (const Bdd& each : sound_) result &= each;
    return result;
}

Bdd Machine::transient(const Bdd& points) const {
    const Bdd good = unbroken(points);
    return good & ~stable(good);
}

Bdd Machine::followed(const Bdd& points) const {
    Bdd result = points;
    for (const FaultCondition& each : all_breaks_)
        if (!each.beyond.is_false()) result &= ~each.beyond;
    return result;
}

Bdd Machine::evolved(const Bdd& points) const { return relation_->image(points, kept_quantified_); }

Bdd Machine::evolved_rest(const Bdd& points) const { return relation_->image(points, all_quantified_); }

Bdd Machine::origins(const Bdd& points, const Point& next) const {
    Bdd result = points;
    for (const KeptBit& bit : kept_) result &= next[bit.before] ? bit.next : ~bit.next;
    return result;
}

Bdd Machine::with_inputs_of(const Bdd& points, const Point& other) const {
    std::vector<BddLiteral> inputs;
    for (const std::uint32_t bit : support(inputs_)) inputs.push_back({bit, other[bit]});
    return points & cube(space_, inputs);
}

// -- time -------------------------------------------------------------------------------------------------------------

/// Removes points with impossible timer outputs: among clocks without a fall time that watch the same variable, clocks
/// with shorter times expire first.
Bdd Machine::allowed_ends(const Bdd& points) const {
    Bdd result = points;
    for (const Equations::Timer& longer : clocks_)
        for (const Equations::Timer& shorter : clocks_) {
            const bool ordered = longer.watched == shorter.watched && longer.fall_ms == 0 && shorter.fall_ms == 0 &&
                                 longer.rise_ms > shorter.rise_ms;
            if (!ordered || !matters_[longer.end.index] || !matters_[shorter.end.index]) continue;
            result &= implies(word_term(longer.end).bits.front(), word_term(shorter.end).bits.front());
        }
    return result;
}

/// Returns the points after some time has passed and inputs have been sampled. While time passes,
/// the variable that a clock watches is constant. The output of the clock becomes true only if the
/// variable is true, and false only if the variable is false. If a clock has both a rise time and a
/// fall time, its output may still be true because of an earlier rise; the output may become false
/// before the current rise time has elapsed.
Bdd Machine::sampled(const Bdd& rest) const {
    Bdd result = rest;
    for (const Equations::Timer& clock : clocks_) {
        if (!matters_[clock.end.index]) continue;
        const std::uint32_t bit = words_[clock.end.index].bits.front();
        const Bdd end = space_.variable(bit), level = word_term(clock.watched).bits.front();
        const Bdd was_false = cofactor(result, ~end), was_true = cofactor(result, end);
        const Bdd may_end = clock.fall_ms == 0 ? falsehood() : clock.rise_ms == 0 ? ~level : Bdd::constant(true);
        result = ite(end, was_true | (was_false & level), was_false | (was_true & may_end));
    }
    return allowed_ends(result) & possible_;
}

Bdd Machine::before_time(const Bdd& points) const {
    Bdd result = rest(points & possible_);
    for (const Equations::Timer& clock : clocks_) {
        if (!matters_[clock.end.index]) continue;
        const std::uint32_t bit = words_[clock.end.index].bits.front();
        const Bdd end = space_.variable(bit), level = word_term(clock.watched).bits.front();
        const Bdd to_false = cofactor(result, ~end), to_true = cofactor(result, end);
        const Bdd may_end = clock.fall_ms == 0 ? falsehood() : clock.rise_ms == 0 ? ~level : Bdd::constant(true);
        result = ite(end, to_true | (to_false & may_end), to_false | (to_true & level));
    }
    return result;
}

Bdd Machine::without_ends(const Bdd& points) const {
    std::vector<std::uint32_t> ends;
    for (const Equations::Timer& clock : clocks_)
        if (matters_[clock.end.index]) ends.push_back(words_[clock.end.index].bits.front());
    return exists(points, variable_set(space_, ends));
}

Bdd Machine::origins_in_time(const Bdd& rest, const Point& next) const {
    std::vector<BddLiteral> same;
    for (const KeptBit& bit : kept_) same.push_back({bit.before, next[bit.before]});
    Bdd result = rest;
    for (const Equations::Timer& clock : clocks_) {
        if (!matters_[clock.end.index]) continue;
        const std::uint32_t bit = words_[clock.end.index].bits.front();
        std::erase_if(same, [bit](const BddLiteral& literal) { return literal.variable == bit; });
        const Bdd end = space_.variable(bit), level = word_term(clock.watched).bits.front();
        const Bdd may_end = clock.fall_ms == 0 ? falsehood() : clock.rise_ms == 0 ? ~level : Bdd::constant(true);
        result &= next[bit] ? end | level : ~end | may_end;
    }
    return result & cube(space_, same);
}

// -- conditions -------------------------------------------------------------------------------------------------------

Bdd Machine::holds(Id<Expr> term) {
    const BddTerm& found = (*terms_)(term);
    return found.bits.front() & ~found.undefined;
}

Bdd Machine::differs(Id<Expr> term, std::int64_t value) { return unequal((*terms_)(term), value); }

Bdd Machine::differs_at_first(Id<Expr> term, std::int64_t value) { return unequal((*first_terms_)(term), value); }

Bdd Machine::changes(Id<Variable> variable) const {
    Bdd result;
    const std::vector<std::uint32_t>& bits = words_[variable.index].bits;
    for (const KeptBit& bit : kept_)
        if (std::ranges::find(bits, bit.before) != bits.end()) result |= bit.next ^ space_.variable(bit.before);
    for (const FaultCondition& each : all_breaks_)
        if (each.variable == variable) result |= each.beyond;
    return result;
}

// -- single points ----------------------------------------------------------------------------------------------------

Point Machine::pick(const Bdd& points) const {
    Point point(space_.variables());
    for (const BddLiteral& literal : one_cube(points).value_or(std::vector<BddLiteral>{}))
        point[literal.variable] = literal.value;
    return point;
}

Bdd Machine::only(const Point& point) const {
    std::vector<BddLiteral> literals;
    for (const BddWord& word : words_)
        for (const std::uint32_t bit : word.bits) literals.push_back({bit, point[bit]});
    return cube(space_, literals);
}

std::int64_t Machine::value(const Point& point, Id<Variable> variable) const {
    if (!matters_[variable.index])
        return equations_.variables[variable].type.boolean ? 0 : equations_.variables[variable].type.low;
    return value_of(words_[variable.index], point);
}

}  // namespace grafverif::analysis
