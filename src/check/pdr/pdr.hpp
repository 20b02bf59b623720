// SPDX-License-Identifier: MIT
// Property directed reachability: decides if a state with `bad` is reachable. Sources: Bradley 2011: "SAT-based model
// checking without unrolling"; Eén, Mishchenko and Brayton 2011: "Efficient implementation of property directed
// reachability".
//
// Frame i is a set of cubes that no run of at most i steps reaches. States that lead to `bad` are excluded frame by
// frame, and generalized. Literals on which a step does not depend are removed from its source state (justification
// along the gates). Literals that the solver did not need are removed from an unreachable cube. Two equal frames are an
// inductive invariant.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "check/pdr/certificate.hpp"

namespace grafverif::pdr {

struct PdrAnswer {
    bool reached = false;
    /// If reachable: the inputs in each state of a run to a state with `bad`, which is the last state.
    std::vector<std::vector<bool>> inputs = {};
    /// If unreachable: the cubes whose complement is an inductive invariant (see flaw).
    std::vector<Cube> invariant = {};
    std::size_t frames = 0;
};

/// Decides if `bad` is reachable. Throws Exhausted. `progress` is called with the number of frames.
PdrAnswer reach(const Circuit& circuit, Literal bad, LimitMonitor& watch,
                const std::function<void(std::size_t)>& progress = {});
/// Returns a search that can be continued: after Exhausted, another call continues it. Circuit and monitor must outlive
/// it.
std::function<PdrAnswer()> search_for(const Circuit& circuit, Literal bad, LimitMonitor& watch,
                                      std::function<void(std::size_t)> progress);

}  // namespace grafverif::pdr
