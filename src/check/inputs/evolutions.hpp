// SPDX-License-Identifier: MIT
// Proof that the evolutions of a PLC end: while the inputs of a PLC are constant, it takes finitely many cycles.
//
// One cycle of the PLC is a relation between the values of its variables before and after the cycle. Assume that a run
// of urgent edges contains infinitely many cycles, although the inputs and the outputs of the timers are constant from
// some cycle on. A variable of the PLC is *steady* if in each such run, it is also constant from some cycle on. The
// proof computes steady variables in groups: the steps whose activities depend on the same firing conditions form a
// group, and each other variable forms a separate group. The values of a group in a run are a path in a graph. Its
// nodes are the reachable valuations of the group, and its edges are changes of the valuation in a cycle. To compute
// them, all other variables have arbitrary values of their ranges, but the outputs of each instance have one of their
// reachable valuations. If no valuation of the steady variables admits all edges of a cycle of the graph, the group
// changes finitely often, so it is also steady. A SAT solver decides this for all cycles of the graph at once: it
// searches a nonempty set of edges in which each edge has a successor.
//
// Each variable that another process assigns is read by only one edge of a cycle (PlcCycle), so it has one value per
// cycle. Further conditions on the edges: all steady variables have the same values before and after the cycle of the
// PLC. If a cycle requests a timer, the timer accepts the request before the next cycle. If each edge of the timer that
// accepts a request leads to the same output, the constant output of the timer has this value.
//
// Evolutions end if no cycle of the PLC can begin and end with the same values of all steady variables.
#pragma once

#include <optional>
#include <vector>

#include "check/pdr/solver.hpp"
#include "ir/network_inputs.hpp"

namespace grafverif {

/// Returns true under two conditions. No reachable edge of a PLC has a model error. Each infinite run of urgent edges
/// contains infinitely many edges of other processes than PLCs and timers that assign variables which PLCs read.
/// Returns false if there is no proof, and nullopt if a limit is reached. Requires that `network` is expanded, has no
/// observers, and satisfies lets_time_pass (check/inputs/resting.hpp). `instances` are its abstractable processes.
std::optional<bool> evolutions_end(const Network& network, const std::vector<AbstractableProcess>& instances,
                                   const pdr::SolverLimits& limits);

}  // namespace grafverif
