// SPDX-License-Identifier: MIT
// schedule_both: translates the Equations of two charts to a TransitionSystem, their product. Both charts are executed
// scan by scan, as by a PLC: in each scan, the inputs are read and the chart computes its outputs; time passes between
// scans. Inputs and times are arbitrary, but equal for both charts. Each chart can be replaced by a PLC program; a
// program executes a scan in one step.
//
// A step of the system is one evolution of both charts. If both charts have completed the scan (`waits`), a step
// instead chooses the next inputs and the time until the next scan. Under stability search the inputs are constant
// until both charts are quiescent; a chart that becomes quiescent earlier executes evolutions without effect. In the
// execution mode `every-cycle`, a scan is one evolution. A fault (race, value out of range, undefined value) is
// permanent. A chart with a fault counts as having completed the scan. Under stability search, a program executes in
// the first step of a scan, and not again in later steps of this scan. If ProductOptions::settles is true, the program
// repeats its execution, without time between the repetitions, until nothing changes. A run-time fault of a program is
// also a fault.
//
//   timer        counts down in units of `unit_ms`: the remaining rise time t1 while the observed term holds, and the
//                remaining fall time t2 after the term has become false. Scans occur at multiples of the unit. The
//                caller chooses the unit, and hence the resolution
//   same         never: both charts have completed the scan, and exactly one chart has a fault or an output differs
//   run_time_fault   never: a run-time fault of a program that has not stopped in an earlier scan
//   possible     reachable: a state whose inputs satisfy the constraints of both charts
//   a_follows    if b has completed the scan without a fault, a completes the scan eventually. The property is violated
//                if b becomes stable but a never does. A run in which one chart has a fault and the other chart never
//                becomes stable does not violate the property. The property exists only under stability search
//   b_follows    as `a_follows`, with a and b exchanged
//   one_follows  `true leads to p`; p states that a or b has completed the scan. Only for programs with `settles`
//   b_settles_after_stop   if a has stopped, b completes the scan eventually. Only for programs with `settles`
//   a_settles_after_stop   if b has stopped, a completes the scan eventually. Only for programs with `settles`
//   continues    reachable: both charts have completed a scan without a fault or a stop
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

/// One of the two charts or programs of the product.
struct ProductSide {
    const Equations* equations = nullptr;
    /// For a program: its scan, and `equations` is `&scan->equations`. For a chart: nullptr.
    const Scan* scan = nullptr;
    /// Term over the values before a scan: true if the program stops in this scan. Invalid if the program never stops.
    Id<Expr> stop = {};
};

struct ProductOptions {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::int64_t unit_ms = 1;  ///< length of the time unit in ms; divides all durations of both sides and the interval
    /// If given, the property `same` concerns only runs with fewer scans than this number.
    std::optional<std::int64_t> fewer_scans = {};
    std::optional<std::int64_t> interval_ms = {};  ///< time between two scans; arbitrary if empty
    bool settles = false;  ///< true: programs repeat each scan until nothing changes; requires stability search
    std::vector<std::string> outputs = {};  ///< names of the outputs that are compared
};

struct ProductMachine {
    TransitionSystem system = {};
    std::vector<Id<TransitionSystem::Symbol>> inputs = {};  ///< inputs in the order of the first chart or program
    Id<TransitionSystem::Symbol> waits = {};                ///< true if both charts have completed the scan
    Id<TransitionSystem::Symbol> passed =
        {};  ///< in a step with `waits`: time units until the next scan; invalid if there are no timers
};

/// Returns the product of `a` and `b`. Requires that `a` and `b` have the same inputs with equal types, and that both
/// sides have each of the compared outputs. Requires that `verify` returns an empty list for the equations of both
/// sides.
ProductMachine schedule_both(const ProductSide& a, const ProductSide& b, const ProductOptions& options);

}  // namespace grafverif
