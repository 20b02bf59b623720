// SPDX-License-Identifier: MIT
// `check --list`: what there is to check, for who runs each check by itself.
#pragma once

#include "app/job.hpp"

namespace grafverif::app {

/// A line per property of the loop that the options choose, of every loop where they choose none, or of every chart where
/// there is no loop: file, loop and property, with tabs between; a loop without properties, and a chart, stand alone. As
/// JSON, and as JSON lines, `{"file","line","column","model","kind":"loop|chart","property","text","expected"}`.
ExitCode list_properties(const Model& model, Job& job, const Streams& streams);

}  // namespace grafverif::app
