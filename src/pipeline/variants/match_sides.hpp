// SPDX-License-Identifier: MIT
// match_sides: determines which inputs and outputs of two controllers correspond, according to the options of `compare`.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "grafverif/ir/comparison.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "pipeline/variants/compare_sides.hpp"

namespace grafverif {

/// Options for the comparison of programs. If the controller is a program, variable names are compared
/// case-insensitively.
struct ProgramCompareOptions {
    bool settles = false;  ///< compare the outputs after programs have settled with constant inputs
    std::vector<std::pair<std::string, std::string>> map = {};  ///< name in the first controller, name in the second
    std::vector<std::string> ignored = {};                      ///< outputs that are not compared
    /// Outputs by which programs report a stop: a value other than 0 at the end of a scan. One name applies to each
    /// program that has this output; two names apply to the first and to the second controller.
    std::vector<std::string> stop = {};
};

/// Assigns the inputs and outputs of both sides to each other. The inputs and outputs that remain have the same order
/// in both, and the names of the first side; `result` lists them. Returns false after an error: an input or output has
/// no counterpart, or one with another type.
bool match_sides(std::array<CompareSide, 2>& sides, const ProgramCompareOptions& options, Comparison& result,
                 Diagnostics& diagnostics);

}  // namespace grafverif
