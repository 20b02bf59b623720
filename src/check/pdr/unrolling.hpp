// SPDX-License-Identifier: MIT
// Bounded model checking (Biere, Cimatti, Clarke and Zhu 1999: "Symbolic model checking without BDDs"). One circuit of
// gates represents the states of all runs up to a number of steps; every further step adds gates. The latches of the
// initial state are constants, and one gate represents equal gates of different steps. Therefore, for a small number of
// steps, most gates are simplified before solving. Only gates on which a query depends are unrolled.
#pragma once

#include <optional>
#include <vector>

#include "check/pdr/solver.hpp"
#include "circuit/circuit.hpp"

namespace grafverif::pdr {

/// Values of the inputs of a circuit, for each state of a run.
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
    std::vector<Literal> next_;                      ///< literal of the next value, for the node of each latch
    std::vector<bool> is_latch_;                     ///< true if the node is a latch
    Circuit unrolled_ = {};                          ///< unrolled circuit; it has no latches
    std::vector<std::vector<Literal>> states_ = {};  ///< literal of `unrolled_` for each step and node
    Solver solver_;
};

}  // namespace grafverif::pdr
