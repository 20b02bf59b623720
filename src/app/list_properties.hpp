// SPDX-License-Identifier: MIT
// `check --list`: lists the available checks, for tools that run each check separately.
#pragma once

#include "app/command_context.hpp"

namespace grafverif::app {

/// Prints one line per property of the selected loop; of every loop if none is selected; of every chart if there is no
/// loop. A line consists of file, loop and property, separated by tabs. A loop without properties, and a chart, has a
/// line without a property. As JSON and as JSON lines, an entry is
/// `{"file","line","column","model","kind":"loop|chart","property","text","expected"}`.
ExitCode list_properties(const Model& model, CommandContext& job, const Streams& streams);

}  // namespace grafverif::app
