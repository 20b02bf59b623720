// SPDX-License-Identifier: MIT
// Provides a hand-written run, and a report that contains it.
#pragma once

#include "report/report.hpp"

namespace grafverif {

/// Returns a run in which a press of a button starts a motor that moves a slide. The rows from 3 on repeat forever.
inline ChartRun sample_run() {
    using Kind = ChartRun::Kind;
    using Role = ChartRun::Role;
    ChartRun run;
    for (const StepName& name : {StepName{"", "0"}, StepName{"", "1"}, StepName{"G2", "2"}})
        run.steps.add({name, "", ""});
    shorten_names(run.steps);
    for (const char* name : {"t1", "t2", "t3"}) run.transitions.add({name});
    run.signals.add({Role::Input, "START", {}});
    run.signals.add({Role::Output, "GO", {}});
    run.signals.add({Role::Input, "LEVEL", integer_type(0, 9)});
    run.signals.add({Role::Output, "IDLE", {}});
    run.signals.add({Role::Internal, "COUNT", integer_type(-4, 4)});
    run.signals.add({Role::Plant, "X", integer_type(0, 20)});
    const auto add = [&run](ChartRun::Row row, std::int64_t ms, std::uint32_t step, std::vector<std::int64_t> values) {
        row.moment = run.moments.size();
        run.moments.push_back({.kind = row.kind, .move = row.moment, .after = {ms, {{step}, {2}}, std::move(values)}});
        run.rows.push_back(std::move(row));
    };
    add({Kind::Controller, "press", "power on"}, 0, 0, {0, 0, 2, 0, 0, 0});
    add({Kind::Environment, "Start", ""}, 0, 0, {1, 0, 2, 0, 0, 0});
    add({Kind::Controller, "press", "", {{{0}}, {{1}, {2}}}}, 0, 1, {1, 1, 2, 0, -1, 0});
    add({Kind::Delay, "", "1.5 s pass"}, 1500, 1, {1, 1, 2, 0, -1, 0});
    add({Kind::Plant, "Slide", "going_out, X 0 -> 4"}, 1500, 1, {1, 1, 3, 0, -1, 4});
    run.loop = run.loop_from = 3;
    return run;
}

inline Report sample_report() {
    Report report{"station", {"timed", "stability-search", "phased", 500}, {}, {}};
    Verdict holds{.property = "P1", .outcome = Outcome::Holds, .states = "12", .transitions = 20, .seconds = 0.25};
    Verdict violated{.property = "P2",
                     .pattern = Pattern::LeadsTo,
                     .outcome = Outcome::Violated,
                     .states = "12",
                     .transitions = 20,
                     .seconds = 0.25};
    Verdict unknown{
        .property = "P3", .obstacle = UnknownReason::Bound, .reason = "12 states are not enough", .states = "12"};
    Verdict timelock{.property = "no_timelock",
                     .pattern = Pattern::NoTimelock,
                     .obstacle = UnknownReason::Inexact,
                     .reason = "`Slide` may be stuck between two ticks",
                     .declared = false};
    Verdict expected{.property = "P4", .outcome = Outcome::Violated, .expected_violated = true};
    Verdict vacuous{.property = "P5", .outcome = Outcome::Holds, .vacuous = true, .notes = {"time never passes"}};
    report.answers = {{holds, "all is well", {}},
                      {violated, "a <dangerous> & \"quoted\" text", sample_run()},
                      {unknown, "", {}},
                      {timelock, "", {}},
                      {expected, "", sample_run()},
                      {vacuous, "", {}}};
    return report;
}

}  // namespace grafverif
