// SPDX-License-Identifier: MIT
// What timers ask of a state: the levels they watch, and what happened to these within the instant.
#include <algorithm>
#include <utility>

#include "conform/moves.hpp"
#include "support/messages.hpp"

namespace grafverif::conform {

namespace {

bool is_set(std::span<const std::uint64_t> words, std::uint32_t bit) { return ((words[bit / 64] >> (bit % 64)) & 1U) != 0; }

void set(std::vector<std::uint64_t>& words, std::uint32_t bit, bool value) {
    const std::uint64_t mask = std::uint64_t{1} << (bit % 64);
    if (value) words[bit / 64] |= mask;
    else words[bit / 64] &= ~mask;
}

}  // namespace

StateId Moves::settled(StateId state) {
    if (fresh_bits_.empty()) return state;
    std::vector<std::uint64_t> words(store_.at(state).begin(), store_.at(state).end());
    for (const auto* bits : {&fresh_bits_, &falling_bits_})
        for (const std::uint32_t bit : *bits) set(words, bit, false);
    return store_.intern(words);
}

std::vector<std::size_t> Moves::marked(StateId state, const std::vector<std::uint32_t>& bits) const {
    std::vector<std::size_t> timers;
    const std::span<const std::uint64_t> words = store_.at(state);
    for (std::size_t timer = 0; timer < bits.size(); ++timer)
        if (is_set(words, bits[timer])) timers.push_back(timer);
    return timers;
}

/// The ends of timers that what happened within the instant decides on.
Bdd Moves::known_ends(StateId state) {
    std::vector<BddLiteral> known;
    const std::span<const std::uint64_t> words = store_.at(state);
    for (std::size_t k = 0; k < fresh_bits_.size(); ++k) {
        const Equations::Timer& timer = equations_.timers[k];
        const bool level = terms_.values()[timer.watched.index] != 0;
        const std::uint32_t end = space_.word(*inputs_[timer.end.index]).bits.front();
        if (timer.rise_ms == 0 && (level || is_set(words, falling_bits_[k]))) known.push_back({end, true});
        if (timer.fall_ms == 0 && (!level || is_set(words, fresh_bits_[k]))) known.push_back({end, false});
    }
    return cube(space_.space(), known);
}

/// What is said of `moves` that happen only where `known` holds; those that cannot are dropped.
void Moves::suppose(const Bdd& known, std::vector<StateMove>& moves) {
    if (known.is_true()) return;
    for (StateMove& move : moves) move.set = cofactor(move.set & known, known);
    std::erase_if(moves, [](const StateMove& move) { return move.set.is_false(); });
}

/// The part by the levels that timers watch, as it leaves them.
std::vector<Moves::Part> Moves::watched(Part part) {
    std::vector<Part> parts;
    parts.push_back(std::move(part));
    std::vector<std::int64_t>& values = terms_.values();
    for (std::size_t field = evolving_; field < fields_.size() && !failed_; ++field) {
        const Equations::Watch& watch = equations_.watches[field - evolving_];
        const std::int64_t before = values[watch.variable.index];
        std::vector<Part> pieces;
        for (Part& one : parts) {
            const Changes old = exchange_values(one.changes);
            Bdd undefined;
            const Bdd level = terms_.condition(watch.value, undefined);
            exchange_values(old);
            if (!undefined.is_false() && !(undefined & one.set).is_false())
                complain(messages::no_value_in_location(watch.origin, circumstances(undefined & one.set)));
            for (const bool value : {false, true}) {
                Part piece{one.set & (value ? level : ~level), one.changes};
                if (piece.set.is_false()) continue;
                if (static_cast<std::int64_t>(value) != before) piece.changes.emplace_back(static_cast<std::uint32_t>(field), value);
                pieces.push_back(std::move(piece));
            }
        }
        parts = std::move(pieces);
    }
    return parts;
}

/// Gives the fields their values; the values before.
Moves::Changes Moves::exchange_values(const Changes& changes) {
    Changes old;
    for (const auto& [field, value] : changes) {
        std::int64_t& place = terms_.values()[fields_[field].variable.index];
        old.emplace_back(field, std::exchange(place, value));
    }
    std::ranges::reverse(old);
    return old;
}

/// Marks the timers by what happened to the levels they watch; at power-on those that hold have just become true.
void Moves::mark_timers(std::vector<std::uint64_t>& words, bool power_on) const {
    for (std::size_t timer = 0; timer < fresh_bits_.size(); ++timer) {
        const StateField& field = fields_[level_fields_[timer]];
        const bool before = terms_.values()[field.variable.index] != 0;
        const bool after = is_set(words, 64 * field.word + field.shift);
        const bool fresh = is_set(words, fresh_bits_[timer]);
        if (after) set(words, fresh_bits_[timer], fresh || !before || power_on);
        if (after || !before) continue;
        set(words, fresh_bits_[timer], false);
        const Equations::Timer& which = equations_.timers[timer];
        if (which.fall_ms > 0 && (which.rise_ms == 0 || !fresh)) set(words, falling_bits_[timer], true);
    }
}

}  // namespace grafverif::conform
