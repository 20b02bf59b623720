// SPDX-License-Identifier: MIT
// Every command with every output format, run in-process on a chart or a closed loop. Checks for each run that the exit
// code is explained by its output, and that outputs have the declared format.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"

namespace grafverif::fuzz {

/// The output of a run on standard output.
enum class Written { Text, Grafcet, Json, Xml, Uppaal, Nusmv, TestTable, Plcopen, StructuredText };

struct VerbRun {
    std::vector<std::string> arguments = {};  ///< FILE is the chart; FOLDER/... an output file, with its format given
                                              ///< by the name
    Written written = Written::Text;
    bool of_loop = false;  ///< rejected without a closed loop
    std::string typed = {};
};

std::span<const VerbRun> command_runs();

/// The error in `run` on `file`, which contains `model`; files are written into `folder`, and removed. Empty: none.
std::string error_text(const VerbRun& run, const std::filesystem::path& file, const Model& model,
                       const std::filesystem::path& folder);

}  // namespace grafverif::fuzz
