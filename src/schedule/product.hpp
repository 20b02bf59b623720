// SPDX-License-Identifier: MIT
// schedule_both: translates the Equations of two charts to a TransitionSystem, their product. Both are executed scan by
// scan as by a PLC: inputs are read, the chart computes its outputs, and time passes. Inputs and times are arbitrary,
// but the same for both charts. Either of them can be a PLC program, whose scan is one step.
//
// A step of the system is one evolution of both charts. If both have completed the scan (`waits`), a step instead
// chooses the next inputs and the time until the next scan. Under stability search the inputs are constant until both
// charts are quiescent; a chart that is quiescent earlier continues without changes. In every_cycle mode a scan is one
// evolution. A fault (race, value out of range, undefined value) is permanent; it also completes the scan. Under
// stability search, a program executes in the first step of a scan, and not again in later steps of this scan. With
// `settles`, the program repeats its execution, without time between the repetitions, until nothing changes. A run-time
// fault of a program is also a fault.
//
//   timer        counts down in units of `unit_ms`: the remaining t1 while its term holds, the remaining t2 after it
//                fell; scans occur at multiples of the unit. The caller chooses the unit, and hence the resolution
//   same         never: both have completed the scan, and exactly one has a fault, or an output differs
//   run_time_fault   never: a program has a run-time fault, and has not stopped in an earlier scan
//   possible     reachable: there are inputs that satisfy the constraints of both
//   a_follows, b_follows   if b has completed the scan without a fault, a completes it eventually. The property is
//                violated if a never becomes stable although b does. A fault in one chart and instability of the other
//                do not count as a difference. Only under stability search
//   one_follows  true leads to: one of them has completed the scan. Only for programs with `settles`
//   b_settles_after_stop, a_settles_after_stop   if a has stopped, b completes the scan eventually, and vice versa.
//                Only for programs with `settles`
//   continues    reachable: both have completed a scan without a fault or a stop
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/transition_system.hpp"
#include "ir/program/scan.hpp"

namespace grafverif {

/// A chart, or a program.
struct ProductSide {
    const Equations* equations = nullptr;
    /// nullptr for a chart; for a program, its scan, and `equations` is `&scan->equations`.
    const Scan* scan = nullptr;
    /// True if the program stops in a scan; a term over the values before the scan. Invalid if the program never stops.
    Id<Expr> stop = {};
};

struct ProductOptions {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::int64_t unit_ms = 1;                      ///< a divisor of all durations of both sides, and of the interval
    std::optional<std::int64_t> fewer_scans = {};  ///< restricts `same` to runs with fewer scans than this
    std::optional<std::int64_t> interval_ms = {};  ///< time between two scans; arbitrary if empty
    bool settles = false;                          ///< see above; requires stability search
    std::vector<std::string> outputs = {};         ///< names of the outputs that are compared
};

struct ProductMachine {
    TransitionSystem system = {};
    std::vector<Id<TransitionSystem::Symbol>> inputs = {};  ///< inputs in the order of the first chart or program
    Id<TransitionSystem::Symbol> waits = {};                ///< true if both charts have completed the scan
    Id<TransitionSystem::Symbol> passed =
        {};  ///< in a step with `waits`: time units until the next scan; invalid if there are no timers
};

/// Returns the product of `a` and `b`. Requires that both have the same inputs with equal types, and each of the
/// compared outputs, and that verify is empty for both charts.
ProductMachine schedule_both(const ProductSide& a, const ProductSide& b, const ProductOptions& options);

}  // namespace grafverif
