// SPDX-License-Identifier: MIT
// Bounded model checking (Biere, Cimatti, Clarke and Zhu 1999: "Symbolic model checking without BDDs"). One graph of
// gates represents the states of all runs of a circuit up to a number of steps. The graph grows with every step. The
// latches of the first state are constants, and equal gates of different steps are represented by one gate. Therefore,
// for a small number of steps, most gates are simplified before solving. Only gates on which a query depends are
// unrolled.
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

    /// Returns a run of `steps` steps whose last state is bad. If no such run exists, the result is nullopt, and later
    /// queries use this fact. Throws Exhausted if a limit is exceeded; the function may then be called again.
    std::optional<RunInputs> run_to(Literal bad, std::size_t steps);

private:
    static constexpr Literal unknown = ~Literal{0};

    Literal at(Literal literal, std::size_t step);
    bool settle(std::uint32_t node, std::size_t step);
    RunInputs inputs_of_result(std::size_t steps) const;

    const Circuit& circuit_;
    LimitMonitor& watch_;
    std::vector<Literal> next_;                      ///< next value of the latch of each node
    std::vector<bool> is_latch_;                     ///< true if the node is a latch
    Circuit unrolled_ = {};                          ///< contains only gates
    std::vector<std::vector<Literal>> states_ = {};  ///< unrolled literal for each step and node
    Solver solver_;
};

}  // namespace grafverif::pdr
