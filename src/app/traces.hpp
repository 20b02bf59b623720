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

/// Returns `run` as the files of --trace-vcd and --trace-svg, if requested.
std::vector<OutputFile> trace_files(const ChartRun& run, std::string_view title, const Options& options);

}  // namespace grafverif::app
