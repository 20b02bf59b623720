// SPDX-License-Identifier: MIT
// Lockstep execution of two charts according to IEC 60848 on the same scans.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/comparison.hpp"

namespace grafverif {

/// The inputs or outputs of a chart, in order.
std::vector<Comparison::Variable> plugs(const Chart& chart, Chart::VariableKind kind);

/// Two charts with the same inputs and outputs, each in any order. They must outlive this object.
class Lockstep {
public:
    Lockstep(const Chart& a, const Chart& b, ExecutionMode mode);

    /// Responses of both to each scan, in the order of the first chart's inputs and outputs, up to the first scan in
    /// which one stops.
    std::array<std::vector<Comparison::ScanOutputs>, 2> answers(const std::vector<Comparison::Scan>& scans) const;

    /// The first scan with different responses; both have responded to all scans before it.
    std::optional<std::size_t> difference(const std::vector<Comparison::Scan>& scans) const;

    /// A shorter or simpler sequence of scans with a difference in the last one: less time between scans (0, or one of
    /// `times`), fewer input changes, within the constraints of both.
    std::vector<Comparison::Scan> simplified(std::vector<Comparison::Scan> scans,
                                             const std::vector<std::int64_t>& times) const;

private:
    bool possible(const Comparison::Scan& scan) const;

    std::array<const Chart*, 2> charts_;
    ExecutionMode mode_;
    std::array<std::vector<std::size_t>, 2> inputs_ = {}, outputs_ = {};  ///< per input or output of the chart: the
                                                                          ///< index in the first chart
};

}  // namespace grafverif
