// SPDX-License-Identifier: MIT
// match_sides: determines which inputs and outputs of two controllers correspond, according to the options of
// `compare`.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "grafverif/ir/comparison.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "pipeline/variants/compare_sides.hpp"

namespace grafverif {

/// Options for the comparison of programs. If a controller is a program, its variable names are compared
/// case-insensitively.
struct ProgramCompareOptions {
    bool settles = false;  ///< compare programs after repeated scans with constant inputs
    std::vector<std::pair<std::string, std::string>> map = {};  ///< name in the first controller, name in the second
    std::vector<std::string> ignored = {};                      ///< outputs that are not compared

    /// Outputs by which programs report a stop: a value other than 0 at the end of a scan. A single name applies to
    /// each program that has an output with this name; of two names, the first applies to the first controller and the
    /// second to the second controller.
    std::vector<std::string> stop = {};
};

/// Assigns the inputs and outputs of both sides to each other. Afterwards, both sides contain only the assigned inputs
/// and outputs, in the same order and with the names of the first side; `result` lists these names. Returns false after
/// an error: an input or output has no counterpart, or a counterpart with another type.
bool match_sides(std::array<CompareSide, 2>& sides, const ProgramCompareOptions& options, Comparison& result,
                 Diagnostics& diagnostics);

}  // namespace grafverif
