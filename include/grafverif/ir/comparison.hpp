// SPDX-License-Identifier: MIT
// Comparison: whether two charts with the same inputs and outputs answer every sequence of scans alike, and what their texts
// say that is not the same.
//
// A scan is one cycle of a PLC: inputs are read, outputs are written as the mode has it. The charts are equal where after
// every scan of every sequence, whatever the inputs are and however much time passes between scans, in steps of
// `resolution_ms`, both have written the same outputs, or both have stopped: by a race, a value that does not exist or fit, or
// for want of a stable situation. What comes after a stop is not looked at.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/type.hpp"

namespace grafverif {

/// One place where the text of a chart is another: a step, a transition, an action, a variable.
struct ChartChange {
    enum class Kind { Added, Removed, Changed, Renamed };
    Kind kind = Kind::Changed;
    std::string subject = {};             ///< `step 2`, `transition t3`, `input START`, `action of step 2`
    std::string before = {}, after = {};  ///< as the text has it; of what was added or removed one is empty
    bool operator==(const ChartChange&) const = default;
};

struct Comparison {
    enum class Outcome { Equal, Different, Unknown };
    struct Variable {
        std::string name = {};
        Type type = {};
        bool operator==(const Variable&) const = default;
    };
    struct Scan {
        std::int64_t wait_ms = 0;               ///< since the scan before
        std::vector<std::int64_t> inputs = {};  ///< in the order of Comparison::inputs
        bool operator==(const Scan&) const = default;
    };
    /// What a chart does in a scan.
    struct Answer {
        std::vector<std::int64_t> outputs = {};  ///< in the order of Comparison::outputs
        std::string situation = {};              ///< after it: `{2, 5}`
        std::string stop = {};                   ///< why there is none; empty: there is
        /// Whether somebody at the outputs sees the same.
        bool same(const Answer& other) const {
            return stop.empty() == other.stop.empty() && (!stop.empty() || outputs == other.outputs);
        }
        bool operator==(const Answer&) const = default;
    };

    std::array<std::string, 2> charts = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::array<std::string, 2> from = {};  ///< the situations that both begin with, as asked for; empty: their own
    std::int64_t resolution_ms = 0;        ///< time passes in whole multiples of it; 0: neither chart knows time
    bool constrained = false;              ///< the constraints of both are assumed
    std::vector<Variable> inputs = {}, outputs = {};
    Outcome outcome = Outcome::Unknown;
    std::string reason = {};                          ///< of an unknown outcome
    std::vector<Scan> scans = {};                     ///< of different charts: what tells them apart, in the last scan
    std::array<std::vector<Answer>, 2> answers = {};  ///< per scan
    bool shortest = false;                            ///< no sequence of fewer scans does
    std::vector<ChartChange> changes = {};
    std::vector<std::string> failures = {};  ///< ours: a sequence that the rules do not confirm
    double seconds = 0;

    bool operator==(const Comparison&) const = default;
};

/// `equal`, `different`, `unknown`.
std::string_view word(Comparison::Outcome outcome);
/// `added`, `removed`, `changed`, `renamed`.
std::string_view word(ChartChange::Kind kind);

}  // namespace grafverif
