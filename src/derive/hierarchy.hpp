// SPDX-License-Identifier: MIT
// Hierarchy of a chart: what macro-steps, enclosing steps and forcing orders mean for its plain steps.
//
// An expansion belongs to the chart of its macro-step: entering the macro-step enters the entry step, its exit step
// stands for it upstream of transitions (IEC 60848, 4.5.3). The region of a partial chart are its steps and those of the
// expansions in it; a region is enclosed or forced as a whole.
//
// No chart encloses or forces itself, over however many levels: that gives the charts an order.
#pragma once

#include <optional>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

struct Hierarchy {
    /// Per step: what is activated in its place, and what is active in its place when it can be left: itself, or of a
    /// macro-step the entry and the exit step of its expansion.
    std::vector<Id<Chart::Step>> entered = {}, left = {};
    /// Per partial chart: the chart it is part of, as an expansion or an expansion in one; else itself.
    std::vector<Id<Chart::PartialChart>> home = {};
    /// Homes, each after those that enclose it or force something in it.
    std::vector<Id<Chart::PartialChart>> order = {};
    std::vector<std::vector<Id<Chart::Step>>> region = {};           ///< per partial chart
    std::vector<std::vector<Id<Chart::ForcingOrder>>> orders = {};   ///< per partial chart: those that its region is under
    std::vector<std::vector<Id<Chart::Step>>> forced = {};           ///< per order: the steps it makes active, sorted
    std::vector<bool> initial = {};                                  ///< per step: active at power-on
};

/// Nothing after adding an error: a cycle, or a chart that one step forces twice.
std::optional<Hierarchy> hierarchy(const Chart& chart, Diagnostics& diagnostics);

/// Whether the two orders cannot be obeyed together.
bool conflict(const Chart& chart, const Hierarchy& hierarchy, Id<Chart::ForcingOrder> one,
              Id<Chart::ForcingOrder> other);

}  // namespace grafverif
