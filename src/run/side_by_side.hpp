// SPDX-License-Identifier: MIT
// Two charts run side by side on the rules of IEC 60848, over the same scans.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/comparison.hpp"

namespace grafverif {

/// The inputs or outputs of a chart, in order.
std::vector<Comparison::Variable> plugs(const Chart& chart, Chart::VariableKind kind);

/// Two charts with the same inputs and outputs, each in any order. They outlive it.
class SideBySide {
public:
    SideBySide(const Chart& a, const Chart& b, ExecutionMode mode);

    /// What each does in each scan, in the order of the first chart's inputs and outputs; up to the first in which one stops.
    std::array<std::vector<Comparison::Answer>, 2> answers(const std::vector<Comparison::Scan>& scans) const;

    /// The first scan that the charts answer differently; both have answered all scans before it.
    std::optional<std::size_t> difference(const std::vector<Comparison::Scan>& scans) const;

    /// Scans that differ in the last one like `scans`, with less time between them (0, or one of `times`), inputs that
    /// change less often, within the constraints of both.
    std::vector<Comparison::Scan> simplified(std::vector<Comparison::Scan> scans,
                                             const std::vector<std::int64_t>& times) const;

private:
    bool possible(const Comparison::Scan& scan) const;

    std::array<const Chart*, 2> charts_;
    ExecutionMode mode_;
    std::array<std::vector<std::size_t>, 2> inputs_ = {}, outputs_ = {};  ///< per plug of the chart: that of the first
};

}  // namespace grafverif
