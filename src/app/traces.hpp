// SPDX-License-Identifier: MIT
// Trace files of `check` and `simulate`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/options.hpp"
#include "app/system/write_files.hpp"
#include "grafverif/ir/chart_run.hpp"

namespace grafverif::app {

/// Returns the files that --trace-vcd and --trace-svg request, with `run` as their content. The result is empty if
/// neither option is given.
std::vector<OutputFile> trace_files(const ChartRun& run, std::string_view title, const Options& options);

}  // namespace grafverif::app
