// SPDX-License-Identifier: MIT
// Property directed reachability (PDR): decides whether a bad state is reachable. A state is bad if the literal `bad`
// is true in the state. Sources: Bradley 2011: "SAT-based model checking without unrolling"; Eén, Mishchenko and
// Brayton 2011: "Efficient implementation of property directed reachability".
//
// Frame i is a set of cubes (conjunctions of latch literals); no run of at most i steps reaches a state in one of these
// cubes. The search excludes states from which a bad state is reachable, frame by frame, and generalizes each excluded
// state to a cube. Two methods generalize a state. From the source state of a step, the search removes literals on
// which the step does not depend (justification along the gates). From an unreachable cube, it removes literals that
// the SAT solver did not use. If two adjacent frames are equal, the set of states outside of all cubes of the frame is
// an inductive invariant.
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

/// An invariant that is already known, which a search may use.
struct KnownInvariant {
    /// Function that returns cubes whose complement is an inductive invariant (see flaw). A null function means that no
    /// invariant is known.
    std::function<const std::vector<Cube>&()> cubes = {};
    std::uint64_t after = 2000;  ///< number of solver queries after which the search calls `cubes`
};

/// Decides whether a state in which `bad` is true is reachable. Throws Exhausted if a limit is exceeded. Calls
/// `progress` with the current number of frames. If the search requires many queries, it uses the invariant `known`.
PdrAnswer reach(const Circuit& circuit, Literal bad, LimitMonitor& watch,
                const std::function<void(std::size_t)>& progress = {}, KnownInvariant known = {});
/// Returns a function that performs the search of `reach`. If a call throws Exhausted, the next call continues the
/// search. The circuit and the monitor must outlive the search.
std::function<PdrAnswer()> search_for(const Circuit& circuit, Literal bad, LimitMonitor& watch,
                                      std::function<void(std::size_t)> progress, KnownInvariant known = {});

}  // namespace grafverif::pdr
