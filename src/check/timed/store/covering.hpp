// SPDX-License-Identifier: MIT
// Covering: finds stored states that simulate a new state because only their clocks differ.
//
// Let L and U be the greatest constants with which a clock x can be compared from below and from above before its next
// reset (ir/network_clocks.hpp). A state s' simulates a state s if they have the same locations and variables, and for
// each clock one of these conditions holds: x has the same value in both; L <= s'(x) < s(x); or U < s(x) < s'(x)
// (Behrmann, Bouyer, Larsen, Pelanek: Lower and upper bounds in zone-based abstractions of timed automata, 2006; here
// for integer values and closed constraints). Every run from s is then also a run from s', because urgent edges have no
// clock constraints and keep the invariants of their targets. Therefore, a search for single states need not store s,
// unless the run to s' is longer than the run to s.
//
// For a clock with U < L, the values up to U are exact, and greater ones simulate smaller ones. For the other clocks,
// the values below L are exact, and smaller ones simulate greater ones. So the state in which all inexact values are
// replaced by the least of them is a key: a state can only simulate states with the same key.
#pragma once

#include <cstdint>
#include <vector>

#include "check/timed/layout.hpp"
#include "check/timed/store/column.hpp"
#include "check/timed/store/store.hpp"
#include "check/timed/timed.hpp"

namespace grafverif::timed {

class Covering {
public:
    /// `clocks` is the clock analysis of `network`, which must be expanded.
    Covering(const Network& network, const Layout& layout, const std::vector<ProcessClocks>& clocks,
             const CoveringAblations& ablations = {});

    /// True if some value of a clock simulates another value.
    bool applies() const { return !zones_.empty(); }
    /// Returns an added state that simulates the state in `words` and that `accepts(state)` permits, or Store::none.
    template <class Accepts>
    std::uint32_t find(const Word* words, const Accepts& accepts) {
        select(words);
        for (std::uint32_t entry = lists_[key_]; entry != none; entry = entries_[entry].next) {
            ++length_;
            if (!is_below(entries_[entry])) continue;
            if (const std::uint32_t state = entries_[entry].state; accepts(state)) {
                ++covered_;
                return state;
            }
        }
        return Store::none;
    }
    /// Adds a state. Requires that `find` was last called for it.
    void add(std::uint32_t state);
    /// False if so few states are covered that the covering costs more than it saves.
    bool is_useful() const { return searched_ < (1U << 16U) || covered_ >= searched_ / 16; }
    std::size_t bytes() const;

private:
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    static constexpr std::uint32_t most_entries = 256;  // maximum number of states with the same key
    struct Zone {                                       // the inexact values of a clock at a location
        Field clock = {};
        Word first = 0, last = 0;
        bool greater_simulates = false;
    };
    struct Row {  // a location of a process, as a range in zones_
        std::uint32_t first = 0, last = 0;
    };
    struct Entry {
        std::uint32_t state = 0;
        std::uint32_t next = none;
        std::size_t values = 0;  // index of the first of its values in stored_
    };

    void select(const Word* words);
    bool is_below(const Entry& entry) const;
    bool is_above(const Entry& entry) const;

    const Layout& layout_;
    std::vector<Zone> zones_ = {};
    std::vector<Row> rows_ = {};                 // per location of each process with zones
    std::vector<std::uint32_t> first_row_ = {};  // per process; `none` without zones
    Store keys_;
    Column<std::uint32_t> lists_ = {};  // first entry of each key
    Column<Entry> entries_ = {};
    Column<std::uint16_t> stored_ = {};
    // The state for which `find` was last called. A smaller value simulates a greater one.
    std::vector<Word> words_ = {};
    Unfolded folded_ = {};
    std::vector<std::uint16_t> values_ = {};
    std::uint32_t key_ = 0;
    std::uint32_t length_ = 0;  // number of entries of the key that were compared
    std::uint64_t searched_ = 0, covered_ = 0;
};

}  // namespace grafverif::timed
