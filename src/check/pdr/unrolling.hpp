// SPDX-License-Identifier: MIT
// Bounded model checking (Biere, Cimatti, Clarke and Zhu 1999: "Symbolic model checking without BDDs"): the first
// states of all runs of a circuit as one graph of gates, which grows with every step. The latches of the first state
// are constants, and equal gates of different steps are one gate. So for few steps most gates are simplified away
// before solving. Only gates that a query needs are unrolled.
#pragma once

#include <optional>
#include <vector>

#include "check/pdr/solver.hpp"
#include "circuit/circuit.hpp"

namespace grafverif::pdr {

/// The values of the inputs of a circuit in each state of a run.
using RunInputs = std::vector<std::vector<bool>>;

class Unrolling {
public:
    /// Both arguments must outlive the object.
    Unrolling(const Circuit& circuit, LimitMonitor& watch);

    /// A run with `bad` in the state after that many steps; nothing if there is none, which is recorded. Throws
    /// Exhausted; may be called again after that.
    std::optional<RunInputs> run_to(Literal bad, std::size_t steps);

private:
    static constexpr Literal unknown = ~Literal{0};

    Literal at(Literal literal, std::size_t step);
    bool settle(std::uint32_t node, std::size_t step);
    RunInputs inputs_of_result(std::size_t steps) const;

    const Circuit& circuit_;
    LimitMonitor& watch_;
    std::vector<Literal> next_;                      ///< per node of a latch
    std::vector<bool> is_latch_;                     ///< per node
    Circuit unrolled_ = {};                          ///< only gates
    std::vector<std::vector<Literal>> states_ = {};  ///< per step and node: the unrolled literal
    Solver solver_;
};

}  // namespace grafverif::pdr
