// SPDX-License-Identifier: MIT
// Runs of sub-loops that share only time, as one run of the whole: each does in every instant what it does alone, and
// all wait for each other before time passes.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// A run of more moves is not shown.
constexpr std::size_t most_moves = 100'000;

/// Where the others are when `shown` ends.
enum class Ending {
    Anywhere,  ///< they have gone as far as time had to
    Waiting,   ///< they have done all that they do in its last instant, for `at stable`
};

/// The run of the whole that does `shown`, and beside it `others`, lassos in which time passes; all in terms of the whole.
/// Empty where it would repeat only after very long.
std::optional<Run> joined(const Run& shown, const std::vector<Run>& others, Ending ending);

/// The run, and on until nothing can happen without the passing of time, until that repeats, or for too many moves.
Run gone_on(const Network& network, Run run);

}  // namespace grafverif
