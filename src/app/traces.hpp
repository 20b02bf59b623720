// SPDX-License-Identifier: MIT
// What `check` and `simulate` share: runs that must replay, and traces that go to files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/system/files.hpp"
#include "app/pipeline.hpp"
#include "grafverif/ir/chart_run.hpp"
#include "run/replay.hpp"

namespace grafverif::app {

/// The charts of the loop's controllers, in order.
std::vector<const Chart*> charts_of(const Model& model, const ClosedLoop& loop);

/// `the counterexample of P15 does not replay: controller press, evolution 3: ...`
std::string replay_failure(std::string_view what, const Disagreement& disagreement);

/// `run` as the files of --trace-vcd and --trace-svg, where they are asked for.
std::vector<OutputFile> trace_files(const ChartRun& run, std::string_view title, const Options& options);

}  // namespace grafverif::app
