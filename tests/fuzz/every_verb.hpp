// SPDX-License-Identifier: MIT
// Every verb with every form of output, run in-process on a chart or a closed loop, and what must be true of each run
// whatever the chart: an exit code that the run explains, and outputs that are what they claim to be.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"

namespace grafverif::fuzz {

/// What a run writes to standard output.
enum class Written { Text, Grafcet, Json, Xml, Uppaal, Nusmv, TestTable, Plcopen, StructuredText };

struct VerbRun {
    std::vector<std::string> arguments = {};  ///< FILE is the chart; FOLDER/... a file to write, told by its name
    Written written = Written::Text;
    bool of_loop = false;  ///< without a closed loop it is refused
    std::string typed = {};
};

std::span<const VerbRun> verb_runs();

/// What is wrong with `run` on `file`, which holds `model`; files are written into `folder`, and removed. Empty: nothing.
std::string complaint(const VerbRun& run, const std::filesystem::path& file, const Model& model,
                      const std::filesystem::path& folder);

}  // namespace grafverif::fuzz
