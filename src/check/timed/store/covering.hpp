// SPDX-License-Identifier: MIT
// Covering: finds a stored state that simulates a new state and differs from it only in clock values. The search need
// not store the new state.
//
// For each clock x, let L and U be the greatest constants in lower bounds `x >= L` and upper bounds `x <= U`. Only
// comparisons that the model can evaluate before the next reset of x are considered (ir/network_clocks.hpp). A state s'
// simulates a state s if both have the same locations and variables, and each clock x satisfies one of these
// conditions: s'(x) = s(x); L <= s'(x) < s(x); or U < s(x) < s'(x) (Behrmann, Bouyer, Larsen, Pelanek: Lower and upper
// bounds in zone-based abstractions of timed automata, 2006; here for integer values and closed constraints). If s'
// simulates s, every run from s is also a run from s', because urgent edges have no clock constraints and keep the
// invariants of their targets. Therefore, a search for single states need not store s. To find shortest runs, the
// search still stores s if the run to s' is longer than the run to s.
//
// A clock value is *exact* if no other value simulates it. For a clock with U < L, the values up to U are exact; among
// the values above U, a greater value simulates a smaller value. For all other clocks, the values below L are exact;
// among the values from L on, a smaller value simulates a greater value. The *key* of a state is the state in which
// each inexact clock value is replaced by the least inexact value of this clock. A state can simulate only states with
// the same key.
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

    /// True if, for some clock of the network, a value simulates another value.
    bool applies() const { return !zones_.empty(); }
    /// Returns an added state that simulates the state in `words` and for which `accepts(state)` is true. Returns
    /// Store::none if no added state satisfies both conditions.
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
    /// Adds a state. Requires that the last call of `find` was for this state.
    void add(std::uint32_t state);
    /// False if, after at least 65,536 calls of `find`, less than 1/16 of the calls have found a state. In this case,
    /// the covering costs more than it saves.
    bool is_useful() const { return searched_ < (1U << 16U) || covered_ >= searched_ / 16; }
    std::size_t bytes() const;

private:
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    static constexpr std::uint32_t most_entries = 256;  // maximum number of states with the same key
    struct Zone {                                       // the inexact values of a clock in a location
        Field clock = {};
        Word first = 0, last = 0;
        bool greater_simulates = false;
    };
    struct Row {  // the zones of a location of a process, as a range in zones_
        std::uint32_t first = 0, last = 0;
    };
    struct Entry {
        std::uint32_t state = 0;
        std::uint32_t next = none;
        std::size_t values = 0;  // index in stored_ of the first clock value of the state
    };

    void select(const Word* words);
    bool is_below(const Entry& entry) const;
    bool is_above(const Entry& entry) const;

    const Layout& layout_;
    std::vector<Zone> zones_ = {};
    std::vector<Row> rows_ = {};                 // one row per location, for each process with zones
    std::vector<std::uint32_t> first_row_ = {};  // per process: index of its first row in rows_; `none` if the process
                                                 // has no zones
    Store keys_;
    Column<std::uint32_t> lists_ = {};  // index of the first entry of each key
    Column<Entry> entries_ = {};
    Column<std::uint16_t> stored_ = {};
    // The argument of the last call of `find`. In `values_`, each inexact clock value is encoded as a number, so that a
    // value with a smaller number simulates a value with a greater number.
    std::vector<Word> words_ = {};
    Unfolded folded_ = {};
    std::vector<std::uint16_t> values_ = {};
    std::uint32_t key_ = 0;
    std::uint32_t length_ = 0;  // number of entries that the last call of `find` compared
    std::uint64_t searched_ = 0, covered_ = 0;
};

}  // namespace grafverif::timed
