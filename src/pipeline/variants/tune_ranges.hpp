// SPDX-License-Identifier: MIT
// Reads values of the option `--over`.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "grafverif/grafverif.hpp"
#include "ir/tuning.hpp"

namespace grafverif {

/// Reads the ranges `NAME=LOW..HIGH` or `NAME=LOW..HIGH:STEP` of constants of `loop`. `set` contains the constants that
/// the option `--set` sets, which cannot have ranges. The result is empty after an error; all errors are reported.
std::vector<TunedConstant> constants_over(const std::vector<std::string>& ranges, const ClosedLoop& loop,
                                          const std::map<std::string, std::string>& set, Diagnostics& diagnostics);

}  // namespace grafverif
