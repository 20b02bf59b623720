// SPDX-License-Identifier: MIT
// Packed states, each stored once and numbered in the order of discovery.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace grafverif::conform {

using StateId = std::uint32_t;
inline constexpr StateId no_state = std::numeric_limits<StateId>::max();

class StateStore {
public:
    /// The number of 64-bit words of a state. Called once, before the first state.
    void shape(std::size_t words) { words_ = words; }

    std::size_t words() const { return words_; }
    std::size_t size() const { return words_ == 0 ? 0 : packed_.size() / words_; }
    std::span<const std::uint64_t> at(StateId state) const { return {packed_.data() + std::size_t{state} * words_, words_}; }

    /// The number of the state, new or known.
    StateId intern(std::span<const std::uint64_t> state);

private:
    bool is(StateId state, std::span<const std::uint64_t> words) const;
    void grow();

    std::size_t words_ = 0;
    std::vector<std::uint64_t> packed_ = {};
    std::vector<StateId> slots_ = std::vector<StateId>(64, no_state);   ///< open addressing
};

}  // namespace grafverif::conform
