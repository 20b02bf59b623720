// SPDX-License-Identifier: MIT
// The inner loop of the search: computes the moves of a state. The code reuses buffers and allocates memory only when a
// buffer must grow.
#include "check/timed/machine.hpp"

#include <bit>
#include <cstring>

namespace grafverif::timed {

void Machine::expand(const Word* words, Moves& moves) const {
    if (const std::size_t all = program_.below + program_.registers; moves.registers.size() < all)
        moves.registers.resize(all);
    std::int64_t* const registers = moves.registers.data() + program_.below;
    moves.edges.clear();
    moves.chosen.clear();
    moves.cut = false;
    moves.urgent = false;
    moves.fault.reset();
    moves.stuck_bound.reset();
    moves.locked_bound.reset();
    bool always = false;
    for (std::uint32_t process = 0; process < places_.size(); ++process) {
        const Place& place = places_[process];
        const Row& row = rows_[place.row + ((words[place.word] & place.mask) >> place.shift)];
        Word covered = 0;
        Word freed = 0;
        for (std::uint32_t edge = row.first; edge != row.last; ++edge) {
            const Edge& at = edges_[edge];
            if ((words[at.word] & at.mask) != at.value) continue;
            const End guard = at.guard == Program::yes ? End::Yes : test(program_, at.guard, words, registers).end;
            if (guard == End::No) continue;
            covered |= at.covers;
            freed |= at.frees;
            always = always || at.always;
            if (at.clocks != Program::yes && test(program_, at.clocks, words, registers).end != End::Yes) continue;
            if (guard == End::Yes) {
                fire(edge, words, moves);
                continue;
            }
            moves.urgent = moves.urgent || at.urgent;  // as in add_move: time does not pass before a model error
            if (!moves.fault) moves.fault = Fault{End::NoValue, edge, 0};
        }
        if (const Word open = row.bounds & ~covered; open != 0 && !moves.stuck_bound)
            moves.stuck_bound = UncoveredBound{process, static_cast<std::uint32_t>(std::countr_zero(open))};
        if (const Word open = row.bounds & ~(freed & row.late); open != 0 && !moves.locked_bound)
            moves.locked_bound = UncoveredBound{process, static_cast<std::uint32_t>(std::countr_zero(open))};
    }
    if (always || moves.urgent) moves.stuck_bound.reset();
    if (moves.urgent) moves.locked_bound.reset();
}

bool Machine::may_move(std::uint32_t process, const Word* words, std::vector<std::int64_t>& registers) const {
    if (const std::size_t all = program_.below + program_.registers; registers.size() < all) registers.resize(all);
    std::int64_t* const own = registers.data() + program_.below;
    const Place& place = places_[process];
    const Row& row = rows_[place.row + ((words[place.word] & place.mask) >> place.shift)];
    for (std::uint32_t edge = row.first; edge != row.last; ++edge) {
        const Edge& at = edges_[edge];
        if ((words[at.word] & at.mask) != at.value) continue;
        if (at.guard != Program::yes && test(program_, at.guard, words, own).end == End::No) continue;
        if (at.clocks == Program::yes || test(program_, at.clocks, words, own).end == End::Yes) return true;
    }
    return false;
}

void Machine::fire(std::uint32_t edge, const Word* words, Moves& moves) const {
    if (edges_[edge].first_set != edges_[edge].last_set) return fire_each_path(edge, words, moves);
    Word* const next = next_successor(moves);
    copy_stored(words, next, moves);
    const ExecutionResult ran = run(program_, edges_[edge].effect, next, moves.registers.data() + program_.below);
    add_move(edge, ran, moves);
}

/// Returns the address of the buffer space for the next successor. Enlarges the buffer if necessary.
Word* Machine::next_successor(Moves& moves) const {
    if (const std::size_t needed = (moves.edges.size() + 1) * layout_.words; moves.words.size() < needed)
        moves.words.resize(2 * needed);
    return moves.words.data() + moves.edges.size() * layout_.words;
}

void Machine::copy_stored(const Word* words, Word* next, const Moves& moves) const {
    const std::size_t copied = moves.record_choices ? layout_.words : layout_.stored;
    for (std::size_t i = 0; i < copied; ++i) next[i] = words[i];
}

/// Adds the move by `edge`, whose code has computed the state at next_successor(moves). If the edge causes a model
/// error, records the error and returns false.
bool Machine::add_move(std::uint32_t edge, const ExecutionResult& ran, Moves& moves) const {
    moves.urgent = moves.urgent || edges_[edge].urgent;  // set even if the edge causes a model error
    if (ran.end == End::Yes) {
        moves.edges.push_back(edge);
        if (moves.record_choices) moves.chosen.insert(moves.chosen.end(), choices_.size(), 0);
        return true;
    }
    if (!moves.fault) moves.fault = Fault{ran.end, edge, program_.code[ran.place].to};
    return false;
}

/// Executes the code of an edge that reads chosen inputs, once for each combination of input valuations that the code
/// distinguishes. If only some of the possible valuations satisfy a test, the execution forks at this test.
void Machine::fire_each_path(std::uint32_t edge, const Word* words, Moves& moves) const {
    const Edge& at = edges_[edge];
    std::int64_t* const registers = moves.registers.data() + program_.below;
    moves.forks.begin(layout_.words, program_.below, program_.registers);
    for (std::uint32_t i = at.first_set; i != at.last_set; ++i) {
        const Field& kept = layout_.choices[sets_[i].choice];
        *(registers - Choices::set(sets_[i].choice)) =
            static_cast<std::int64_t>(kept.width == 0 ? sets_[i].all : kept.raw(words));
    }
    Word* next = next_successor(moves);
    copy_stored(words, next, moves);
    std::uint32_t place = at.effect;
    for (std::size_t paths = 0;; ++paths) {
        if (paths == most_choices) {
            moves.cut = true;
            return;
        }
        const ExecutionResult ran = run(program_, place, next, registers, &moves.forks);
        if (add_move(edge, ran, moves)) {
            for (std::uint32_t i = at.first_set; i != at.last_set; ++i) {
                const std::uint32_t choice = sets_[i].choice;
                const std::int64_t set = *(registers - Choices::set(choice));
                if (moves.record_choices)
                    moves.chosen[moves.chosen.size() - choices_.size() + choice] = static_cast<Word>(set);
                const Field& kept = layout_.choices[choice];
                const bool all = sets_[i].widened || (rests_[choice] && rests_[choice]->is_reached(next));
                if (kept.width != 0) kept.set(next, all ? static_cast<std::int64_t>(sets_[i].all) : set);
            }
        }
        if (moves.forks.empty()) return;
        next = next_successor(moves);
        place = moves.forks.pop(next, registers);
    }
}

bool Machine::delay(Word* words) const {
    for (const Place& place : places_) {
        const Row& row = rows_[place.row + ((words[place.word] & place.mask) >> place.shift)];
        for (std::uint32_t tick = row.first_tick; tick != row.last_tick; ++tick) {
            const Tick& at = ticks_[tick];
            const Word value = (words[at.word] & at.mask) >> at.shift;
            if (value >= at.greatest) return false;
            if (value < at.cap) words[at.word] += Word{1} << at.shift;
        }
    }
    for (const Field& set : until_delay_) words[set.word] |= set.mask();
    return true;
}

End Machine::holds(std::uint32_t predicate, const Word* words, std::vector<std::int64_t>& registers) const {
    if (const std::size_t all = program_.below + program_.registers; registers.size() < all) registers.resize(all);
    return test(program_, predicate, words, registers.data() + program_.below).end;
}

}  // namespace grafverif::timed
