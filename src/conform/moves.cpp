// SPDX-License-Identifier: MIT
// The result of an evolution is computed by successive partitions of the inputs:
//
//   `classes`: In a state, the variables of the chart are constant, so the condition of each transition is a set of
//              inputs. These sets partition the inputs into classes. For all inputs of a class, the same set of
//              transitions fires (JESA13 (11) to (13)). Individual valuations of the inputs are never enumerated. Of
//              the 2^n sets of n transitions, only the sets that fire for some inputs are enumerated.
//   `parts`:   In a class, the firing conditions are also constant. Within a class, the next value of a variable is a
//              number or, rarely, a function of the inputs, whose values split the class into parts. Variables that do
//              not depend on the firing transitions (dependencies.hpp) are unchanged.
//   `stable`:  A part is split by the stability condition of the equations. In a stable part, only previous values
//              change.
//   `levels`:  The levels that timers observe are terms over the new values and the inputs. The values of these levels
//              split the parts again.
//
// Each step of the computation partitions the inputs. Therefore, the moves are disjoint and cover the initial set: the
// assumed inputs that are consistent with the known timer outputs. All steps read the state before the evolution, `at`,
// which is constant. If some input of a part has an undefined or out-of-range value, or a race, the search ends
// (NoResult): the chart has no location automaton.
#include "conform/moves.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <string>

#include "support/messages.hpp"

namespace grafverif::conform {

Moves::Moves(const Equations& equations, const InputOf& inputs, const InputSpace& space)
    : equations_(equations),
      inputs_(inputs),
      space_(space),
      terms_(equations, inputs, space),
      layout_(equations),
      dependencies_(dependencies(equations, layout_)),
      store_(layout_.words) {
    for (const Equations::Variable& variable : equations.variables) initial_.push_back(variable.initial);
}

Values Moves::values(StateId state) const {
    Values values = initial_;
    for (std::uint32_t field = 0; field < layout_.fields.size(); ++field)
        values[layout_.fields[field].kept.variable.index] = layout_.value(store_.at(state), field);
    return values;
}

const std::vector<StateMove>& Moves::of(StateId state) {
    while (known_.size() <= state) known_.emplace_back();
    if (!known_[state]) known_[state] = moves_of(state);
    return *known_[state];
}

namespace {

/// Restricts `moves` to inputs in `known`, and removes moves without remaining inputs.
std::vector<StateMove> supposing(const Bdd& known, std::vector<StateMove> moves) {
    if (known.is_true()) return moves;
    for (StateMove& move : moves) move.set = cofactor(move.set & known, known);
    std::erase_if(moves, [](const StateMove& move) { return move.set.is_false(); });
    return moves;
}

/// Sorts the moves so that the stable moves are first. Moves that lead to the same state by different sets of
/// transitions are merged.
std::vector<StateMove> merged(std::vector<StateMove> moves) {
    std::ranges::stable_partition(moves, &StateMove::stable);
    std::vector<StateMove> result;
    result.reserve(moves.size());
    for (StateMove& move : moves) {
        const auto same = std::ranges::find_if(
            result, [&](const StateMove& known) { return known.next == move.next && known.stable == move.stable; });
        if (same == result.end()) result.push_back(std::move(move));
        else same->set |= move.set;
    }
    return result;
}

}  // namespace

std::vector<StateMove> Moves::moves_of(StateId state) {
    const Values before = values(state);
    const Bdd known = known_ends(state, before);
    std::vector<StateMove> moves;
    // `at` contains the variables before the evolution and the firing conditions of the current class; one copy is used
    // for all classes.
    Values at = before;
    for (const Cell& cell : cells(before, space_.assumed() & known)) {
        for (const std::uint32_t firing : cell.fired) at[equations_.firings[firing].variable.index] = 1;
        check_races(cell, at);
        add_moves(cell, state, at, moves);
        for (const std::uint32_t firing : cell.fired) at[equations_.firings[firing].variable.index] = 0;
    }
    return merged(supposing(known, std::move(moves)));
}

// -- classes ----------------------------------------------------------------------------------------------------------

/// The classes of inputs for which some transition fires. The partition into classes is refined by one transition at a
/// time.
class Moves::Partition {
public:
    /// Refines the classes for transition `firing`, which fires for the inputs in `condition`.
    void cut(std::uint32_t firing, const Bdd& condition) {
        const Bdd alone = condition & ~touched_;
        if (!(alone == condition)) {  // other transitions also fire for some of these inputs
            const std::size_t count = cells_.size();
            for (std::size_t k = 0; k < count; ++k) {
                Bdd both = cells_[k].set & condition;
                if (both.is_false()) continue;
                if (both == cells_[k].set) {
                    cells_[k].fired.push_back(firing);
                    continue;
                }
                cells_[k].set &= ~condition;
                cells_.push_back({std::move(both), cells_[k].fired});
                cells_.back().fired.push_back(firing);
            }
        }
        if (!alone.is_false()) cells_.push_back({alone, {firing}});
        touched_ |= condition;
    }

