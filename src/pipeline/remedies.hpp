// SPDX-License-Identifier: MIT
// Trials of remedies: if a limit ended a check, tries other options of `check` for the undecided properties.
//
// A remedy is one of: more states if their number was limited; the default engine if another engine was selected; the
// untimed model with plant automata; grain atomic; a single property, in the grain of the check or atomic. A trial is a
// check with the options of a remedy and less time. Therefore a user who repeats the check with the options of a
// successful trial gets the verdicts of this trial. A verdict on an untimed model counts only if it is also valid for
// the timed loop or for every plant. If the original check was untimed with grain phased, the verdict of a trial with
// grain atomic is reported for grain atomic only.
#pragma once

#include <vector>

#include "check/shares.hpp"
#include "grafverif/grafverif.hpp"
#include "report/remedies/trials.hpp"

namespace grafverif {

/// A check that ended because a limit was reached.
struct LimitedCheck {
    const Model& model;
    Id<ClosedLoop> loop = {};
    const ModelOptions& how;
    bool timed = true;
    bool by_default_engine = true;  ///< false if an engine was selected; the trials then use the default engine
    const CheckOptions& options;    ///< options of the check; each trial has the same limits except for time
};

/// True if a declared property is undecided because a limit was reached.
bool needs_remedies(const Report& report);

/// Tries remedies until `end`. Returns the trials, sorted by the number of decided properties (largest first) and then
/// by duration.
std::vector<Trial> tried_remedies(const LimitedCheck& check, const Report& report, Deadline end);

/// Returns the part of the time of a check that is reserved for trials: a tenth of the time until `deadline`, and at
/// most 6 s. Without a deadline, the result is zero.
std::chrono::steady_clock::duration trial_time(const Deadline& deadline);
/// Returns the time at which trials that begin now must end. The result is not later than `deadline`. The trials take
/// at most `time` (see trial_time). If `time` is zero, the trials take at most a tenth of `used`, the duration of the
/// check; this maximum is at least 2 s and at most 10 s.
Deadline end_of_trials(const Deadline& deadline, std::chrono::steady_clock::duration time,
                       std::chrono::steady_clock::duration used);

}  // namespace grafverif
