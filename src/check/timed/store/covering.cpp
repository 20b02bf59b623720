// SPDX-License-Identifier: MIT
#include "check/timed/store/covering.hpp"

#include <algorithm>
#include <limits>

namespace grafverif::timed {

Covering::Covering(const Network& network, const Layout& layout, const std::vector<ProcessClocks>& clocks,
                   const CoveringAblations& ablations)
    : layout_(layout), keys_(layout), words_(layout.stored) {
    for (const Id<Network::Process> process : network.processes.ids()) {
        const ProcessClocks& of = clocks[process.index];
        const std::size_t before = zones_.size();
        std::vector<Row> rows;
        for (std::size_t location = 0; location < of.cap.size(); ++location) {
            Row row{.first = static_cast<std::uint32_t>(zones_.size())};
            for (std::size_t clock = 0; clock < of.cap[location].size(); ++clock) {
                const std::int64_t lower = ablations.lower ? 0 : of.lower[location][clock];
                const std::int64_t upper = ablations.upper ? ProcessClocks::no_upper : of.upper[location][clock];
                const std::int64_t first = upper < lower ? upper + 1 : lower;
                const std::int64_t last = of.cap[location][clock];
                if (first >= last || last - first > std::numeric_limits<std::uint16_t>::max()) continue;
                zones_.push_back({layout.clocks[process.index][clock], static_cast<Word>(first),
                                  static_cast<Word>(last), upper < lower});
            }
            row.last = static_cast<std::uint32_t>(zones_.size());
            rows.push_back(row);
        }
        const bool any = zones_.size() != before;
        first_row_.push_back(any ? static_cast<std::uint32_t>(rows_.size()) : none);
        if (any) rows_.insert(rows_.end(), rows.begin(), rows.end());
    }
}

/// Computes the key of a state and its inexact clock values. (A clock value is inexact if another value of the clock
/// simulates it; see covering.hpp.)
void Covering::select(const Word* words) {
    std::copy_n(words, words_.size(), words_.begin());
    values_.clear();
    length_ = 0;
    ++searched_;
    for (std::size_t process = 0; process < first_row_.size(); ++process) {
        if (first_row_[process] == none) continue;
        const Row& row = rows_[first_row_[process] + layout_.locations[process].raw(words)];
        for (std::uint32_t i = row.first; i != row.last; ++i) {
            const Zone& zone = zones_[i];
            const Word value = zone.clock.raw(words);
            if (value < zone.first) continue;
            zone.clock.set(words_.data(), static_cast<std::int64_t>(zone.first));
            values_.push_back(
                static_cast<std::uint16_t>(zone.greater_simulates ? zone.last - value : value - zone.first));
        }
    }
    key_ = keys_.roots().intern(keys_.fold(words_.data(), {}, folded_)).number;
    if (key_ == lists_.size()) lists_.push_back(none);
}

/// True if the state of `entry` simulates the state of the last call of `find`.
bool Covering::is_below(const Entry& entry) const {
    for (std::size_t i = 0; i < values_.size(); ++i)
        if (stored_[entry.values + i] > values_[i]) return false;
    return true;
}

/// True if the state of the last call of `find` simulates the state of `entry`.
bool Covering::is_above(const Entry& entry) const {
    for (std::size_t i = 0; i < values_.size(); ++i)
        if (stored_[entry.values + i] < values_[i]) return false;
    return true;
}

void Covering::add(std::uint32_t state) {
    // The new state replaces the entries that it simulates, because the new state also simulates all states that these
    // entries simulate.
    std::uint32_t replaced = none;
    for (std::uint32_t* link = &lists_[key_]; *link != none;) {
        Entry& entry = entries_[*link];
        if (!is_above(entry)) {
            link = &entry.next;
        } else if (replaced == none) {
            replaced = *link;
            link = &entry.next;
        } else {
            *link = entry.next;
        }
    }
    if (replaced != none) {
        entries_[replaced].state = state;
        for (std::size_t i = 0; i < values_.size(); ++i) stored_[entries_[replaced].values + i] = values_[i];
        return;
    }
    if (length_ >= most_entries) return;
    entries_.push_back({state, lists_[key_], stored_.size()});
    stored_.append(values_.data(), values_.size());
    lists_[key_] = static_cast<std::uint32_t>(entries_.size() - 1);
}

std::size_t Covering::bytes() const { return keys_.bytes() + lists_.bytes() + entries_.bytes() + stored_.bytes(); }

}  // namespace grafverif::timed
