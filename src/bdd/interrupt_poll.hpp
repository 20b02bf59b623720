// SPDX-License-Identifier: MIT
// Polls the stop flag, the deadline and the work limit once in a fixed number of operation steps, so that the cost of
// polling is negligible. The poll detects the stop flag soon after it is set, because one operation step takes far less
// than a microsecond.
#pragma once

#include <cstdint>

#include "bdd/bdd.hpp"

namespace grafverif::bdd {

class InterruptPoll {
public:
    explicit InterruptPoll(const BddLimits& limits) : limits_(limits) {}

    /// Counts `steps` operation steps and polls if necessary. Throws BddExhausted if a poll finds that a limit is
    /// reached or the stop flag is set.
    void step(std::uint32_t steps = 1) {
        left_ -= steps;
        if (left_ <= 0) look();
    }

    std::uint64_t work() const { return done_ + static_cast<std::uint64_t>(steps_per_poll - left_); }

private:
    static constexpr std::int64_t steps_per_poll = 2048;

    void look();

    BddLimits limits_ = {};
    std::uint64_t done_ = 0;  ///< number of steps at the last poll
    std::int64_t left_ = steps_per_poll;
};

}  // namespace grafverif::bdd
