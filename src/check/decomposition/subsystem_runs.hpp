// SPDX-License-Identifier: MIT
// Combines runs of interleaved parts (independent subsystems) into one run of the complete system. The complete system
// executes each step of a part with the same choices as the part.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ir/flat_system.hpp"
#include "ir/subsystems.hpp"

namespace grafverif {

/// A step of the complete system, in which one part moves or all parts wait together.
struct SubsystemStep {
    /// Ends: no move is possible and time cannot pass, so that the state is repeated.
    enum class Kind { Moves, Waits, Ends };
    Kind kind = Kind::Moves;
    /// Index and value of each choice in the complete system; all other choices are 0.
    std::vector<std::pair<std::uint32_t, std::int64_t>> choices = {};
};

/// A run of a part. If `loop` is given, the last step leads back to the state before step `loop`.
struct SubsystemRun {
    std::vector<SubsystemStep> steps = {};
    std::optional<std::size_t> loop = {};

    bool never_waits_again() const;
};

/// Returns the concatenation of two runs. Requires that `first` is finite and that `second` begins in the last state of
/// `first`.
SubsystemRun concatenated(SubsystemRun first, const SubsystemRun& second);

/// Returns the run without the steps of the kind `Waits`. If the run has a loop, this loop must also contain a step of
/// another kind.
SubsystemRun without_waits(const SubsystemRun& run);

/// Combines `shown` with `others`, which are infinite runs with infinitely many steps of the kind `Waits`. In the
/// combined run, all parts wait in the same steps. If `settling` is true, the parts of `others` continue to their next
/// wait at the end of `shown`. The result is nullopt if the combined run would be too long. Requires that `shown` has
/// no step of the kind `Ends`.
std::optional<SubsystemRun> side_by_side(const SubsystemRun& shown, const std::vector<SubsystemRun>& others,
                                         bool settling);

/// Returns the states of the complete system in `run`.
FlatRun replayed(const FlatSystem& whole, const SubsystemRun& run);

}  // namespace grafverif
