// SPDX-License-Identifier: MIT
// Runs every command with every output format in-process on a chart or a closed loop. For each run it checks that the
// output explains the exit code, and that the output has the declared format.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"

namespace grafverif::fuzz {

/// The format of the output that a run writes on standard output.
enum class Written { Text, Grafcet, Json, Xml, Uppaal, Nusmv, TestTable, Plcopen, StructuredText };

struct VerbRun {
    /// FILE stands for the chart; FOLDER/... is an output file, whose name determines its format.
    std::vector<std::string> arguments = {};
    Written written = Written::Text;
    bool of_loop = false;  ///< the command rejects a file without a closed loop
    std::string typed = {};
};

std::span<const VerbRun> command_runs();

/// Returns the error found in `run` on `file`, which contains `model`, or an empty string. Writes files into `folder`
/// and removes them.
std::string error_text(const VerbRun& run, const std::filesystem::path& file, const Model& model,
                       const std::filesystem::path& folder);

}  // namespace grafverif::fuzz
