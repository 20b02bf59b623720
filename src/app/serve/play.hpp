// SPDX-License-Identifier: MIT
// play: a list of commands, made from the power-on again -> what there is to see afterwards. Nothing is kept from one call
// to the next: whoever plays keeps the list.
#pragma once

#include <cstddef>
#include <string>

#include "app/serve/bench.hpp"

namespace grafverif::app {

inline constexpr std::size_t most_moves = 10'000, most_random_moves = 1'000, most_rows = 500;

/// What stands before the ids of a chart's elements on a page.
std::string drawing_prefix(Id<Chart> chart);

/// The drawings of the charts, as JSON.
std::string drawings(const Workpiece& piece);

/// `request` and the answer are JSON, as docs/serve.md describes them.
std::string play(const Workpiece& piece, const Options& options, const std::string& request);

}  // namespace grafverif::app
