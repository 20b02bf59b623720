// SPDX-License-Identifier: MIT
// Finds processes of a loop that cannot perform a run of an input abstraction.
//
// A group of processes is executed with the values that the run contains for the variables of other processes. If it
// cannot perform the run, the abstraction represents it too coarsely.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "check/inputs/abstract_run.hpp"

namespace grafverif {

/// A part of an abstract run that a group of processes cannot perform.
struct SpuriousMoves {
    std::size_t at = 0;                   ///< index in the path of the first impossible position
    std::vector<InputLevel> levels = {};  ///< per process of the group: level that excludes this part
    /// Greatest index such that the rest of the path is impossible from every state of the processes, given the values
    /// of other variables at this index. 0 if the processes have too many states.
    std::size_t since = 0;
};

/// Returns the groups to be examined, as indices of instances: each instance that is not Complete; and each Chosen
/// instance with all Chosen instances that it reads, directly or indirectly. For example, a tank and its level sensor
/// are examined jointly, because the run does not contain the level.
std::vector<std::vector<std::size_t>> joint_groups(const std::vector<AbstractableProcess>& instances,
                                                   const std::vector<InputLevel>& levels);

/// Returns the part of the run that the processes of `group` cannot perform jointly. All levels that exclude the run are
/// examined; the part with the greatest `since` is returned, with the least precise levels. The result is nullopt if no
/// level excludes the run, or if the processes have more than 2^14 states. If `waits` is true, any time may pass
/// initially and whenever all PLCs are stable. Variables whose values the run does not contain (Chosen instances, flags)
/// may have any value that the processes require. `complete` is the expanded network; its time unit divides that of the
/// abstract run.
std::optional<SpuriousMoves> impossible(const Network& complete, const AbstractRun& abstract,
                                        const std::vector<std::size_t>& group, bool waits);

}  // namespace grafverif
