// SPDX-License-Identifier: MIT
// Trials of remedies: if a limit ended a check, other options of `check` are tried for its undecided properties.
//
// A remedy is one of: more states if their number was limited; the default engine if another engine was selected; the
// untimed model with plant automata; grain atomic; a single property, in the grain of the check or atomic. A trial is a
// check with the options of a remedy and less time. Therefore a user who repeats the check with the options of a
// successful trial gets the verdicts of this trial. A verdict on an untimed model counts only if it is preserved for
// the timed loop, or for every plant. If the check was untimed with grain phased, the verdict of a trial with grain
// atomic is reported for grain atomic only.
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
    bool by_default_engine = true;  ///< false if an engine was selected; the trials then use the default engine
    const CheckOptions& options;    ///< options of the check; except for the time limit, its limits apply to each trial
};

/// True if a limit left a declared property open.
bool needs_remedies(const Report& report);

/// Tries remedies until `end`. Returns the trials, sorted by the number of decided properties (largest first) and then
/// by duration.
std::vector<Trial> tried_remedies(const LimitedCheck& check, const Report& report, Deadline end);

/// Returns the time for trials within a check that begins now: a tenth of the time until `deadline`, and at most 6 s.
/// Without a deadline, the time is zero.
std::chrono::steady_clock::duration trial_time(const Deadline& deadline);
/// Returns the time at which trials that begin now must end. This time is not later than `deadline`. The trials take at
/// most `time` (see trial_time); if `time` is zero, the maximum is a tenth of the time `used` by the check, but not
/// less than 2 s and not more than 10 s.
Deadline end_of_trials(const Deadline& deadline, std::chrono::steady_clock::duration time,
                       std::chrono::steady_clock::duration used);

}  // namespace grafverif
