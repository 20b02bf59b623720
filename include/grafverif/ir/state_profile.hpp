// SPDX-License-Identifier: MIT
// StateProfile: in what the states of an explicit search differ, so that somebody can see which parts of a model
// multiply. A thing *multiplies by* the number of sampled states over the number that is left when states that differ
// in that thing alone are one: 1 where the rest determines it, k where it takes k values beside each state of the rest.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/support/source.hpp"

namespace grafverif {

struct StateProfile {
    /// Sampled states per state of the rest; `merged` is 1 at least.
    struct Factor {
        std::uint64_t states = 1;
        std::uint64_t merged = 1;
        double value() const { return static_cast<double>(states) / static_cast<double>(merged); }
        bool operator==(const Factor&) const = default;
    };
    enum class Kind { Instance, Controller, Environment };
    /// An instance, or a controller with its timers, and the variables that it alone writes.
    struct Part {
        std::string name = {};
        Kind kind = Kind::Instance;
        std::uint64_t combinations = 0;  ///< of its own values, seen in the sample; `most_combinations`: or more
        Factor factor = {};
        Span origin = {};
        std::string place = {};  ///< `file:line`, where somebody with the sources has looked it up
        bool operator==(const Part&) const = default;
    };
    struct Clock {
        std::string process = {};
        std::string name = {};
        std::int64_t greatest = 0;  ///< the largest constant it is compared with; in time units
        std::uint64_t values = 0;   ///< seen in the sample
        Factor factor = {};
        Span origin = {};        ///< of that constant
        std::string place = {};  ///< as above
        bool operator==(const Clock&) const = default;
    };

    /// A duration without which the time unit would be coarser.
    struct Finest {
        std::int64_t duration_ms = 0;  ///< 0: it is the unit that the loop names
        std::int64_t unit_ms = 0;      ///< that there is
        std::int64_t coarser_ms = 0;   ///< that there would be
        Factor factor = {};            ///< of the parts of clocks that a clock in the coarser unit would not tell apart
        Span origin = {};
        std::string place = {};  ///< as above
        bool operator==(const Finest&) const = default;
    };

    std::uint64_t states = 0;   ///< found
    std::uint64_t sampled = 0;  ///< the first of them
    std::uint64_t most_combinations = 0;
    std::uint64_t inside_cycles = 0;  ///< of those sampled: some controller is neither waiting nor yet to start
    std::vector<Part> parts = {};     ///< the largest factor first
    std::vector<Clock> clocks = {};   ///< the largest factor first
    std::optional<Finest> finest = {};
    bool operator==(const StateProfile&) const = default;
};

}  // namespace grafverif
