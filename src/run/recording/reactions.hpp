// SPDX-License-Identifier: MIT
// Reactions: the reactions of a chart to its inputs and to elapsed times, without the times themselves. The interpreter
// computes the reactions on a copy of the chart in which each duration is 2 ms. In this copy, the elapsed time of a
// running delay is 1 ms, and that of an expired delay is 2 ms. The caller knows the real times and decides which delays
// have expired.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "run/interpreter.hpp"

namespace grafverif {

using StatePointer = std::shared_ptr<const State>;

/// Appends the bytes of a number to the key of a table.
inline void append_number(std::string& key, std::uint64_t value) {
    for (unsigned byte = 0; byte < 8; ++byte) key += static_cast<char>(value >> (8U * byte));
}

/// The result of one cycle with stability search.
struct Reaction {
    StatePointer before = {}, after = {};
    std::vector<std::vector<Id<Chart::Transition>>> fired = {};  ///< cleared transitions per evolution
    /// For each timed element: true if its rise time t1 (`rise_starts`) or its fall time t2 (`fall_starts`) starts in
    /// this cycle.
    std::vector<bool> rise_starts = {}, fall_starts = {};
    std::string problem = {};  ///< reason why the cycle has no result; empty if the cycle has a result
};

class Reactions {
public:
    /// Requires a chart that `derive` accepts. The tables are cleared when their approximate size exceeds `most_bytes`.
    Reactions(const Chart& chart, std::size_t most_bytes);

    /// Returns the executed copy of the chart. The durations in the copy differ from the durations in the original
    /// chart.
    const Chart& chart() const { return chart_; }

    StatePointer initial() { return unique(power_on(chart_)); }

    /// Executes a cycle. `inputs` contains the value of each variable of the chart that is an input; `rise_over`
    /// contains, for each timed element, true if its running t1 has elapsed since the previous cycle; `fall_over`
    /// contains the same for t2.
    std::shared_ptr<const Reaction> react(const StatePointer& before, const std::vector<std::int64_t>& inputs,
                                          const std::vector<bool>& rise_over, const std::vector<bool>& fall_over);

private:
    StatePointer unique(State state);

    Chart chart_;
    std::vector<TimedElement> elements_;
    // The tables are limited, because a chart with counters can have any number of states. Equal states are the same
    // object only as long as the table contains them.
    std::size_t most_bytes_, bytes_ = 0;
    std::unordered_map<std::string, StatePointer> states_ = {};
    std::unordered_map<std::string, std::shared_ptr<const Reaction>> reactions_ = {};
};

/// True if the rise time (`rises`) or the fall time (`falls`) of an element is running after a reaction.
inline bool rises(const Timing& timing) { return timing.risen == 1; }
inline bool falls(const Timing& timing) { return timing.fallen == 1; }

}  // namespace grafverif
