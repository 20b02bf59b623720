// SPDX-License-Identifier: MIT
// When the instants of a path can happen, so that its clocks end as the path says.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analyse/search.hpp"

namespace grafverif::analysis {

/// The earliest moment of each instant, in milliseconds, the first being 0; empty: none were found.
///
/// The age of what a clock watches is the difference of two moments, so a clock that has ended asks for a least
/// difference and one that has not for a greatest: a system of difference constraints, solved by shortest paths
/// (Bellman 1958). It is complete but for clocks that have both a rise and a fall time, whose end is put down to the
/// latest rise.
std::optional<std::vector<std::int64_t>> moments(const Machine& machine, const Path& path);

}  // namespace grafverif::analysis
