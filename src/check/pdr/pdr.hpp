// SPDX-License-Identifier: MIT
// Property directed reachability (Bradley 2011: "SAT-based model checking without unrolling"; Eén, Mishchenko and Brayton
// 2011: "Efficient implementation of property directed reachability"): whether a state with `bad` can be reached.
//
// Frame i is a set of cubes that no run of at most i steps reaches. States that lead to `bad` are excluded from frame to
// frame, each generalised: what a step does not depend on is left out of the state before it (justification along the
// gates), and of what is unreachable all that the solver did not need. Two equal frames are an inductive invariant.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "check/pdr/certificate.hpp"

namespace grafverif::pdr {

struct Answer {
    bool reached = false;
    /// Of what is reached: the inputs of each state of a run to it, `bad` in the last.
    std::vector<std::vector<bool>> inputs = {};
    /// Of what is not: cubes whose complement is an inductive invariant (see flaw).
    std::vector<Cube> invariant = {};
    std::size_t frames = 0;
};

/// Throws Exhausted. `progress` is told the number of frames.
Answer reach(const Circuit& circuit, Literal bad, Watch& watch, const std::function<void(std::size_t)>& progress = {});
/// The same to be asked again after Exhausted: it goes on where it was. Circuit and watch outlive it.
std::function<Answer()> search_for(const Circuit& circuit, Literal bad, Watch& watch,
                                   std::function<void(std::size_t)> progress);

}  // namespace grafverif::pdr
