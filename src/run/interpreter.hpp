// SPDX-License-Identifier: MIT
// Interpreter: executes the five evolution rules of IEC 60848 on a Chart as sets of steps and transitions. It is
// independent of Equations, so that each can be tested against the other. Used by simulation, the program in a PLC and
// the replay of traces.
//
//   rule 1  initial situation     power_on; its steps count as activated, so the first evolution runs their actions on
//                                 activation and clears nothing
//   rule 2  clearing              a transition is enabled when all upstream steps are active, and cleared when its
//                                 condition also holds
//   rule 3  evolution             clearing activates all downstream steps and deactivates all upstream steps
//   rule 4  simultaneous          all transitions that can be cleared are cleared simultaneously, from the old
//           situation
//   rule 5  activated and         a step that is activated and deactivated simultaneously stays active: it runs no
//           action
//           deactivated           and its time conditions continue
//
// An evolution reads only old values: conditions, events and stored values are evaluated over the situation and the
// variables before it. An edge compares a term with its value in the previous evolution, so it is true only in the
// first evolution after the change; in the very first evolution there is no edge. Stored actions on outputs change the
// process image immediately; the plant receives it with the other outputs at the end of a cycle. A condition that reads
// a continuous output evaluates the actions on it in the current situation, not the value last written.
//
// Hierarchy, level by level. A macro-step is active while a step of its expansion is; it is entered at the entry step
// and left from the exit step. An enclosing step that becomes active activates the steps with activation links; one
// that is left deactivates all enclosed steps, independently of the enclosed evolution. A forcing order imposes the
// situation it names in every situation in which its step is active, and no transition of the forced chart is cleared
// meantime. Source transitions of an expansion or enclosed chart are enabled while the step that owns it is active. At
// power-on the initial steps are active, except those whose enclosing step is not, and orders take effect.
//
// Requires a chart that `derive` accepts: verify(chart).empty(), no cycle among outputs or levels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/closed_loop.hpp"

namespace grafverif {

/// Elapsed times of an observed term at the end of an evolution.
struct Timing {
    std::int64_t risen = -1;   ///< milliseconds since it became true; -1 while it is false
    std::int64_t fallen = -1;  ///< milliseconds since it became false after it had lasted for its t1; -1 if it has not

    bool operator==(const Timing&) const = default;
};

struct State {
    std::vector<bool> situation = {};        ///< per step: true if active
    std::vector<std::int64_t> ages = {};     ///< per step: milliseconds since its activation; inactive: -1
    std::vector<std::int64_t> values = {};   ///< per variable: internals, the image of stored outputs; others: initial
    std::vector<std::int64_t> outputs = {};  ///< per variable: outputs as written to the plant; others: initial
    std::vector<bool> previous = {};         ///< per term whose edges are read: its value in the previous evolution
    std::vector<Timing> timing = {};         ///< per element of timed_elements()
    bool started = false;                    ///< the first evolution has been executed

    bool operator==(const State&) const = default;
};

/// Two actions stored different values in one variable in one evolution.
struct StoredRace {
    Id<Chart::Variable> variable = {};
    Id<Chart::StoredAction> first = {}, second = {};

    bool operator==(const StoredRace&) const = default;
};

/// A value that is undefined or out of range: the evolution is not one of the chart.
struct RunFault {
    enum class Kind {
        NoValue,      ///< division by zero, or a result outside 64 bits, in a condition or a stored value
        OutOfRange,   ///< `value` is outside the range of `variable`
        ForcedApart,  ///< two contradictory forcing orders are active
    };
    Kind kind = Kind::NoValue;
    Id<Chart::Variable> variable = {};  ///< invalid for a value in a condition
    std::int64_t value = 0;
    Span where = {};  ///< the transition, the action or the time condition; otherwise the chart

    bool operator==(const RunFault&) const = default;
};

struct Evolution {
    State state = {};  ///< after the evolution; with a race or a fault it must not be used further
    std::vector<Id<Chart::Transition>> fired = {};
    bool stable = false;  ///< no transition cleared and nothing changed: the situation is stable for these inputs
    std::optional<StoredRace> race = {};
    std::optional<RunFault> fault = {};
};

struct Cycle {
    State state = {};
    std::vector<std::vector<Id<Chart::Transition>>> fired = {};  ///< per evolution
    bool stable = false;                                         ///< of the last evolution
    std::optional<StoredRace> race = {};
    std::optional<RunFault> fault = {};
    /// Total instability (stability search only): the situations that repeat forever with these inputs; outputs were
    /// not written then.
    std::vector<std::vector<bool>> endless = {};
    /// Neither a stable situation nor a cycle was found within `evolution_limit` evolutions; outputs were not written.
    bool gave_up = false;
};

/// Limit for one cycle: with counters, an instant can be finite but extremely long.
inline constexpr std::size_t evolution_limit = 1'000'000;

/// Per Chart::variables; only the entries of inputs are read.
using InputValues = std::span<const std::int64_t>;

/// The state before the first evolution: outputs at their initial values, initial steps active, ages 0.
State power_on(const Chart& chart);

/// An element of a chart that depends on time: `t1/v/t2`. The delay of an action (IEC 60848) is the time
/// condition 3s/X on its step, and so is the end of its limit.
struct TimedElement {
    Id<Expr> watched = {};  ///< invalid: `step` is observed
    Id<Chart::Step> step = {};
    std::int64_t rise_ms = 0;
    std::int64_t fall_ms = 0;
    Span origin = {};

    bool operator==(const TimedElement&) const = default;
};

/// The time conditions in order, then for each continuous action its delay and its limit, if any.
std::vector<TimedElement> timed_elements(const Chart& chart);

/// Per element of timed_elements(): true if `t1/v/t2` holds for the level after the last evolution.
std::vector<bool> time_conditions(const Chart& chart, const State& state);

/// Executes one evolution; the first one after power_on clears nothing. `timed`: as returned by time_conditions().
Evolution evolve(const Chart& chart, const State& state, InputValues inputs, const std::vector<bool>& timed);
/// The same if delays may elapse between the evaluation of conditions and the change of the situation. `ended`: per
/// element, the time condition at the change of the levels.
Evolution evolve(const Chart& chart, const State& state, InputValues inputs, const std::vector<bool>& timed,
                 const std::vector<bool>& ended);

/// `state` with another situation, set by the user: timing starts and stops as in an evolution, stored actions are not
/// executed. Empty if a time condition is then undefined.
std::optional<State> with_situation(const Chart& chart, State state, std::vector<bool> situation, InputValues inputs);

/// Per variable: the outputs for the situation and image of `state`; other entries are 0. Empty optional if an
/// assignation condition is undefined. `timed`: as in the evolution that led to `state`.
std::optional<std::vector<std::int64_t>> output_values(const Chart& chart, const State& state, InputValues inputs,
                                                       const std::vector<bool>& timed);

/// One cycle of the PLC, with time conditions from the ages of the steps. Under stability search it executes evolutions
/// until the situation is stable and then writes the outputs; otherwise it executes one evolution and writes the
/// outputs.
Cycle cycle(const Chart& chart, const State& state, InputValues inputs, ExecutionMode mode);

/// `state` after `milliseconds` without an evolution.
State pass_time(State state, std::int64_t milliseconds);

}  // namespace grafverif
