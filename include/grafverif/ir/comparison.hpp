// SPDX-License-Identifier: MIT
// Comparison: result of comparing two charts with the same inputs and outputs. Each of the two charts can be a PLC
// program. The result states if the outputs of both charts are equal for every sequence of scans, and lists the textual
// differences.
//
// A scan is one cycle of a PLC: inputs are read, and outputs are written in stable situations or in every cycle,
// according to `mode`. The charts are equal if, after every scan of every sequence, both charts have written the same
// outputs or both charts have stopped. Inputs are arbitrary, and the time between scans is any multiple of
// `resolution_ms`. A chart stops at a race, at an undefined or out-of-range value, or if a scan does not reach a stable
// situation; a program stops at a run-time fault. The behaviour after a stop and the events within a scan are not
// compared.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/type.hpp"

namespace grafverif {

/// A textual difference between the charts: a step, a transition, an action or a variable.
struct ChartChange {
    enum class Kind { Added, Removed, Changed, Renamed };
    Kind kind = Kind::Changed;
    /// The changed element, such as `step 2`, `transition t3`, `input START` or `action of step 2`.
    std::string subject = {};
    /// Text in the first and in the second chart; the first is empty for an addition, the second for a removal.
    std::string before = {}, after = {};
    bool operator==(const ChartChange&) const = default;
};

struct Comparison {
    enum class Outcome { Equal, Different, Unknown };
    struct Variable {
        std::string name = {};
        Type type = {};
        /// For an enumeration: the names of the values 0, 1, ...; otherwise empty.
        std::vector<std::string> values = {};
        bool duration = false;  ///< true for a duration in milliseconds
        bool operator==(const Variable&) const = default;
    };
    struct Scan {
        std::int64_t wait_ms = 0;               ///< time since the previous scan
        std::vector<std::int64_t> inputs = {};  ///< values in the order of Comparison::inputs
        bool operator==(const Scan&) const = default;
    };
    /// Response of a chart to a scan.
    struct ScanOutputs {
        std::vector<std::int64_t> outputs = {};  ///< values in the order of Comparison::outputs
        std::string situation = {};              ///< situation after the scan: `{2, 5}`
        std::string stop = {};                   ///< reason why the chart wrote no outputs; empty if it wrote outputs
        bool run_time_fault = false;             ///< true if `stop` reports a run-time fault of a program

        /// True if the outputs of both responses are equal, or both charts have stopped.
        bool same(const ScanOutputs& other) const {
            return stop.empty() == other.stop.empty() && (!stop.empty() || outputs == other.outputs);
        }
        bool operator==(const ScanOutputs&) const = default;
    };

    std::array<std::string, 2> charts = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    /// Selected initial situations; an empty text represents the initial steps of the chart.
    std::array<std::string, 2> from = {};
    /// The time between scans is a multiple of this value; 0 if no output depends on time.
    std::int64_t resolution_ms = 0;
    std::array<bool, 2> programs = {};             ///< for each side: true for a PLC program, false for a chart
    std::optional<std::int64_t> interval_ms = {};  ///< fixed time between two scans; empty if this time is arbitrary

    /// `ignored`: outputs that are not compared. `restricted`: inputs of a program to which only the values in the
    /// range of the corresponding input of the chart are applied.
    std::vector<std::string> ignored = {}, restricted = {};
    /// For each program: name of the output that reports a stop by a value other than 0; empty if there is no such
    /// output.
    std::array<std::string, 2> stop_outputs = {};
    bool settles = false;  ///< true if programs repeat each scan until no variable changes

    /// `faulty`: a run-time fault occurs in the last scan; `constrained`: constraints are assumed.
    bool faulty = false, constrained = false;
    std::vector<Variable> inputs = {}, outputs = {};
    Outcome outcome = Outcome::Unknown;
    std::string reason = {};       ///< reason for an unknown outcome
    std::vector<Scan> scans = {};  ///< distinguishing sequence; its last scan distinguishes the charts
    std::array<std::vector<ScanOutputs>, 2> answers = {};  ///< responses of both charts to each scan
    bool shortest = false;                                 ///< true if there is no shorter distinguishing sequence
    std::vector<ChartChange> changes = {};
    std::vector<std::string> failures = {};  ///< internal errors: sequences that the replay does not confirm
    double seconds = 0;

    bool operator==(const Comparison&) const = default;
};

/// Return the outcome (such as `equal`) or the type of change (such as `added`) as a word.
std::string_view word(Comparison::Outcome outcome);
std::string_view word(ChartChange::Kind kind);

}  // namespace grafverif
