// SPDX-License-Identifier: MIT
// schedule_both: two charts side by side: Equations, Equations -> TransitionSystem. Both are run scan by scan, as a PLC runs
// them: inputs are read, the chart answers, time passes, whatever the inputs and times are; they are the same for both.
//
// A step of the system is one evolution of both charts, or, where both have answered (`waits`), the time until the next scan
// and its inputs. Under stability search the inputs stay until both are settled; who is settled first goes on without
// changing anything. In every_cycle mode a scan is one evolution. A fault (race, value out of range, none at all) is an
// answer too, for ever.
//
//   timer        counts down in units of `unit_ms`: the rest of t1 while its term holds, the rest of t2 since it fell; scans
//                are at whole units. What a unit is, and so what is not seen, is for the caller to say
//   same         never: both have answered, and one has a fault and the other none, or an output differs
//   possible     reachable: there are inputs that the constraints of both allow
//   a_follows, b_follows   where b has answered without a fault, a answers some time: else it never becomes stable, and b
//                does; that one has a fault and the other never becomes stable is the same. Under stability search alone
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/transition_system.hpp"

namespace grafverif {

struct BothOptions {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::int64_t unit_ms = 1;                      ///< divides all durations of both
    std::optional<std::int64_t> fewer_scans = {};  ///< `same` speaks of runs of fewer scans than this
};

struct Both {
    TransitionSystem system = {};
    std::vector<Id<TransitionSystem::Symbol>> inputs = {};  ///< in the order of the first chart's
    Id<TransitionSystem::Symbol> waits = {};                ///< both have answered the scan
    Id<TransitionSystem::Symbol> passed =
        {};  ///< in a step from there: units until the next scan; not valid: no timers
};

/// Requires the same inputs and outputs in both, of the same types, and verify to be empty for both.
Both schedule_both(const Equations& a, const Equations& b, const BothOptions& options);

}  // namespace grafverif
