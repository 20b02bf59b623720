// SPDX-License-Identifier: MIT
// Writes a TransitionSystem as BTOR2 (Niemetz, Preiner, Wolf and Biere 2018: "BTOR2, BtorMC and Boolector 3.0"), a
// word-level format. A Boolean is a bit vector of one bit, and an integer is a bit vector in two's complement. Each
// term has as many bits as necessary, so that no overflow occurs.
//
// As in circuit/circuit.hpp, the state variable `broken` is true after a violation of an invariant, a range or a
// constraint on steps. A state property is a `bad` line. The state variable `started` selects the initial values that
// are not constant. Properties of runs are omitted; the AIGER output contains them.
#pragma once

#include <string>
#include <vector>

#include "circuit/circuit.hpp"

namespace grafverif::btor2 {

struct Btor2Text {
    std::string text = {};
    std::vector<NotInCircuit> omitted = {};
};
/// Returns the text of the system. Requires verify(system).empty().
Btor2Text written(const TransitionSystem& system);

}  // namespace grafverif::btor2
