// SPDX-License-Identifier: MIT
// Bounded model checking (Biere, Cimatti, Clarke and Zhu 1999: "Symbolic model checking without BDDs"). The first
// states of all runs of a circuit are one graph of gates, which grows with every step. The latches of the first state
// are constants, and equal gates of different steps are one gate. Therefore, for a small number of steps, most gates
// are simplified before solving. Only gates that a query requires are unrolled.
#pragma once

#include <optional>
#include <vector>

#include "check/pdr/solver.hpp"
#include "circuit/circuit.hpp"

namespace grafverif::pdr {

/// Values of the inputs of a circuit in each state of a run.
using RunInputs = std::vector<std::vector<bool>>;

class Unrolling {
public:
    /// Both arguments must outlive the object.
    Unrolling(const Circuit& circuit, LimitMonitor& watch);

    /// Returns a run with `bad` in the state after that number of steps. If there is none, this is recorded and the
    /// result is empty. Throws Exhausted; may be called again afterwards.
    std::optional<RunInputs> run_to(Literal bad, std::size_t steps);

private:
    static constexpr Literal unknown = ~Literal{0};

    Literal at(Literal literal, std::size_t step);
    bool settle(std::uint32_t node, std::size_t step);
    RunInputs inputs_of_result(std::size_t steps) const;

    const Circuit& circuit_;
    LimitMonitor& watch_;
    std::vector<Literal> next_;                      ///< for each node of a latch: its next value
    std::vector<bool> is_latch_;                     ///< true if the node is a latch
    Circuit unrolled_ = {};                          ///< contains only gates
    std::vector<std::vector<Literal>> states_ = {};  ///< unrolled literal per step and node
    Solver solver_;
};

}  // namespace grafverif::pdr
