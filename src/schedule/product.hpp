// SPDX-License-Identifier: MIT
// schedule_both: translates the Equations of two charts to a TransitionSystem, their product. Both are executed scan by
// scan as by a PLC: inputs are read, the chart computes its outputs, and time passes. Inputs and times are arbitrary,
// but the same for both charts.
//
// A step of the system is one evolution of both charts or, if both have answered the scan (`waits`), the time until the
// next scan and its inputs. Under stability search the inputs are constant until both charts are quiescent; a chart
// that is quiescent earlier continues without changes. In every_cycle mode a scan is one evolution. A fault (race,
// value out of range, undefined value) is also an answer, and permanent.
//
//   timer        counts down in units of `unit_ms`: the remaining t1 while its term holds, the remaining t2 after it
//                fell; scans occur at multiples of the unit. The caller chooses the unit, and hence the resolution
//   same         never: both have answered, and exactly one has a fault, or an output differs
//   possible     reachable: there are inputs that satisfy the constraints of both
//   a_follows, b_follows   if b has answered without a fault, a answers eventually. Otherwise a never becomes stable
//                although b does. A fault in one chart and instability of the other do not count as a difference. Only
//                under stability search
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/transition_system.hpp"

namespace grafverif {

struct ProductOptions {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::int64_t unit_ms = 1;                      ///< divides all durations of both charts
    std::optional<std::int64_t> fewer_scans = {};  ///< restricts `same` to runs with fewer scans than this
};

struct ProductMachine {
    TransitionSystem system = {};
    std::vector<Id<TransitionSystem::Symbol>> inputs = {};  ///< inputs in the order of the first chart
    Id<TransitionSystem::Symbol> waits = {};                ///< true if both charts have answered the scan
    Id<TransitionSystem::Symbol> passed =
        {};  ///< in a step from such a state: time units until the next scan; invalid if there are no timers
};

/// Requires that both charts have equal inputs and outputs with equal types, and that verify is empty for both.
ProductMachine schedule_both(const Equations& a, const Equations& b, const ProductOptions& options);

}  // namespace grafverif
