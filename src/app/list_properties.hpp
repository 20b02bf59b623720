// SPDX-License-Identifier: MIT
// `check --list`: lists the available checks, for tools that run each check separately.
#pragma once

#include "app/command_context.hpp"

namespace grafverif::app {

/// Prints one line for each property of the selected loop; by default, of every loop. A line consists of file, loop and
/// property, separated by tabs. A loop without properties has one line without a property. If a chart is selected,
/// prints one line without a property for this chart. If the file has no loop, prints one line without a property for
/// every chart. As JSON and as JSON lines, an entry is
/// `{"file","line","column","model","kind":"loop|chart","property","text","expected"}`.
ExitCode list_properties(const Model& model, CommandContext& job, const Streams& streams);

}  // namespace grafverif::app