    /// Returns all classes of `within`, beginning with the class in which no transition fires.
    std::vector<Cell> cells(const Bdd& within) && {
        Bdd quiet = within & ~touched_;
        if (!quiet.is_false()) cells_.insert(cells_.begin(), {std::move(quiet), {}});
        return std::move(cells_);
    }

private:
    std::vector<Cell> cells_ = {};
    Bdd touched_ = {};  ///< union of the classes
};

std::vector<Moves::Cell> Moves::cells(const Values& at, const Bdd& within) {
    Partition partition;
    const auto cut_by = [&](std::uint32_t firing) {
        const LocationCondition condition = terms_.condition(equations_.firings[firing].condition, at);
        demand_value(condition.undefined, within, equations_.firings[firing].origin, at);
        const Bdd fires = condition.holds & within;
        if (!fires.is_false()) partition.cut(firing, fires);
    };
    for (std::uint32_t field = 0; field < layout_.fields.size(); ++field)
        if (!dependencies_.guarded[field].empty() && at[layout_.fields[field].kept.variable.index] != 0)
            std::ranges::for_each(dependencies_.guarded[field], cut_by);
    std::ranges::for_each(dependencies_.unguarded, cut_by);
    return std::move(partition).cells(within);
}

// -- parts ------------------------------------------------------------------------------------------------------------

void Moves::add_moves(const Cell& cell, StateId state, const Values& at, std::vector<StateMove>& moves) {
    const bool unstable = dependencies_.firing_unsettles && !cell.fired.empty();
    const Bdd stable = unstable ? Bdd{} : terms_.condition(equations_.stable, at).holds;
    const auto add = [&](Region part, bool is_stable) {
        const auto add_piece = [&](Region& piece) {
            const StateId next = piece.changes.empty() ? state : changed(state, piece.changes, at);
            moves.push_back({std::move(piece.set), next, is_stable});
        };
        if (part.set.is_false()) return;
        if (equations_.watches.empty()) return add_piece(part);
        for (Region& piece : with_levels(std::move(part), at)) add_piece(piece);
    };
    for (Region& part : evolved(cell, at)) {
        if (!stable.is_false()) add({part.set & stable, part.changes}, true);
        if (!stable.is_true())
            add({stable.is_false() ? std::move(part.set) : part.set & ~stable, std::move(part.changes)}, false);
    }
}

std::vector<Moves::Region> Moves::evolved(const Cell& cell, const Values& at) {
    std::vector<Region> parts{{cell.set, {}}};
    const auto compute = [&](std::uint32_t field) {
        parts = given(std::move(parts), field, layout_.fields[field].kept.next, at);
    };
    std::ranges::for_each(dependencies_.fields.always, compute);
    for (const std::uint32_t firing : cell.fired)
        std::ranges::for_each(dependencies_.fields.by_firing[firing], compute);
    return parts;
}

namespace {

/// Returns the partition of `within` by the values of `term`, each part with its value.
std::vector<std::pair<Bdd, std::int64_t>> by_value(const BddTerm& term, const Bdd& within, const InputSpace& space) {
    std::vector<std::pair<Bdd, std::int64_t>> pieces;
    for (Bdd rest = within; !rest.is_false();) {
        const std::int64_t number = value_of(term, space.assignment(rest));
        const Bdd same = rest & equals(term, number);
        pieces.emplace_back(same, number);
        rest &= ~same;
    }
    return pieces;
}

}  // namespace

/// Records the new value of `field`, which is the value of `term`, in each region of `parts`. A region in which this
/// value depends on the inputs is split into one region per value.
std::vector<Moves::Region> Moves::given(std::vector<Region> parts, std::uint32_t field, Id<Expr> term,
                                        const Values& at) {
    const Equations::Variable& variable = equations_.variables[layout_.fields[field].kept.variable];
    const LocationValue found = terms_.value(term, at);
    const auto give = [&](Region& part, std::int64_t value) {
        if (value < variable.type.low || value > variable.type.high)
            throw NoResult{
                messages::out_of_range_in_location(variable.origin, variable.name, value, circumstances(at, part.set))};
        part.changes.emplace_back(field, value);
    };
    std::vector<Region> pieces;
    for (Region& part : parts) {
        if (!found.function) {
            demand_value(Bdd::constant(found.none), part.set, variable.origin, at);
            give(part, found.number);
            continue;
        }
        demand_value(found.function->undefined, part.set, variable.origin, at);
        for (const auto& [set, value] : by_value(*found.function, part.set, space_)) {
            pieces.push_back({set, part.changes});
            give(pieces.back(), value);
        }
    }
    return found.function ? std::move(pieces) : std::move(parts);
}

/// Splits a part by the new values of the levels (Boolean terms) that timers observe.
std::vector<Moves::Region> Moves::with_levels(Region part, const Values& at) {
    std::vector<Region> parts;
    parts.push_back(std::move(part));
    for (std::size_t k = 0; k < equations_.watches.size(); ++k) {
        const Equations::ObservedTerm& watch = equations_.watches[k];
        const auto field = static_cast<std::uint32_t>(layout_.evolving + k);
        std::vector<Region> pieces;
        for (const Region& one : parts) {
            Values after = at;
            for (const auto& [changed, value] : one.changes) after[layout_.fields[changed].kept.variable.index] = value;
            const LocationCondition level = terms_.condition(watch.value, after);
            demand_value(level.undefined, one.set, watch.origin, at);
            for (const bool value : {false, true}) {
                Region piece{one.set & (value ? level.holds : ~level.holds), one.changes};
                if (piece.set.is_false()) continue;
                if ((at[watch.variable.index] != 0) != value) piece.changes.emplace_back(field, value);
                pieces.push_back(std::move(piece));
            }
        }
        parts = std::move(pieces);
    }
    return parts;
}

// -- states -----------------------------------------------------------------------------------------------------------

/// Returns `state` after the changes. Timers are marked according to the changes of their levels. `before` contains the
/// old values of the levels.
StateId Moves::changed(StateId state, const Changes& changes, const Values& before) {
    const std::span<const std::uint64_t> old = store_.at(state);
    PackedState now(old.begin(), old.end());
    for (const auto& [field, value] : changes) layout_.set(now, field, value);
    for (std::size_t k = 0; k < layout_.timers.size(); ++k) {
        const StateLayout::Timer& bits = layout_.timers[k];
        const Equations::Timer& timer = equations_.timers[k];
        const bool was = before[timer.watched.index] != 0, is = has_bit(now, bits.level),
                   fresh = has_bit(now, bits.fresh);
        if (is && !was) set_bit(now, bits.fresh, true);
        if (is || !was) continue;
        set_bit(now, bits.fresh, false);
        if (timer.fall_ms > 0 && (timer.rise_ms == 0 || !fresh)) set_bit(now, bits.falling, true);
    }
    return store_.intern(now);
}

StateId Moves::settled(StateId state) {
    if (layout_.timers.empty()) return state;
    const std::span<const std::uint64_t> old = store_.at(state);
    PackedState now(old.begin(), old.end());
    for (const StateLayout::Timer& timer : layout_.timers)
        for (const std::uint32_t bit : {timer.fresh, timer.falling}) set_bit(now, bit, false);
    return store_.intern(now);
}

std::vector<std::size_t> Moves::marked(StateId state, std::uint32_t StateLayout::Timer::*bit) const {
    std::vector<std::size_t> timers;
    for (std::size_t timer = 0; timer < layout_.timers.size(); ++timer)
        if (has_bit(store_.at(state), layout_.timers[timer].*bit)) timers.push_back(timer);
    return timers;
}

/// Returns a cube with the outputs of those timers whose output values the events of the current instant determine.
Bdd Moves::known_ends(StateId state, const Values& at) const {
    std::vector<BddLiteral> known;
    for (std::size_t k = 0; k < layout_.timers.size(); ++k) {
        const Equations::Timer& timer = equations_.timers[k];
        const bool level = at[timer.watched.index] != 0;
        const std::uint32_t end = space_.word(*inputs_[timer.end.index]).bits.front();
        if (timer.rise_ms == 0 && (level || has_bit(store_.at(state), layout_.timers[k].falling)))
            known.push_back({end, true});
        if (timer.fall_ms == 0 && (!level || has_bit(store_.at(state), layout_.timers[k].fresh)))
            known.push_back({end, false});
    }
    return cube(space_.space(), known);
}

/// Returns the moves from power-on. Before power-on, no level holds and no timer has expired. The output of a timer
/// with a fall time can remain true longer than its level; therefore, the input sets of the moves require explicitly
/// that this output is false.
std::vector<StateMove> Moves::first() {
    const Values& at = initial_;
    PackedState initial(layout_.words);
    for (std::uint32_t field = 0; field < layout_.fields.size(); ++field)
        layout_.set(initial, field, at[layout_.fields[field].kept.variable.index]);
    const StateId power_on = store_.intern(initial);
    std::vector<BddLiteral> ends, falls;
    for (const Equations::Timer& timer : equations_.timers)
        (timer.fall_ms > 0 ? falls : ends).push_back({space_.word(*inputs_[timer.end.index]).bits.front(), false});
    const Bdd known = cube(space_.space(), ends);
    std::vector<Region> parts{{space_.assumed() & known & cube(space_.space(), falls), {}}};
    for (const Equations::Stored& stored : equations_.stored)
        check_race(stored.first_race, equations_.variables[stored.variable], parts.front().set, at);
    for (std::uint32_t field = 0; field < layout_.evolving; ++field)
        if (const Id<Expr> term = layout_.fields[field].kept.first; term.valid())
            parts = given(std::move(parts), field, term, at);
    std::vector<StateMove> moves;
    const Values off(at.size());
    for (Region& part : parts)
        for (const Region& piece : with_levels(std::move(part), at))
            moves.push_back({piece.set, changed(power_on, piece.changes, off), false});
    return supposing(known, std::move(moves));
}

// -- evolutions without a result --------------------------------------------------------------------------------------

void Moves::check_races(const Cell& cell, const Values& at) {
    const auto check = [&](std::uint32_t stored) {
        check_race(equations_.stored[stored].race, equations_.variables[equations_.stored[stored].variable], cell.set,
                   at);
    };
    std::ranges::for_each(dependencies_.races.always, check);
    for (const std::uint32_t firing : cell.fired) std::ranges::for_each(dependencies_.races.by_firing[firing], check);
    for (const Equations::Conflict& conflict : equations_.conflicts) {
        const LocationCondition condition = terms_.condition(conflict.condition, at);
        const Bdd both = (condition.holds | condition.undefined) & cell.set;
        if (!both.is_false()) throw NoResult{messages::forcing_race(conflict.origin, circumstances(at, both))};
    }
}

/// Checks that `race` is always defined and never true in `within`, so that each stored value is defined.
void Moves::check_race(Id<Expr> race, const Equations::Variable& variable, const Bdd& within, const Values& at) {
    const LocationCondition condition = terms_.condition(race, at);
    const Bdd both = condition.holds & ~condition.undefined & within;
    if (!both.is_false())
        throw NoResult{messages::action_race(variable.origin, variable.name, circumstances(at, both))};
    demand_value(condition.undefined, within, variable.origin, at);
}

void Moves::demand_value(const Bdd& undefined, const Bdd& within, Span where, const Values& at) const {
    if (undefined.is_false()) return;
    const Bdd both = undefined & within;
    if (!both.is_false()) throw NoResult{messages::no_value_in_location(where, circumstances(at, both))};
}

std::string Moves::circumstances(const Values& at, const Bdd& set) const {
    std::string situation = "{";
    for (const Equations::StepActivity& step : equations_.steps)
        if (at[step.variable.index] != 0) situation += (situation.size() > 1 ? "," : "") + step.step.text();
    return situation + "} with " + space_.witness_text(set);
}

}  // namespace grafverif::conform
