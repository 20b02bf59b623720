// SPDX-License-Identifier: MIT
// Replay of a run of a TransitionSystem on the rules of IEC 60848: every evolution that a controller makes in it is
// done again by the interpreter on the chart itself, with the inputs and time conditions it sampled; transitions
// cleared, situation, internals and written outputs must agree. What a time condition is worth nobody checks where
// the system does not keep time.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/flat_system.hpp"
#include "grafverif/run/replay.hpp"

namespace grafverif {

/// The first disagreement, if any; its `move` is the step of the run. `charts`: those of system.controllers, in order.
std::optional<Disagreement> disagreement(const TransitionSystem& system, std::span<const Chart* const> charts,
                                         const SystemRun& run);

/// Of a system that does not keep time: two times over one step, of which a cycle of the run samples the longer as over
/// and the shorter as not. No plant gives such a run.
struct Untimely {
    std::string step = {};   ///< as the chart names it
    std::int64_t longer_ms = 0, shorter_ms = 0;
};
std::optional<Untimely> untimely(const TransitionSystem& system, const SystemRun& run);

}  // namespace grafverif
