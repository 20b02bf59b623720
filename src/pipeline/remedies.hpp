// SPDX-License-Identifier: MIT
// Trials of remedies: if a limit ended a check, other options of `check` are tried for the properties that it left open.
//
// A remedy is one of: more states if their number was limited; the default engine if another one was selected; the
// untimed model with plant automata; grain atomic; a single property, in the grain of the check or atomic. A trial is a
// check with these options and less time. Therefore, a user who repeats the check with the options of a successful
// trial gets its verdicts. A verdict on an untimed model counts only if it is preserved for the timed loop, or for
// every plant. A verdict for grain atomic of an untimed check is preserved only for grain atomic.
#pragma once

#include <vector>

#include "check/shares.hpp"
#include "grafverif/grafverif.hpp"
#include "report/remedies/trials.hpp"

namespace grafverif {

/// The check that a limit ended.
struct LimitedCheck {
    const Model& model;
    Id<ClosedLoop> loop = {};
    const ModelOptions& how;
    bool timed = true;
    bool by_default_engine = true;  ///< otherwise an engine was selected, and the trials use the default one
    const CheckOptions& options;    ///< its limits are those of each trial, apart from the time
};

/// True if a limit left a declared property open.
bool needs_remedies(const Report& report);

/// Tries remedies until `end`; those that decide most properties come first, then those that need less time.
std::vector<Trial> tried_remedies(const LimitedCheck& check, const Report& report, Deadline end);

/// Time for trials within a check that begins now: a tenth of the time until `deadline`, and at most 6 s. Zero without
/// a deadline.
std::chrono::steady_clock::duration trial_time(const Deadline& deadline);
/// The end of trials that begin now. `time`: see trial_time; if it is zero, a tenth of the time `used` by the check, 2 s
/// at least and 10 s at most.
Deadline end_of_trials(const Deadline& deadline, std::chrono::steady_clock::duration time,
                       std::chrono::steady_clock::duration used);

}  // namespace grafverif
