// SPDX-License-Identifier: MIT
// Bounded model checking (Biere, Cimatti, Clarke and Zhu 1999: "Symbolic model checking without BDDs"): the first states
// of all runs of a circuit, side by side in one graph of gates that grows with every step. The first state has constants
// for latches, and equal gates of different steps are one gate, so most of what few steps can do folds away before a
// solver sees it; only what is asked about is unrolled at all.
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
    /// Both outlive it.
    Unrolling(const Circuit& circuit, Watch& watch);

    /// A run with `bad` in the state after that many steps; nothing: there is none, which is kept in mind. Throws
    /// Exhausted, and may then be asked again.
    std::optional<RunInputs> run_to(Literal bad, std::size_t steps);

private:
    static constexpr Literal unknown = ~Literal{0};

    Literal at(Literal literal, std::size_t step);
    bool settle(std::uint32_t node, std::size_t step);
    RunInputs inputs_of_answer(std::size_t steps) const;

    const Circuit& circuit_;
    Watch& watch_;
    std::vector<Literal> next_;                      ///< per node of a latch
    std::vector<bool> is_latch_;                     ///< per node
    Circuit unrolled_ = {};                          ///< gates alone
    std::vector<std::vector<Literal>> states_ = {};  ///< per step and node: what it is among the gates unrolled
    Solver solver_;
};

}  // namespace grafverif::pdr
