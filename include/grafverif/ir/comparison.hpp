// SPDX-License-Identifier: MIT
// Comparison: result of comparing two charts with the same inputs and outputs: equality for every sequence of scans,
// and textual differences.
//
// A scan is one cycle of a PLC: inputs are read, outputs are written according to the mode. The charts are equal if,
// after every scan of every sequence, both have written the same outputs or both have stopped. Inputs are arbitrary,
// and the time between scans is any multiple of `resolution_ms`. A chart stops by a race, an undefined or out-of-range
// value, or if no stable situation exists. Scans after a stop are not compared.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/type.hpp"

namespace grafverif {

/// A textual difference between the charts: a step, a transition, an action, a variable.
struct ChartChange {
    enum class Kind { Added, Removed, Changed, Renamed };
    Kind kind = Kind::Changed;
    std::string subject = {};             ///< `step 2`, `transition t3`, `input START`, `action of step 2`
    std::string before = {}, after = {};  ///< as in the text; one is empty if it was added or removed
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
        std::int64_t wait_ms = 0;               ///< since the previous scan
        std::vector<std::int64_t> inputs = {};  ///< in the order of Comparison::inputs
        bool operator==(const Scan&) const = default;
    };
    /// Response of a chart to a scan.
    struct ScanOutputs {
        std::vector<std::int64_t> outputs = {};  ///< in the order of Comparison::outputs
        std::string situation = {};              ///< after it: `{2, 5}`
        std::string stop = {};                   ///< reason why there are no outputs; empty if there are
        /// True if the responses are equal at the outputs.
        bool same(const ScanOutputs& other) const {
            return stop.empty() == other.stop.empty() && (!stop.empty() || outputs == other.outputs);
        }
        bool operator==(const ScanOutputs&) const = default;
    };

    std::array<std::string, 2> charts = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::array<std::string, 2> from = {};  ///< initial situations selected by the user; empty: those of the charts
    std::int64_t resolution_ms = 0;        ///< time passes in multiples of it; 0: both charts are independent of time
    bool constrained = false;              ///< the constraints of both are assumed
    std::vector<Variable> inputs = {}, outputs = {};
    Outcome outcome = Outcome::Unknown;
    std::string reason = {};                               ///< if the outcome is unknown
    std::vector<Scan> scans = {};                          ///< if different: the last scan distinguishes the charts
    std::array<std::vector<ScanOutputs>, 2> answers = {};  ///< per scan
    bool shortest = false;                                 ///< no shorter sequence exists
    std::vector<ChartChange> changes = {};
    std::vector<std::string> failures = {};  ///< internal errors: a sequence that fails the replay
    double seconds = 0;

    bool operator==(const Comparison&) const = default;
};

/// `equal`, `different`, `unknown`.
std::string_view word(Comparison::Outcome outcome);
/// `added`, `removed`, `changed`, `renamed`.
std::string_view word(ChartChange::Kind kind);

}  // namespace grafverif
