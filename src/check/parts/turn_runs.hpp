// SPDX-License-Identifier: MIT
// Runs of parts that take turns as one run of the whole system. Each step is made anew on the whole, by its choices.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ir/flat_system.hpp"
#include "ir/system_parts.hpp"

namespace grafverif {

/// A step of the whole that one part makes alone, or all together.
struct TurnStep {
    enum class Kind { Moves, Waits, Ends };  ///< Ends: nothing can happen, the state repeats itself
    Kind kind = Kind::Moves;
    std::vector<std::pair<std::uint32_t, std::int64_t>> choices = {};  ///< variables of the whole; the others are 0
};

/// What a part does; a lasso leads back to the state before step `loop`.
struct TurnRun {
    std::vector<TurnStep> steps = {};
    std::optional<std::size_t> loop = {};

    bool never_waits_again() const;
};

/// One after the other; the second begins where the first, which is finite, ends.
TurnRun behind(TurnRun first, const TurnRun& second);

/// The same without the steps in which nobody moves. Requires that a loop has others.
TurnRun without_waits(const TurnRun& run);

/// `shown` beside `others`, lassos that wait again and again: all wait together. `settling`: the others go on to where
/// they would wait next. Empty: it would repeat only after very long. `shown` does not end in a state that repeats itself.
std::optional<TurnRun> side_by_side(const TurnRun& shown, const std::vector<TurnRun>& others, bool settling);

/// The run as one of the whole.
FlatRun replayed(const FlatSystem& whole, const TurnRun& run);

}  // namespace grafverif
