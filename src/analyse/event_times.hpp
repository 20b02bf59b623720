// SPDX-License-Identifier: MIT
// Event times: times of the instants of a path at which its timers expire as in the path.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analyse/search.hpp"

namespace grafverif::analysis {

/// The earliest time of each instant, in milliseconds, the first being 0; empty: none were found.
///
/// The age of a watched level is the difference of two event times. So a timer that has expired requires a minimum
/// difference, and one that has not a maximum: a system of difference constraints, solved by shortest paths (Bellman
/// 1958). It is complete except for timers with both a rise and a fall time, whose expiry is attributed to the latest
/// rise.
std::optional<std::vector<std::int64_t>> moments(const Machine& machine, const Path& path);

}  // namespace grafverif::analysis
