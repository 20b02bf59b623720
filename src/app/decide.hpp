// SPDX-License-Identifier: MIT
// What `check` and `report` share: the options choose a loop or a chart, a model of it and an engine, and the engine finds
// out what it can.
#pragma once

#include <optional>

#include "app/job.hpp"
#include "grafverif/ir/why.hpp"

namespace grafverif::app {

struct Decided {
    Report report = {};
    Id<ClosedLoop> loop = {};  ///< not valid: a chart alone
    Id<Chart> chart = {};      ///< valid of a chart alone
    bool timed = false;
    std::optional<Why> why = {};  ///< where it was asked for, of a loop
};
/// Nothing after an error. `witnesses`: runs that show what holds, too. Of a chart alone `streams` are told so before.
std::optional<Decided> decide(const Model& model, Job& job, Bounds& bounds, bool witnesses, const Streams& streams);

/// What the verdicts of a report make of a run of the program.
ExitCode exit_code(const Report& report, bool stopped);

}  // namespace grafverif::app
