// SPDX-License-Identifier: MIT
// Reads values of the option `--over`.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "grafverif/grafverif.hpp"
#include "ir/tuning.hpp"

namespace grafverif {

/// Reads ranges of constants of `loop`, written as `NAME=LOW..HIGH` or `NAME=LOW..HIGH:STEP`. `set` contains the
/// constants that the option `--set` sets; such a constant cannot have a range. The result is empty after an error; all
/// errors are reported.
std::vector<TunedConstant> constants_over(const std::vector<std::string>& ranges, const ClosedLoop& loop,
                                          const std::map<std::string, std::string>& set, Diagnostics& diagnostics);

}  // namespace grafverif
