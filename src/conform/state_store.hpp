// SPDX-License-Identifier: MIT
// StateStore: stores states, which are the values that the chart keeps between evolutions. States are packed into
// words, and equal states are stored only once (hash consing).
//
// A state contains step activities, stored variables, previous values, and the levels that timers observe. For each
// timer, a state also contains the events of the observed level in the current instant: the level became true
// (`fresh`), or the fall time of the timer may have started (`falling`).
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "conform/location_terms.hpp"
#include "grafverif/ir/equations.hpp"

namespace grafverif::conform {

using PackedState = std::vector<std::uint64_t>;

/// The positions of the fields in a packed state.
struct StateLayout {
    struct Field {
        Kept kept = {};
        Type type = {};
        std::uint32_t word = 0, shift = 0;
        std::uint64_t mask = 0;  ///< mask of the value, not shifted
    };
    struct Timer {
        std::uint32_t fresh = 0, falling = 0;  ///< bit positions of the two marks
        std::uint32_t level = 0;               ///< bit position of the observed level
    };

    explicit StateLayout(const Equations& equations);

    std::int64_t value(std::span<const std::uint64_t> state, std::uint32_t field) const;
    void set(PackedState& state, std::uint32_t field, std::int64_t value) const;

    std::vector<Field> fields = {};  ///< fields of a state; the fields of observed levels are last
    std::size_t evolving = 0;        ///< number of fields before the fields of observed levels
    std::vector<Timer> timers = {};
    std::size_t words = 1;  ///< number of 64-bit words
};

bool has_bit(std::span<const std::uint64_t> state, std::uint32_t bit);
void set_bit(PackedState& state, std::uint32_t bit, bool value);

using StateId = std::uint32_t;
inline constexpr StateId no_state = std::numeric_limits<StateId>::max();

/// The states of one layout, numbered in the order in which they are stored.
class StateStore {
public:
    explicit StateStore(std::size_t words) : words_(words) {}

    std::size_t size() const { return packed_.size() / words_; }
    std::span<const std::uint64_t> at(StateId state) const {
        return {packed_.data() + std::size_t{state} * words_, words_};
    }

    /// Returns the number of the state `state`. If the state is not in the store, adds it.
    StateId intern(std::span<const std::uint64_t> state);

private:
    void grow();

    std::size_t words_ = 1;
    std::vector<std::uint64_t> packed_ = {};
    std::vector<StateId> slots_ = std::vector<StateId>(64, no_state);  ///< hash table with open addressing
};

}  // namespace grafverif::conform
