// SPDX-License-Identifier: MIT
// play: executes a list of commands from power-on and returns the resulting state. The function has no state; the
// caller keeps the list.
#pragma once

#include <cstddef>
#include <string>

#include "app/serve/file_checker.hpp"

namespace grafverif::app {

inline constexpr std::size_t most_moves = 10'000, most_random_moves = 1'000, most_rows = 500;

/// Returns the prefix of the ids of a chart's elements on a page.
std::string drawing_prefix(Id<Chart> chart);

/// Returns the drawings of the charts as JSON.
std::string drawings(const CheckedFile& piece);

/// Executes a request. `request` and the response are JSON (docs/how-to/serve.md).
std::string play(const CheckedFile& piece, const Options& options, const std::string& request);

}  // namespace grafverif::app
