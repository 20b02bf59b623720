// SPDX-License-Identifier: MIT
// Finds processes of a loop that cannot perform a run of an input abstraction.
//
// A group of processes is executed with the values that the abstract run contains for the variables of all other
// processes. If the group cannot perform the run, the abstraction represents the group too coarsely.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "check/inputs/abstract_run.hpp"
#include "check/inputs/follow.hpp"

namespace grafverif {

/// A section of an abstract run that a group of processes cannot perform.
struct SpuriousMoves {
    std::size_t at = 0;  ///< index in the path: end of the shortest beginning of the run that the group cannot perform
    /// Per process of the group: level with which the abstraction excludes this section.
    std::vector<InputLevel> levels = {};
    /// Greatest index such that the group cannot perform the path from this index on, from any of its states that agree
    /// with the other variables at this index. 0 if the group has too many states.
    std::size_t since = 0;
};

/// Returns the groups to be examined, as indices of instances. Each instance that is not Complete forms a group. Each
/// Chosen instance forms a group with all Chosen instances that it reads directly or indirectly, unless this group has
/// more than 4 members. For example, a tank and its level sensor are examined jointly, because the run does not contain
/// the level.
std::vector<std::vector<std::size_t>> joint_groups(const std::vector<AbstractableProcess>& instances,
                                                   const std::vector<InputLevel>& levels);

/// Returns, for each group, a section of the run that its processes cannot perform jointly. Among all combinations of
/// levels that exclude the run, the result is a section with the greatest `since`; among equal sections, the levels are
/// the least precise. An entry is nullopt if no level excludes the run, or if a limit ends the examination of the
/// group: the time limit, 2^17 states of a single process, or 2^14 states of several processes. If `waits` is true, any
/// time may pass initially and whenever all PLCs are stable. Variables whose values the run does not contain (Chosen
/// instances, flags) may have any value that the processes require. `complete` is the expanded network; its time unit
/// divides the time unit of the abstract run.
std::vector<std::optional<SpuriousMoves>> impossible(const Network& complete, const AbstractRun& abstract,
                                                     const std::vector<std::vector<std::size_t>>& groups, bool waits,
                                                     const FollowLimits& limits);

}  // namespace grafverif
