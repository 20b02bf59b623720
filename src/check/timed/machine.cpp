// SPDX-License-Identifier: MIT
// The moves of a state: the hot loop of the search. It does not allocate once its buffers have grown.
#include "check/timed/machine.hpp"

#include <bit>
#include <cstring>

namespace grafverif::timed {

void Machine::expand(const Word* words, Moves& moves) const {
    if (moves.registers.size() < program_.registers) moves.registers.resize(program_.registers);
    moves.edges.clear();
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
            const End guard =
                at.guard == Program::yes ? End::Yes : test(program_, at.guard, words, moves.registers.data()).end;
            if (guard == End::No) continue;
            covered |= at.covers;
            freed |= at.frees;
            always = always || at.always;
            if (at.clocks != Program::yes && test(program_, at.clocks, words, moves.registers.data()).end != End::Yes)
                continue;
            if (guard == End::Yes) fire(edge, words, moves);
            else if (!moves.fault) moves.fault = Fault{End::NoValue, edge, 0};
        }
        if (const Word open = row.bounds & ~covered; open != 0 && !moves.stuck_bound)
            moves.stuck_bound = UncoveredBound{process, static_cast<std::uint32_t>(std::countr_zero(open))};
        if (const Word open = row.bounds & ~(freed & row.late); open != 0 && !moves.locked_bound)
            moves.locked_bound = UncoveredBound{process, static_cast<std::uint32_t>(std::countr_zero(open))};
    }
    if (always || moves.urgent) moves.stuck_bound.reset();
    if (moves.urgent) moves.locked_bound.reset();
}

void Machine::fire(std::uint32_t edge, const Word* words, Moves& moves) const {
    if (const std::size_t room = (moves.edges.size() + 1) * layout_.words; moves.words.size() < room)
        moves.words.resize(2 * room);
    Word* const next = moves.words.data() + moves.edges.size() * layout_.words;
    for (std::size_t i = 0; i < layout_.stored; ++i) next[i] = words[i];
    const Ran ran = run(program_, edges_[edge].effect, next, moves.registers.data());
    moves.urgent = moves.urgent || edges_[edge].urgent;  // also where it breaks off
    if (ran.end == End::Yes) {
        moves.edges.push_back(edge);
    } else if (!moves.fault) {
        moves.fault = Fault{ran.end, edge, program_.code[ran.place].to};
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
    return true;
}

End Machine::holds(std::uint32_t predicate, const Word* words, std::vector<std::int64_t>& registers) const {
    if (registers.size() < program_.registers) registers.resize(program_.registers);
    return test(program_, predicate, words, registers.data()).end;
}

}  // namespace grafverif::timed
