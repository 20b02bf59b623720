// SPDX-License-Identifier: MIT
// Proof that the evolutions of a PLC end: while the inputs of the PLC are constant, the PLC executes only finitely many
// cycles.
//
// One cycle of the PLC is a relation between the values of its variables before and after the cycle. Assume that a run
// of urgent edges contains infinitely many cycles, although the inputs and the outputs of the timers are constant from
// some cycle on. A variable of the PLC is *steady* if, in each such run, the variable is also constant from some cycle
// on. The proof computes steady variables in groups: the steps whose activities depend on the same firing conditions
// form a group, and each other variable forms a separate group. The values of a group in a run form a path in a graph.
// The nodes of the graph are the reachable valuations of the group, and the edges are the changes of the valuation in
// one PLC cycle. For the computation of the graph, each other variable has an arbitrary value of its range, but the
// outputs of each instance have one of their reachable valuations. If no valuation of the steady variables admits all
// edges of a cycle of the graph, the group changes only finitely often, so its variables are also
// steady. A SAT solver decides this condition for all cycles of the graph in one query: the solver
// searches for a nonempty set of edges in which each edge has a successor.
//
// Only one edge of a PLC cycle reads a variable that another process assigns (see PlcCycle), so the variable has one
// value per cycle. For each edge of the graph, all steady variables have the same values before and
// after the PLC cycle. If a cycle requests a timer, the timer accepts the request before the next
// cycle. If all edges of the timer that accept a request lead to the same output, the constant
// output of the timer has this value.
//
// The evolutions end if no cycle of the PLC can begin and end with the same values of all steady variables.
#pragma once

#include <optional>
#include <vector>

#include "check/pdr/solver.hpp"
#include "ir/network_inputs.hpp"

namespace grafverif {

/// Returns true if two statements are proved. First, no reachable edge of a PLC has a model error; if
/// `errors_are_excluded` is true, the caller has proved this statement. Second, each
/// infinite run of urgent edges contains infinitely many edges that assign a variable which a PLC reads and that belong
/// neither to a PLC nor to a timer. Returns false if there is no proof, and nullopt if a limit is reached. Requires
/// that `network` is expanded, has no observers, and satisfies lets_time_pass
/// (check/inputs/resting.hpp). `instances` are the abstractable processes of `network`.
std::optional<bool> evolutions_end(const Network& network, const std::vector<AbstractableProcess>& instances,
                                   const pdr::SolverLimits& limits, bool errors_are_excluded = false);

}  // namespace grafverif
