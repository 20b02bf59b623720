// SPDX-License-Identifier: MIT
// Event times: computes times for the instants of a path such that all timers expire as in the path.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analyse/search.hpp"

namespace grafverif::analysis {

/// Returns the earliest time of each instant in milliseconds, starting with 0; empty if no such times were found.
///
/// The age of a watched level is the difference of two event times. Therefore a timer that has expired requires a
/// minimum difference, and a timer that has not expired requires a maximum difference. The
/// requirements of all timers form a system of difference constraints, which a shortest-path
/// algorithm solves (Bellman 1958). The method is complete, except for timers with both a rise time
/// and a fall time: their expiry is always attributed to the latest rise.
std::optional<std::vector<std::int64_t>> moments(const Machine& machine, const Path& path);

}  // namespace grafverif::analysis
