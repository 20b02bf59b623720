// SPDX-License-Identifier: MIT
// Whether to stop, asked once in so many steps of any kind, so that it costs nothing and comes in time: a step takes
// well below a microsecond.
#pragma once

#include <cstdint>

#include "bdd/bdd.hpp"

namespace grafverif::bdd {

class Watch {
public:
    explicit Watch(const BddLimits& limits) : limits_(limits) {}

    /// Ends with BddExhausted where somebody asked to stop.
    void step(std::uint32_t steps = 1) {
        left_ -= steps;
        if (left_ <= 0) look();
    }

    std::uint64_t work() const { return done_ + static_cast<std::uint64_t>(steps_per_look - left_); }

private:
    static constexpr std::int64_t steps_per_look = 2048;

    void look();

    BddLimits limits_ = {};
    std::uint64_t done_ = 0;  ///< when it last looked
    std::int64_t left_ = steps_per_look;
};

}  // namespace grafverif::bdd
