// SPDX-License-Identifier: MIT
// The interpreter: the five evolution rules of IEC 60848, 4.6, executed on a Chart as sets of steps and transitions. It
// knows nothing of Equations, so that each can be tested against the other; simulation, the program in a PLC and the
// replay of traces run on it.
//
//   rule 1  initial situation     power_on; its steps count as activated, so the first evolution runs their actions on
//                                 activation and clears nothing
//   rule 2  clearing              a transition is enabled when all steps upstream are active, and cleared when its
//                                 condition holds besides
//   rule 3  evolution             clearing activates all steps downstream and deactivates all steps upstream
//   rule 4  simultaneous          all transitions that can be cleared are cleared at once, from the old situation
//   rule 5  both at once          a step that is activated and deactivated at once stays active: it runs no action and
//                                 its time conditions go on
//
// An evolution reads old values only: conditions, events and stored values are taken over the situation and the
// variables before it. An edge compares a term with its value in the evolution before, so it is true in the first
// evolution after the change only; in the very first there is none. Stored actions on outputs change the process image at once, and what is written to the plant with the
// other outputs, at the end of a cycle. A condition that reads a continuous output asks whether an action sets it in
// the situation at hand, never what was written last.
//
// Hierarchy, level by level. A macro-step is active while a step of its expansion is; it is entered at the entry step
// and left from the exit step. An enclosing step that becomes active activates the steps with activation links; one that
// is left deactivates all it encloses, whatever happens there. A forcing order has the situation it names in every
// situation in which its step is active; while the step is, no transition of the forced chart is cleared. Source
// transitions of an expansion or enclosed chart are enabled while the step that owns it is active. At power-on the
// initial steps are active, but none whose enclosing step is not, and orders are obeyed.
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

/// How long a watched term has lasted, as of the end of an evolution; -1: it does not.
struct Timing {
    std::int64_t risen = -1;   ///< milliseconds since it became true; -1 while it is false
    std::int64_t fallen = -1;  ///< since it became false after it had lasted for its t1; -1: it has not yet

    bool operator==(const Timing&) const = default;
};

struct State {
    std::vector<bool> situation = {};        ///< per step: whether it is active
    std::vector<std::int64_t> ages = {};     ///< per step: milliseconds since its activation; inactive: -1
    std::vector<std::int64_t> values = {};   ///< per variable: internals, the image of stored outputs; others: initial
    std::vector<std::int64_t> outputs = {};  ///< per variable: outputs as written to the plant; others: initial
    std::vector<bool> previous = {};         ///< per term whose edges are read: its value in the last evolution
    std::vector<Timing> timing = {};         ///< per element of timed_elements()
    bool started = false;                    ///< the first evolution has been made

    bool operator==(const State&) const = default;
};

/// Two actions stored different values in one variable in one evolution.
struct StoredRace {
    Id<Chart::Variable> variable = {};
    Id<Chart::StoredAction> first = {}, second = {};

    bool operator==(const StoredRace&) const = default;
};

/// A value that does not exist, or does not fit: the evolution is not one of the chart.
struct RunFault {
    enum class Kind {
        NoValue,      ///< division by zero, or a result outside 64 bits, in a condition or a stored value
        OutOfRange,   ///< `value` is outside the range of `variable`
        ForcedApart,  ///< two forcing orders that cannot be obeyed together are active
    };
    Kind kind = Kind::NoValue;
    Id<Chart::Variable> variable = {};  ///< not valid: in a condition
    std::int64_t value = 0;
    Span where = {};  ///< the transition, the action or the time condition; else the chart

    bool operator==(const RunFault&) const = default;
};

struct Evolution {
    State state = {};  ///< after it; with a race or a fault: not to be used further
    std::vector<Id<Chart::Transition>> fired = {};
    bool stable = false;  ///< nothing fired, nothing changed: the situation is stable for these inputs
    std::optional<StoredRace> race = {};
    std::optional<RunFault> fault = {};
};

struct Cycle {
    State state = {};
    std::vector<std::vector<Id<Chart::Transition>>> fired = {};  ///< per evolution
    bool stable = false;                                         ///< of the last evolution
    std::optional<StoredRace> race = {};
    std::optional<RunFault> fault = {};
    /// Total instability (stability search only): the situations that follow each other for ever with these inputs;
    /// outputs were not written then.
    std::vector<std::vector<bool>> endless = {};
    /// No stable situation and no loop was found within `evolution_limit` evolutions; outputs were not written.
    bool gave_up = false;
};

/// Counters can make an instant long beyond reason though not endless.
inline constexpr std::size_t evolution_limit = 1'000'000;

/// Per Chart::variables; only the entries of inputs are read.
using InputValues = std::span<const std::int64_t>;

/// The state before the first evolution: outputs at their initial values, initial steps active, ages 0.
State power_on(const Chart& chart);

/// What of a chart depends on time: `t1/v/t2`. The delay of an action (IEC 60848, 4.8.2) is the time condition 3s/X on
/// its step, and so is the end of its limit.
struct TimedElement {
    Id<Expr> watched = {};  ///< not valid: `step` is watched
    Id<Chart::Step> step = {};
    std::int64_t rise_ms = 0;
    std::int64_t fall_ms = 0;
    Span origin = {};

    bool operator==(const TimedElement&) const = default;
};

/// The time conditions in order, then for each continuous action its delay and its limit, where it has one.
std::vector<TimedElement> timed_elements(const Chart& chart);

/// Per element of timed_elements(): whether `t1/v/t2` holds of the level that the last evolution left.
std::vector<bool> time_conditions(const Chart& chart, const State& state);

/// One evolution; the first one after power_on clears nothing. `timed`: as time_conditions() gives it.
Evolution evolve(const Chart& chart, const State& state, InputValues inputs, const std::vector<bool>& timed);
/// The same where delays may end between the reading of the conditions and the change of the situation: `ended`, per
/// element, whether its time condition held when the levels changed.
Evolution evolve(const Chart& chart, const State& state, InputValues inputs, const std::vector<bool>& timed,
                 const std::vector<bool>& ended);

/// `state` with another situation, as somebody gives it by hand: what is timed begins and ends as in an evolution, no stored
/// action is run. Empty: a time condition has no value then.
std::optional<State> with_situation(const Chart& chart, State state, std::vector<bool> situation, InputValues inputs);

/// Per variable: the outputs of `state`, of its situation and image; other entries are 0. Empty optional where an
/// assignation condition has no value. `timed`: as in the evolution that led to `state`.
std::optional<std::vector<std::int64_t>> output_values(const Chart& chart, const State& state, InputValues inputs,
                                                       const std::vector<bool>& timed);

/// One cycle of the PLC, with the time conditions as the ages of the steps have them: under stability search as many
/// evolutions as it takes, outputs written when stable; else one evolution, outputs written.
Cycle cycle(const Chart& chart, const State& state, InputValues inputs, ExecutionMode mode);

/// `state` after `milliseconds` without an evolution.
State pass_time(State state, std::int64_t milliseconds);

}  // namespace grafverif
