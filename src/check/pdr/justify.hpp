// SPDX-License-Identifier: MIT
// Justification: of a state and inputs that make some literals true, a part that does so alone.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "circuit/circuit.hpp"

namespace grafverif::pdr {

/// A source and its value.
using Sources = std::vector<Gates::Literal>;

class Justifier {
public:
    explicit Justifier(const Circuit& circuit);

    struct Part {
        Sources latches = {}, inputs = {};  ///< literals that are true; increasing
    };
    /// `value`: of every literal in the cone of `targets`, all of which are true. As few latches as a look along the gates
    /// finds.
    Part part(const std::vector<Gates::Literal>& targets, const std::function<bool(Gates::Literal)>& value);

private:
    void collect(const std::vector<Gates::Literal>& targets);

    const Circuit& circuit_;
    std::vector<bool> is_latch_;                ///< per node
    std::vector<std::uint32_t> seen_, needed_;  ///< per node: the round in which it was
    std::vector<std::uint32_t> cost_;           ///< per node: latches that its value may need
    std::vector<char> values_;                  ///< per node
    std::vector<std::uint32_t> cone_ = {};      ///< increasing
    std::uint32_t round_ = 0;
};

}  // namespace grafverif::pdr
