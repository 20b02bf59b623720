// SPDX-License-Identifier: MIT
// Lockstep execution of two charts according to IEC 60848 on the same scans.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/comparison.hpp"

namespace grafverif {

/// Returns the inputs or outputs of a chart, in order.
std::vector<Comparison::Variable> plugs(const Chart& chart, Chart::VariableKind kind);

/// Two charts with the same inputs and outputs, which may be in different orders. The charts must outlive this object.
class Lockstep {
public:
    Lockstep(const Chart& a, const Chart& b, ExecutionMode mode);

    /// Returns the responses of both charts to each scan, in the order of the first chart's inputs and outputs. The
    /// last scan is the first one in which a chart stops.
    std::array<std::vector<Comparison::ScanOutputs>, 2> answers(const std::vector<Comparison::Scan>& scans) const;

    /// Returns the first scan with different responses. Both charts have responded to all scans before it.
    std::optional<std::size_t> difference(const std::vector<Comparison::Scan>& scans) const;

    /// Returns a shorter or simpler sequence of scans with a difference in the last scan. It has less time between
    /// scans (0, or one of `times`) and fewer input changes, and satisfies the constraints of both charts.
    std::vector<Comparison::Scan> simplified(std::vector<Comparison::Scan> scans,
                                             const std::vector<std::int64_t>& times) const;

private:
    bool possible(const Comparison::Scan& scan) const;

    std::array<const Chart*, 2> charts_;
    ExecutionMode mode_;
    /// For each input or output of the chart: its index in the first chart.
    std::array<std::vector<std::size_t>, 2> inputs_ = {}, outputs_ = {};
};

}  // namespace grafverif
