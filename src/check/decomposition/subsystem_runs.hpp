// SPDX-License-Identifier: MIT
// Combines runs of interleaved parts to one run of the complete system. Each step is re-executed in the complete system
// with its choices.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ir/flat_system.hpp"
#include "ir/subsystems.hpp"

namespace grafverif {

/// A step of the complete system by one part alone, or by all together.
struct SubsystemStep {
    enum class Kind { Moves, Waits, Ends };  ///< Ends: no event is possible, the state is repeated
    Kind kind = Kind::Moves;
    std::vector<std::pair<std::uint32_t, std::int64_t>> choices = {};  ///< by variable of the complete system; the
                                                                       ///< others are 0
};

/// A run of a part; a lasso leads back to the state before step `loop`.
struct SubsystemRun {
    std::vector<SubsystemStep> steps = {};
    std::optional<std::size_t> loop = {};

    bool never_waits_again() const;
};

/// The concatenation of two runs; requires that the second begins where the first, which is finite, ends.
SubsystemRun behind(SubsystemRun first, const SubsystemRun& second);

/// The run without steps in which no process moves. Requires that a loop has others.
SubsystemRun without_waits(const SubsystemRun& run);

/// Combines `shown` with `others`, lassos that wait infinitely often; all wait together. `settling`: the others
/// continue to their next wait. Empty if the period would be too long. Requires that `shown` does not end in a repeated
/// state.
std::optional<SubsystemRun> side_by_side(const SubsystemRun& shown, const std::vector<SubsystemRun>& others,
                                         bool settling);

/// The run as one of the complete system.
FlatRun replayed(const FlatSystem& whole, const SubsystemRun& run);

}  // namespace grafverif
