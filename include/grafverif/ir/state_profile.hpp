// SPDX-License-Identifier: MIT
// StateProfile: the components and clocks that contribute most states of an explicit-state search. The *factor* of a
// component is the number of sampled states divided by the number of states that remain if states that differ only in
// this component are merged. The factor is 1 if the state of the other components determines the component. The factor
// is k if the component has k values for each state of the other components.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/support/source.hpp"

namespace grafverif {

struct StateProfile {
    /// Ratio of sampled states to merged states; `merged` >= 1.
    struct Factor {
        std::uint64_t states = 1;
        std::uint64_t merged = 1;
        double value() const { return static_cast<double>(states) / static_cast<double>(merged); }
        bool operator==(const Factor&) const = default;
    };
    enum class Kind { Instance, Controller, Environment };
    /// An instance, or a controller with its timers, together with the variables that only it writes.
    struct Component {
        std::string name = {};
        Kind kind = Kind::Instance;
        /// Number of distinct states of this component in the sample; counted up to `most_combinations`.
        std::uint64_t combinations = 0;
        Factor factor = {};
        Span origin = {};
        std::string place = {};  ///< `file:line` of the declaration, if the sources are available
        bool operator==(const Component&) const = default;
    };
    struct Clock {
        std::string process = {};
        std::string name = {};
        std::int64_t greatest = 0;  ///< the largest constant with which the clock is compared, in time units
        std::uint64_t values = 0;   ///< number of distinct values of the clock in the sample
        Factor factor = {};
        Span origin = {};        ///< position of the constant `greatest`
        std::string place = {};  ///< `file:line` of the constant `greatest`, if the sources are available
        bool operator==(const Clock&) const = default;
    };

    /// A single duration that determines the time unit: without this duration the unit would be coarser.
    struct Finest {
        std::int64_t duration_ms = 0;  ///< the duration; 0 represents the time unit that the loop declares
        std::int64_t unit_ms = 0;      ///< time unit of the network in ms
        std::int64_t coarser_ms = 0;   ///< time unit in ms if the duration is ignored
        Factor factor = {};            ///< factor if states whose clock values are equal in the coarser unit are merged
        Span origin = {};
        std::string place = {};  ///< `file:line` of the duration, if the sources are available
        bool operator==(const Finest&) const = default;
    };

    std::uint64_t states = 0;   ///< total number of states found
    std::uint64_t sampled = 0;  ///< number of sampled states; these are the states that were found first
    std::uint64_t most_combinations = 0;
    std::uint64_t inside_cycles = 0;    ///< number of sampled states in which some controller is within a cycle
    std::vector<Component> parts = {};  ///< components, in decreasing order of their factors
    std::vector<Clock> clocks = {};     ///< clocks, in decreasing order of their factors
    std::optional<Finest> finest = {};
    bool operator==(const StateProfile&) const = default;
};

}  // namespace grafverif
