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
    /// Index in the path at which the shortest prefix that the group cannot perform ends.
    std::size_t at = 0;
    /// Per process of the group: level at which the abstraction excludes this section.
    std::vector<InputLevel> levels = {};
    /// Greatest index such that the group cannot perform the path from this index on, from any state of the group that
    /// agrees with the abstract run at this index. 0 if the group has too many states.
    std::size_t since = 0;
};

/// Returns the groups to examine, as indices of instances. Each instance whose level is not Complete (unchanged) forms
/// a group. An instance of the level Chosen (arbitrary outputs) also forms a group with all Chosen instances that it
/// reads directly or indirectly, unless this group has more than 4 members. For example, a tank and its level sensor
/// are examined jointly, because the abstract run does not contain the level.
std::vector<std::vector<std::size_t>> joint_groups(const std::vector<AbstractableProcess>& instances,
                                                   const std::vector<InputLevel>& levels);

/// Returns, for each group, a section of the run that its processes cannot perform jointly. Among all combinations of
/// levels that exclude the run, the function selects one with the greatest `since`; among these, it selects the least
/// precise levels. An entry is nullopt if no combination of levels excludes the run, or if a limit ends the examination
/// of the group: the time limit, 2^17 states of a single process, or 2^14 states of several processes. If `waits` is
/// true, a delay of any length is possible initially and whenever all PLCs are stable and no urgent edge is enabled in
/// the abstract run. Variables whose values the run does not contain (outputs of Chosen instances, flags) may have any
/// value that the processes require. `complete` is the expanded network; its time unit divides the time unit of the
/// abstract run.
std::vector<std::optional<SpuriousMoves>> impossible(const Network& complete, const AbstractRun& abstract,
                                                     const std::vector<std::vector<std::size_t>>& groups, bool waits,
                                                     const FollowLimits& limits);

}  // namespace grafverif
