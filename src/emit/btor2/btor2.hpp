// SPDX-License-Identifier: MIT
// TransitionSystem -> BTOR2 (Niemetz, Preiner, Wolf and Biere 2018: "BTOR2, BtorMC and Boolector 3.0"): words instead of
// bits. A Boolean is a bit vector of one bit, an integer one in two's complement, and terms are as wide as they need, so
// that nothing wraps around.
//
// As in circuit/circuit.hpp, invariants, constraints on steps and ranges are folded into the state `broken`, a property about
// states is a `bad` line, and values that are no constants at first are chosen by the state `started`. Properties about runs
// are left out; AIGER says them.
#pragma once

#include <string>
#include <vector>

#include "circuit/circuit.hpp"

namespace grafverif::btor2 {

struct Written {
    std::string text = {};
    std::vector<NotInCircuit> omitted = {};
};
/// Requires verify(system).empty().
Written written(const TransitionSystem& system);

}  // namespace grafverif::btor2
