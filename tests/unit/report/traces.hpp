// SPDX-License-Identifier: MIT
// A small trace by hand, and a report around it.
#pragma once

#include "grafverif/report/report.hpp"

namespace grafverif {

/// A press of a button starts a motor that moves a slide; the steps from 3 on repeat for ever.
inline Trace sample_trace() {
    Trace trace;
    trace.steps_of_charts = {"0", "1", "G2.2"};
    trace.short_names = {"0", "1", "2"};
    trace.inputs = {{"START", {}}, {"LEVEL", integer_type(0, 9)}};
    trace.outputs = {{"GO", {}}, {"IDLE", {}}};
    trace.internals = {{"COUNT", integer_type(-4, 4)}};
    trace.plant = {{"X", integer_type(0, 20)}};
    const auto state = [](std::int64_t ms, std::vector<std::uint32_t> situation, std::vector<std::int64_t> inputs,
                          std::vector<std::int64_t> outputs, std::int64_t count, std::int64_t x) {
        return Trace::State{ms, std::move(situation), std::move(inputs), std::move(outputs), {count}, {x}};
    };
    trace.steps = {
        {Trace::Kind::Controller, "press", "power on", {}, false, state(0, {0, 2}, {0, 2}, {0, 0}, 0, 0)},
        {Trace::Kind::Environment, "Start", "", {}, false, state(0, {0, 2}, {1, 2}, {0, 0}, 0, 0)},
        {Trace::Kind::Controller, "press", "", {{"t1"}, {"t2", "t3"}}, false, state(0, {1, 2}, {1, 2}, {1, 0}, -1, 0)},
        {Trace::Kind::Delay, "", "1.5 s pass", {}, false, state(1500, {1, 2}, {1, 2}, {1, 0}, -1, 0)},
        {Trace::Kind::Plant, "Slide", "going_out, X 0 -> 4", {}, false, state(1500, {1, 2}, {1, 3}, {1, 0}, -1, 4)},
    };
    trace.loop_from = 3;
    return trace;
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
    Verdict unknown{.property = "P3", .obstacle = Obstacle::Bound, .reason = "12 states are not enough", .states = "12"};
    Verdict timelock{.property = "no_timelock",
                     .pattern = Pattern::NoTimelock,
                     .obstacle = Obstacle::Inexact,
                     .reason = "`Slide` may be stuck between two ticks",
                     .declared = false};
    Verdict expected{.property = "P4", .outcome = Outcome::Violated, .expected_violated = true};
    Verdict vacuous{.property = "P5", .outcome = Outcome::Holds, .vacuous = true, .notes = {"time never passes"}};
    report.answers = {{holds, "all is well", {}},
                      {violated, "a <dangerous> & \"quoted\" text", sample_trace()},
                      {unknown, "", {}},
                      {timelock, "", {}},
                      {expected, "", sample_trace()},
                      {vacuous, "", {}}};
    return report;
}

}  // namespace grafverif
