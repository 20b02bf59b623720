// SPDX-License-Identifier: MIT
// Justification: reduces a state and inputs that make some literals true to a part that is sufficient for this.
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
        Sources latches = {}, inputs = {};  ///< literals that are true, increasing
    };
    /// Returns a sufficient part. `value` returns the value of every literal in the cone of `targets`, all of which are
    /// true. The number of latches is minimized by a greedy pass over the gates.
    Justification part(const std::vector<Gates::Literal>& targets, const std::function<bool(Gates::Literal)>& value);

private:
    void collect(const std::vector<Gates::Literal>& targets);

    const Circuit& circuit_;
    std::vector<bool> is_latch_;                ///< true if the node is a latch
    std::vector<std::uint32_t> seen_, needed_;  ///< for each node: the last round in which it was seen or needed
    std::vector<std::uint32_t> cost_;           ///< for each node: the number of latches that its value may need
    std::vector<char> values_;                  ///< value of each node
    std::vector<std::uint32_t> cone_ = {};      ///< nodes in the cone, increasing
    std::uint32_t round_ = 0;
};

}  // namespace grafverif::pdr
