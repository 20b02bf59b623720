// SPDX-License-Identifier: MIT
// Property directed reachability: decides if a bad state is reachable, that is, a state in which the literal `bad` is
// true. Sources: Bradley 2011: "SAT-based model checking without unrolling"; Eén, Mishchenko and Brayton 2011:
// "Efficient implementation of property directed reachability".
//
// Frame i is a set of cubes that no run of at most i steps reaches. States that lead to a bad state are generalized and
// excluded, frame by frame. Literals on which a step does not depend are removed from the source state of the step
// (justification along the gates). Literals that the solver did not use are removed from an unreachable cube. If two
// adjacent frames are equal, the states outside of their cubes are an inductive invariant.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "check/pdr/certificate.hpp"

namespace grafverif::pdr {

struct PdrAnswer {
    bool reached = false;
    /// If reachable: the inputs in each state of a run whose last state is bad.
    std::vector<std::vector<bool>> inputs = {};
    /// If unreachable: cubes whose complement is an inductive invariant (see flaw).
    std::vector<Cube> invariant = {};
    std::size_t frames = 0;
};

/// Decides if a bad state is reachable. Throws Exhausted. `progress` is called with the number of frames.
PdrAnswer reach(const Circuit& circuit, Literal bad, LimitMonitor& watch,
                const std::function<void(std::size_t)>& progress = {});
/// Returns a search that can be continued: after Exhausted, another call continues it. The circuit and the monitor must
/// outlive the search.
std::function<PdrAnswer()> search_for(const Circuit& circuit, Literal bad, LimitMonitor& watch,
                                      std::function<void(std::size_t)> progress);

}  // namespace grafverif::pdr
