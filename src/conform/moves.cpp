// SPDX-License-Identifier: MIT
#include "conform/moves.hpp"

#include <algorithm>
#include <array>

#include "conform/words.hpp"
#include "support/messages.hpp"

namespace grafverif::conform {

Moves::Moves(const Equations& equations, const std::vector<std::optional<std::size_t>>& inputs, const InputSpace& space,
             Diagnostics& diagnostics)
    : equations_(equations), inputs_(inputs), space_(space), diagnostics_(diagnostics), terms_(equations, inputs, space) {
    for (const Kept& each : kept(equations)) add_field(each);
    evolving_ = fields_.size() - equations.watches.size();
    std::uint32_t bit = fields_.empty() ? 0 : 64 * fields_.back().word + fields_.back().shift + 1;
    if (!fields_.empty()) {
        for (std::uint64_t mask = fields_.back().mask >> 1U; mask != 0; mask >>= 1U) ++bit;
    }
    for (const Equations::Timer& timer : equations.timers) {
        fresh_bits_.push_back(bit++);
        falling_bits_.push_back(bit++);
        level_fields_.push_back(static_cast<std::uint32_t>(std::ranges::find(fields_, timer.watched, &StateField::variable) - fields_.begin()));
    }
    store_.shape(std::max<std::size_t>(1, (bit + 63) / 64));
    index_firings();
    index_fields();
}

void Moves::add_field(const Kept& kept) {
    const Type type = equations_.variables[kept.variable].type;
    const auto bits = static_cast<std::uint32_t>(std::max<std::size_t>(1, bit_count(type)));
    StateField field{kept.variable, type, 0, 0, (std::uint64_t{1} << bits) - 1, kept.next, kept.first};
    if (!fields_.empty()) {
        const StateField& before = fields_.back();
        const auto width = static_cast<std::uint32_t>(std::max<std::size_t>(1, bit_count(before.type)));
        field.word = before.word;
        field.shift = before.shift + width;
        if (field.shift + bits > 64) ++field.word, field.shift = 0;
    }
    fields_.push_back(field);
}

/// A firing whose condition begins with the step upstream is looked at only where that step is active.
void Moves::index_firings() {
    const Exprs& exprs = equations_.exprs;
    std::vector<std::uint32_t> field_of(equations_.variables.size(), no_state);
    for (std::uint32_t field = 0; field < fields_.size(); ++field)
        if (equations_.variables[fields_[field].variable].role == Equations::Role::Step)
            field_of[fields_[field].variable.index] = field;
    guarded_.resize(fields_.size());
    for (std::uint32_t firing = 0; firing < equations_.firings.size(); ++firing) {
        const Id<Expr> condition = equations_.firings[firing].condition;
        const Id<Expr> guard = exprs[condition].op == Op::And ? exprs.operands(condition)[0] : condition;
        const bool is_step = exprs[guard].op == Op::Variable && field_of[static_cast<std::size_t>(exprs[guard].value)] != no_state;
        if (is_step) guarded_[field_of[static_cast<std::size_t>(exprs[guard].value)]].push_back(firing);
        else unguarded_.push_back(firing);
    }
}

/// `term`, in `scratch`, where no transition fires.
Id<Expr> Moves::while_quiet(Id<Expr> term, Exprs& scratch) const {
    return translate(equations_.exprs, term, scratch, [&](const Expr& leaf) {
        const Id<Equations::Variable> variable{static_cast<std::uint32_t>(leaf.value)};
        return equations_.variables[variable].role == Equations::Role::FiringCondition
                   ? scratch.constant(false)
                   : scratch.leaf(Op::Variable, variable.index);
    });
}

/// Whether the variable keeps its value wherever no transition fires that its equation reads.
bool Moves::keeps_by_itself(const StateField& field) {
    Exprs scratch;
    const Id<Expr> quiet = while_quiet(field.next, scratch);
    return scratch[quiet].op == Op::Variable && scratch[quiet].value == static_cast<std::int64_t>(field.variable.index);
}

void Moves::index_fields() {
    const Exprs& exprs = equations_.exprs;
    std::vector<std::uint32_t> firing_of(equations_.variables.size(), no_state);
    for (std::uint32_t firing = 0; firing < equations_.firings.size(); ++firing)
        firing_of[equations_.firings[firing].variable.index] = firing;
    affected_.resize(equations_.firings.size());
    races_.resize(equations_.firings.size());
    const auto firings_in = [&](Id<Expr> term, auto visit) {
        for (const Id<Expr> leaf : leaves(exprs, term))
            if (const std::uint32_t firing = firing_of[static_cast<std::size_t>(exprs[leaf].value)]; firing != no_state) visit(firing);
    };
    for (std::uint32_t field = 0; field < evolving_; ++field) {
        if (keeps_by_itself(fields_[field])) firings_in(fields_[field].next, [&](std::uint32_t firing) { affected_[firing].push_back(field); });
        else restless_.push_back(field);
    }
    for (std::uint32_t k = 0; k < equations_.stored.size(); ++k) {
        Exprs scratch;
        if (!is_false(scratch, while_quiet(equations_.stored[k].race, scratch))) restless_races_.push_back(k);
        else firings_in(equations_.stored[k].race, [&](std::uint32_t firing) { races_[firing].push_back(k); });
    }
    const Id<Expr> stable = equations_.stable;
    if (exprs[stable].op == Op::Not) {
        const Id<Expr> changes = exprs.operands(stable)[0];
        std::size_t plain = 0;
        const auto count = [&](Id<Expr> term) {
            if (exprs[term].op == Op::Variable && firing_of[static_cast<std::size_t>(exprs[term].value)] != no_state) ++plain;
        };
        if (exprs[changes].op == Op::Or)
            for (const Id<Expr> operand : exprs.operands(changes)) count(operand);
        else count(changes);
        const auto never = std::ranges::count_if(equations_.firings, [&](const Equations::Firing& firing) { return is_false(exprs, firing.condition); });
        fires_unstable_ = plain + static_cast<std::size_t>(never) == equations_.firings.size();
    }
}

const std::vector<std::int64_t>& Moves::load(StateId state) {
    std::vector<std::int64_t>& values = terms_.values();
    if (loaded_ == state) return values;
    const std::span<const std::uint64_t> words = store_.at(state);
    for (const StateField& field : fields_)
        values[field.variable.index] = static_cast<std::int64_t>((words[field.word] >> field.shift) & field.mask) +
                                       (field.type.boolean ? 0 : field.type.low);
    loaded_ = state;
    return values;
}

const std::vector<StateMove>& Moves::of(StateId state) {
    while (known_.size() <= state) known_.emplace_back();
    if (!known_[state]) {
        std::vector<StateMove> moves = moves_of(state);
        known_[state] = std::move(moves);
    }
    return *known_[state];
}

std::vector<StateMove> Moves::moves_of(StateId state) {
    load(state);
    std::vector<StateMove> moves;
    const Bdd known = known_ends(state);
    const std::vector<Cell> all = cells(space_.assumed() & known);
    for (const Cell& cell : all) {
        for (const std::uint32_t firing : cell.fired) terms_.values()[equations_.firings[firing].variable.index] = 1;
        if (check_races(cell)) add_moves(state, cell, moves);
        for (const std::uint32_t firing : cell.fired) terms_.values()[equations_.firings[firing].variable.index] = 0;
        if (failed_) return {};
    }
    suppose(known, moves);
    const auto is_stable = [](const StateMove& move) { return move.stable; };
    if (!std::ranges::is_partitioned(moves, is_stable)) std::ranges::stable_partition(moves, is_stable);
    std::size_t kept = 0;   // several sets of transitions may lead to one state
    for (StateMove& move : moves) {
        std::size_t same = 0;
        while (same < kept && (moves[same].next != move.next || moves[same].stable != move.stable)) ++same;
        if (same < kept) moves[same].set |= move.set;
        else if (&moves[kept++] != &move) moves[kept - 1] = std::move(move);
    }
    moves.resize(kept);
    return moves;
}

std::vector<Moves::Cell> Moves::cells(const Bdd& within) {
    std::vector<Cell> cells;
    Bdd touched;   // where some transition fires
    for (std::uint32_t field = 0; field < fields_.size(); ++field) {
        if (guarded_[field].empty() || terms_.values()[fields_[field].variable.index] == 0) continue;
        for (const std::uint32_t firing : guarded_[field]) fire(cells, touched, firing, within);
    }
    for (const std::uint32_t firing : unguarded_) fire(cells, touched, firing, within);
    Bdd quiet = within & ~touched;
    if (!quiet.is_false()) cells.insert(cells.begin(), {std::move(quiet), {}});
    return cells;
}

/// Cuts the cells by the condition of `firing`.
void Moves::fire(std::vector<Cell>& cells, Bdd& touched, std::uint32_t firing, const Bdd& within) {
    if (failed_) return;
    Bdd undefined;
    Bdd condition = terms_.condition(equations_.firings[firing].condition, undefined) & within;
    if (!undefined.is_false() && !(undefined & within).is_false())
        return complain(messages::no_value_in_location(equations_.firings[firing].origin, circumstances(undefined & within)));
    if (condition.is_false()) return;
    if (!(condition & touched).is_false()) {
        const std::size_t count = cells.size();
        for (std::size_t k = 0; k < count; ++k) {
            Bdd both = cells[k].set & condition;
            if (both.is_false()) continue;
            if (both == cells[k].set) {
                cells[k].fired.push_back(firing);
                continue;
            }
            Cell split{std::move(both), cells[k].fired};
            split.fired.push_back(firing);
            cells[k].set &= ~condition;
            cells.push_back(std::move(split));
        }
        Bdd alone = condition & ~touched;
        touched |= condition;
        if (!alone.is_false()) cells.push_back({std::move(alone), {firing}});
        return;
    }
    touched |= condition;
    cells.push_back({std::move(condition), {firing}});
}

bool Moves::check_races(const Cell& cell) {
    const auto check = [&](std::uint32_t stored) {
        check_race(equations_.stored[stored].race, equations_.variables[equations_.stored[stored].variable], cell.set);
    };
    std::ranges::for_each(restless_races_, check);
    for (const std::uint32_t firing : cell.fired) std::ranges::for_each(races_[firing], check);
    for (const Equations::Conflict& conflict : equations_.conflicts) {
        Bdd undefined;
        const Bdd both = (terms_.condition(conflict.condition, undefined) | undefined) & cell.set;
        if (!both.is_false()) complain(messages::forcing_race(conflict.origin, circumstances(both)));
    }
    return !failed_;
}

/// That `race` never holds in `within`, and always has a value: each value stored has one.
void Moves::check_race(Id<Expr> race, const Equations::Variable& variable, const Bdd& within) {
    Bdd undefined;
    const Bdd both = terms_.condition(race, undefined) & within;
    if (!(both & ~undefined).is_false())
        complain(messages::action_race(variable.origin, variable.name, circumstances(both & ~undefined)));
    else if (!(undefined & within).is_false())
        complain(messages::no_value_in_location(variable.origin, circumstances(undefined & within)));
}

void Moves::add_moves(StateId state, const Cell& cell, std::vector<StateMove>& moves) {
    std::vector<Part> parts{{cell.set, {}}};
    for (const std::uint32_t field : restless_) split_by(parts, field, fields_[field].next);
    for (const std::uint32_t firing : cell.fired)
        for (const std::uint32_t field : affected_[firing]) split_by(parts, field, fields_[field].next);
    if (failed_) return;
    Bdd stable;   // where nothing changes
    if (!fires_unstable_ || cell.fired.empty()) {
        Bdd undefined;
        stable = terms_.condition(equations_.stable, undefined);
    }
    for (Part& part : parts) {
        Bdd settled = stable.is_constant() ? (stable.is_true() ? part.set : Bdd{}) : part.set & stable;
        if (!settled.is_false()) {
            part.set &= ~settled;
            add_pieces(state, {std::move(settled), {}}, true, moves);
        }
        if (!part.set.is_false()) add_pieces(state, std::move(part), false, moves);
    }
}

void Moves::add_pieces(StateId state, Part part, bool stable, std::vector<StateMove>& moves) {
    const auto add = [&](Part& piece) {
        const StateId next = piece.changes.empty() ? state : changed(state, piece);
        moves.push_back({std::move(piece.set), next, stable});
    };
    if (evolving_ == fields_.size()) return add(part);
    for (Part& piece : watched(std::move(part))) add(piece);
}

/// Gives `field` the value of `term` in each part; a part in which the inputs decide on it falls apart.
void Moves::split_by(std::vector<Part>& parts, std::uint32_t field, Id<Expr> term) {
    if (failed_) return;
    const Equations::Variable& variable = equations_.variables[fields_[field].variable];
    const LocationValue found = terms_.value(term);
    const bool fits = !found.function && !found.none && found.number >= variable.type.low && found.number <= variable.type.high;
    if (fits) {
        for (Part& part : parts) part.changes.emplace_back(field, found.number);
        return;
    }
    std::vector<Part> result;
    for (Part& part : parts) {
        if (found.none || (found.function && !(found.function->undefined & part.set).is_false()))
            return complain(messages::no_value_in_location(variable.origin, circumstances(part.set)));
        std::vector<Part> pieces;
        if (found.function) pieces = split(part, *found.function);
        else pieces.push_back({std::move(part.set), std::move(part.changes)});
        for (Part& piece : pieces) {
            std::int64_t value = found.number;
            if (found.function) value = piece.changes.back().second;
            if (value < variable.type.low || value > variable.type.high)
                return complain(messages::out_of_range_in_location(variable.origin, variable.name, value, circumstances(piece.set)));
            if (found.function) piece.changes.back().first = field;
            else piece.changes.emplace_back(field, value);
            result.push_back(std::move(piece));
        }
    }
    parts = std::move(result);
}

/// The part by the values of `value`, each at the end of the changes of its piece.
std::vector<Moves::Part> Moves::split(const Part& part, const BddTerm& value) {
    std::vector<Part> pieces;
    Bdd rest = part.set;
    while (!rest.is_false()) {
        const std::vector<bool> assignment = space_.assignment(rest);
        std::int64_t number = 0;
        Bdd same = rest;
        for (std::size_t bit = 0; bit < value.bits.size(); ++bit) {
            const bool on = evaluate(value.bits[bit], assignment);
            same &= on ? value.bits[bit] : ~value.bits[bit];
            const bool sign = !value.boolean && bit + 1 == value.bits.size();
            if (on) number += sign ? -(std::int64_t{1} << bit) : std::int64_t{1} << bit;
        }
        pieces.push_back({same, part.changes});
        pieces.back().changes.emplace_back(0, number);
        rest &= ~same;
    }
    return pieces;
}

/// `state` after the changes of `part`; the values of `state` are loaded.
StateId Moves::changed(StateId state, const Part& part, bool power_on) {
    std::vector<std::uint64_t>& words = scratch_;
    words.assign(store_.at(state).begin(), store_.at(state).end());
    for (const auto& [index, value] : part.changes) {
        const StateField& field = fields_[index];
        const auto packed = static_cast<std::uint64_t>(value - (field.type.boolean ? 0 : field.type.low));
        words[field.word] = (words[field.word] & ~(field.mask << field.shift)) | (packed << field.shift);
    }
    mark_timers(words, power_on);
    return store_.intern(words);
}

std::vector<StateMove> Moves::first() {
    for (const Id<Equations::Variable> id : equations_.variables.ids())
        terms_.values()[id.index] = equations_.variables[id].initial;
    loaded_ = no_state;
    std::vector<BddLiteral> ends, falls;   // none holds; whose fall time has not started says so in the sets as well
    for (const Equations::Timer& timer : equations_.timers)
        (timer.fall_ms > 0 ? falls : ends).push_back({space_.word(*inputs_[timer.end.index]).bits.front(), false});
    const Bdd known = cube(space_.space(), ends);
    std::vector<Part> parts{{space_.assumed() & known & cube(space_.space(), falls), {}}};
    for (const Equations::Stored& stored : equations_.stored)
        check_race(stored.first_race, equations_.variables[stored.variable], parts.front().set);
    std::vector<std::pair<std::uint32_t, std::int64_t>> initial;
    for (std::uint32_t field = 0; field < fields_.size(); ++field)
        initial.emplace_back(field, equations_.variables[fields_[field].variable].initial);
    const StateId before = store_.intern(std::vector<std::uint64_t>(store_.words()));
    const StateId power_on = changed(before, {{}, initial});
    for (std::uint32_t field = 0; field < evolving_; ++field)
        if (fields_[field].first.valid()) split_by(parts, field, fields_[field].first);
    if (failed_) return {};
    std::vector<StateMove> moves;
    for (Part& part : parts)
        for (Part& piece : watched(std::move(part))) {
            const StateId next = changed(power_on, piece, true);
            moves.push_back({std::move(piece.set), next, false});
        }
    if (failed_) return {};
    suppose(known, moves);
    return moves;
}

void Moves::complain(Diagnostic diagnostic) {
    if (!failed_) diagnostics_.add(std::move(diagnostic));
    failed_ = true;
}

std::string Moves::circumstances(const Bdd& set) const {
    std::string situation = "{";
    for (const Equations::StepActivity& step : equations_.steps)
        if (terms_.values()[step.variable.index] != 0) situation += (situation.size() > 1 ? "," : "") + step.step;
    std::vector<std::pair<std::string, Type>> names(space_.inputs());
    for (const Id<Equations::Variable> id : equations_.variables.ids())
        if (inputs_[id.index]) names[*inputs_[id.index]] = {equations_.variables[id].name, equations_.variables[id].type};
    return situation + "} with " + inputs_text(names, space_.witness(set));
}

}  // namespace grafverif::conform
