// SPDX-License-Identifier: MIT
// Engines: each decides the properties of one closed loop and returns what it found, ready to be shown.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/system/interrupt.hpp"
#include "app/pipeline.hpp"
#include "app/program.hpp"
#include "report/report.hpp"

namespace grafverif::app {

struct Findings {
    Report report = {};
    std::vector<std::string> failures = {};   ///< on our side: traces that do not replay; they are not in the report
};

/// A closed loop to be checked, with the charts of its controllers, in order.
struct LoopToCheck {
    const Network& network;
    std::vector<const Chart*> charts = {};
};

/// The embedded timed engine. Shows its progress on a terminal; every run is replayed on the rules first.
Findings check_embedded(const LoopToCheck& loop, const Options& options, const Streams& streams, const Interrupt& interrupt);

/// `verifyta` from the PATH, on the UPPAAL project of the loop. Nothing after an error: it is not there.
std::optional<Findings> check_by_verifyta(const LoopToCheck& loop, Job& job, const Interrupt& interrupt);

}  // namespace grafverif::app
