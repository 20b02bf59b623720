// SPDX-License-Identifier: MIT
// What the timed engine is asked by sub-loops: the verdicts to give, and which parts each reads.
#pragma once

#include <cstdint>
#include <vector>

#include "check/timed/timed.hpp"
#include "ir/network_parts.hpp"

namespace grafverif {

/// Some parts of a network, in order.
using PartNumbers = std::vector<std::uint32_t>;

/// One verdict to give.
struct PartQuestion {
    Property property = {};  ///< named as its verdict; its pattern asks for one state where that of the verdict expands
    Verdict verdict = {};
    PartNumbers reads = {};
    bool each = false;  ///< asked of every part by itself
    bool race = false;  ///< then: whether there is an action race
};

/// The properties asked for, each step of an expanding one separately, and `no timelock` unless `options` exclude it.
std::vector<PartQuestion> part_questions(const Network& network, const NetworkParts& parts,
                                         const TimedOptions& options);

}  // namespace grafverif
