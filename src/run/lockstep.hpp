// SPDX-License-Identifier: MIT
// Executes two controllers in lockstep on the same scans. A controller is a chart, executed according to IEC 60848, or
// a PLC program, executed by ProgramRun.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/comparison.hpp"
#include "run/program/interpreter.hpp"

namespace grafverif {

/// One of the two controllers. The chart or program must outlive the execution.
struct LockstepSide {
    const Chart* chart = nullptr;
    const Program* program = nullptr;      ///< null if the controller is a chart
    std::vector<std::size_t> inputs = {};  ///< for each input of the controller: its index in Comparison::inputs
    /// For each of Comparison::outputs: index among the outputs of the chart, or cell of the program.
    std::vector<std::size_t> outputs = {};
    std::optional<std::size_t> stop = {};  ///< cell of a program that reports a stop by a value other than 0
    /// Cells of a program: each scan is repeated until the values of these cells are unchanged. Empty if each scan is
    /// executed once.
    std::optional<std::vector<std::size_t>> settled = {};
    std::function<std::string(const ProgramRun::Fault&)> fault_text = {};
};

class Lockstep {
public:
    Lockstep(std::array<LockstepSide, 2> sides, ExecutionMode mode, std::vector<Comparison::Variable> inputs)
        : sides_(std::move(sides)), mode_(mode), inputs_(std::move(inputs)) {}

    /// Returns the responses of both controllers to each scan, in the order of Comparison::inputs and outputs. The
    /// execution ends after the first scan in which a controller stops.
    std::array<std::vector<Comparison::ScanOutputs>, 2> answers(const std::vector<Comparison::Scan>& scans) const;

    /// Returns the first scan in which the responses of the two controllers differ. No controller stops before this
    /// scan.
    std::optional<std::size_t> difference(const std::vector<Comparison::Scan>& scans) const;

    /// Returns a simpler sequence of the same length that also ends with the first difference. If possible, the simpler
    /// sequence has less time between scans (0, or one of `times`) and fewer input changes. If `times` is empty, the
    /// time between scans is unchanged. The sequence satisfies the constraints of both charts.
    std::vector<Comparison::Scan> simplified(std::vector<Comparison::Scan> scans,
                                             const std::vector<std::int64_t>& times) const;

private:
    bool possible(const Comparison::Scan& scan) const;

    std::array<LockstepSide, 2> sides_;
    ExecutionMode mode_;
    std::vector<Comparison::Variable> inputs_;
};

}  // namespace grafverif
