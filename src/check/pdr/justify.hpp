// SPDX-License-Identifier: MIT
// Justification: given values of latches and inputs for which some literals of a circuit are true, determines a subset
// of these values that is sufficient to make the literals true.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "circuit/circuit.hpp"

namespace grafverif::pdr {

/// Literals of latches or inputs.
using Sources = std::vector<Gates::Literal>;

class Justifier {
public:
    explicit Justifier(const Circuit& circuit);

    struct Justification {
        Sources latches = {}, inputs = {};  ///< literals that are true, in increasing order
    };
    /// Returns values of latches and inputs that are sufficient to make `targets` true. `value` must return the value
    /// of every literal in the cone of `targets`. Requires that `value` is true for all targets. A greedy pass over the
    /// gates keeps the number of latches small, but the number is not always minimal.
    Justification part(const std::vector<Gates::Literal>& targets, const std::function<bool(Gates::Literal)>& value);

private:
    void collect(const std::vector<Gates::Literal>& targets);

    const Circuit& circuit_;
    /// True if the node is a latch.
    std::vector<bool> is_latch_;
    /// For each node: the last call of `part` (its number is `round_`) in which the node was visited (`seen_`) or
    /// needed (`needed_`).
    std::vector<std::uint32_t> seen_, needed_;
    /// For each node: an upper bound of the number of latches that determine its value.
    std::vector<std::uint32_t> cost_;
    std::vector<char> values_;              ///< value of each node
    std::vector<std::uint32_t> cone_ = {};  ///< nodes in the cone of the targets, in increasing order
    std::uint32_t round_ = 0;
};

}  // namespace grafverif::pdr
