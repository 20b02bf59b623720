// SPDX-License-Identifier: MIT
// Comparison: result of comparing two charts with the same inputs and outputs. Either of them can be a PLC program.
// The result states if their outputs are equal for every sequence of scans, and lists the textual differences.
//
// A scan is one cycle of a PLC: inputs are read, and outputs are written according to the mode. The charts are equal
// if, after every scan of every sequence, both have written the same outputs or both have stopped. Inputs are
// arbitrary, and the time between scans is any multiple of `resolution_ms`. A chart stops at a race, at an undefined or
// out-of-range value, or without a stable situation; a program stops at a run-time fault. Behaviour after a stop, and
// events within a scan, are not compared.
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
    std::string subject = {};             ///< `step 2`, `transition t3`, `input START`, `action of step 2`
    std::string before = {}, after = {};  ///< text of both versions; one is empty if the element was added or removed
    bool operator==(const ChartChange&) const = default;
};

struct Comparison {
    enum class Outcome { Equal, Different, Unknown };
    struct Variable {
        std::string name = {};
        Type type = {};
        std::vector<std::string> values = {};  ///< names of the values of an enumeration, from 0; otherwise empty
        bool duration = false;                 ///< true for a duration in milliseconds
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
        std::string stop = {};                   ///< reason why there are no outputs; empty if outputs exist
        bool run_time_fault = false;             ///< true if the reason is a run-time fault of a program
        /// True if both responses have equal outputs, or both have stopped.
        bool same(const ScanOutputs& other) const {
            return stop.empty() == other.stop.empty() && (!stop.empty() || outputs == other.outputs);
        }
        bool operator==(const ScanOutputs&) const = default;
    };

    std::array<std::string, 2> charts = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::array<std::string, 2> from = {};  ///< selected initial situations; those of the charts if empty
    std::int64_t resolution_ms = 0;        ///< time between scans is a multiple of it; 0 if nothing depends on time
    std::array<bool, 2> programs = {};     ///< true for a PLC program in place of a chart
    std::optional<std::int64_t> interval_ms = {};  ///< fixed time between two scans
    /// `ignored`: outputs that are not compared. `restricted`: inputs of a program that have only the values of the
    /// chart's input.
    std::vector<std::string> ignored = {}, restricted = {};
    /// Output of each program whose value other than 0 reports a stop; empty if there is none.
    std::array<std::string, 2> stop_outputs = {};
    bool settles = false;                      ///< programs repeat each scan until nothing changes
    bool faulty = false, constrained = false;  ///< a run-time fault is in the last scan; constraints are assumed
    std::vector<Variable> inputs = {}, outputs = {};
    Outcome outcome = Outcome::Unknown;
    std::string reason = {};       ///< reason for an unknown outcome
    std::vector<Scan> scans = {};  ///< distinguishing sequence; its last scan distinguishes the charts
    std::array<std::vector<ScanOutputs>, 2> answers = {};  ///< responses of both charts to each scan
    bool shortest = false;                                 ///< true if there is no shorter distinguishing sequence
    std::vector<ChartChange> changes = {};
    std::vector<std::string> failures = {};  ///< internal errors: distinguishing sequences that fail the replay
    double seconds = 0;

    bool operator==(const Comparison&) const = default;
};

/// Return a word such as `equal` or `added`.
std::string_view word(Comparison::Outcome outcome);
std::string_view word(ChartChange::Kind kind);

}  // namespace grafverif
