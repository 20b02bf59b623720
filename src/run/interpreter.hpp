// SPDX-License-Identifier: MIT
// Interpreter: executes the five evolution rules of IEC 60848 on a Chart as sets of steps and transitions. The
// interpreter does not use Equations, so that both implementations of the standard can be tested against each other.
// The simulation, the emulation of a PLC and the replay of traces use the interpreter.
//
//   rule 1  initial situation see power_on: the first evolution executes the activation actions of the initial steps
//                                 on activation and clears no transition
//   rule 2  clearing              a transition is enabled when all upstream steps are active, and cleared when its
//                                 condition also holds
//   rule 3  evolution             clearing activates all downstream steps and deactivates all upstream steps
//   rule 4  simultaneous          all transitions that can be cleared in the old situation are cleared simultaneously
//   rule 5  activated and         a step that is activated and deactivated simultaneously stays active: its actions on
//           deactivated           activation and deactivation are not executed, and its time conditions continue
//
// An evolution reads only old values: conditions, events and stored values are evaluated over the situation and the
// variables before the evolution. An edge (IEC 60848) compares a term with its value in the previous evolution.
// Therefore, an edge is true only in the first evolution after a change of its term, and never in the first evolution
// after power-on. Stored actions on outputs change the process image immediately. At the end of a cycle, the image and
// all other outputs are written to the plant. If a condition reads a continuous output, the actions on the output are
// evaluated in the current situation; the last written value is not used.
//
// The hierarchy is applied one level after another. A macro-step is active while a step of its expansion is active.
// The activation of a macro-step activates its entry step; transitions from the macro-step are enabled only while its
// exit step is active. If an enclosing step becomes active, the steps with activation links become active. If the
// enclosing step is deactivated, all enclosed steps are deactivated, independently of the enclosed evolution. While the
// step of a forcing order is active, the forced chart is in the situation that the order names, and none of its
// transitions is cleared. Source transitions of an expansion (or of an enclosed chart) are enabled while its macro-step
// (or its enclosing step) is active. At power-on, the initial steps are active, except for steps whose enclosing step
// is inactive, and forcing orders are applied.
//
// Requires a chart that `derive` accepts: verify(chart).empty(), no cycle of outputs that read each other, and no cycle
// of charts that enclose or force each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/closed_loop.hpp"

namespace grafverif {

/// The times since the last changes of an observed term, at the end of an evolution.
struct Timing {
    std::int64_t risen = -1;  ///< milliseconds since the term became true; -1 while the term is false
    /// Milliseconds since the term became false; -1 while the term is true, or if it was true for less than the rise
    /// time t1.
    std::int64_t fallen = -1;

    bool operator==(const Timing&) const = default;
};

struct State {
    std::vector<bool> situation = {};     ///< for each step: true if the step is active
    std::vector<std::int64_t> ages = {};  ///< for each step: milliseconds since its activation; -1 if inactive
    /// For each internal variable: its value. For each output with stored actions: its image. For any other variable:
    /// its initial value.
    std::vector<std::int64_t> values = {};
    /// For each output: the value last written to the plant. For any other variable: its initial value.
    std::vector<std::int64_t> outputs = {};
    std::vector<bool> previous = {};  ///< for each term whose edges are read: its value in the previous evolution
    std::vector<Timing> timing = {};  ///< for each element of timed_elements(): its timing
    bool started = false;             ///< true if the first evolution has been executed

    bool operator==(const State&) const = default;
};

/// A race: two actions have stored different values in one variable in one evolution.
struct StoredRace {
    Id<Chart::Variable> variable = {};
    Id<Chart::StoredAction> first = {}, second = {};

    bool operator==(const StoredRace&) const = default;
};

/// A fault in an evolution, such as an undefined or out-of-range value. After a fault, the computed state is not a
/// state of the chart.
struct RunFault {
    enum class Kind {
        NoValue,      ///< division by zero, or a result outside 64 bits, in a condition or a stored value
        OutOfRange,   ///< `value` is outside the range of `variable`
        ForcedApart,  ///< two contradictory forcing orders are active
    };
    Kind kind = Kind::NoValue;
    Id<Chart::Variable> variable = {};  ///< variable of the stored value; invalid for a value in a condition
    std::int64_t value = 0;
    /// Position of the transition, action or time condition that causes the fault; otherwise the position of the chart.
    Span where = {};

    bool operator==(const RunFault&) const = default;
};

struct Evolution {
    State state = {};  ///< state after the evolution; after a race or a fault it must not be used
    std::vector<Id<Chart::Transition>> fired = {};
    /// True if the situation is stable for these inputs: the evolution cleared no transition, no event executed an
    /// action, and a further evolution with these inputs, in which all edges are false, would clear no transition.
    bool stable = false;
    std::optional<StoredRace> race = {};
    std::optional<RunFault> fault = {};
};

struct Cycle {
    State state = {};
    std::vector<std::vector<Id<Chart::Transition>>> fired = {};  ///< cleared transitions per evolution
    /// True if the last evolution was stable (Evolution::stable).
    bool stable = false;
    std::optional<StoredRace> race = {};
    std::optional<RunFault> fault = {};
    /// Total instability (stability search only): the situations that repeat forever with these inputs. After total
    /// instability, the outputs are not written.
    std::vector<std::vector<bool>> endless = {};
    /// True if the search found neither a stable situation nor a cycle within `evolution_limit` evolutions, so that the
    /// outputs are not written.
    bool gave_up = false;
};

/// The maximum number of evolutions in one cycle. In a chart with counters, the number of evolutions can be finite but
/// extremely large.
inline constexpr std::size_t evolution_limit = 1'000'000;

/// One value for each element of Chart::variables; only the values of inputs are read.
using InputValues = std::span<const std::int64_t>;

/// Returns the state before the first evolution: outputs have their initial values, and the steps that are active at
/// power-on have age 0.
State power_on(const Chart& chart);

/// An element of a chart that depends on time: `t1/v/t2`. The delay of an action (IEC 60848) is a time condition such
/// as 3s/X on the step of the action. A time condition also represents the time limit of an action.
struct TimedElement {
    Id<Expr> watched = {};  ///< observed term; invalid if `step` is observed
    Id<Chart::Step> step = {};
    std::int64_t rise_ms = 0;
    std::int64_t fall_ms = 0;
    Span origin = {};

    bool operator==(const TimedElement&) const = default;
};

/// Returns the time conditions of the chart in order, followed by the delays and time limits of continuous actions.
std::vector<TimedElement> timed_elements(const Chart& chart);

/// Returns, for each element `t1/v/t2` of timed_elements(), true if this time condition holds for the value of v after
/// the last evolution.
std::vector<bool> time_conditions(const Chart& chart, const State& state);

/// Executes one evolution. The first evolution after power_on clears no transition. `timed` is the result of
/// time_conditions().
Evolution evolve(const Chart& chart, const State& state, InputValues inputs, const std::vector<bool>& timed);
/// Executes one evolution in which delays may elapse between the evaluation of conditions and the change of the
/// situation. `ended` contains the value of each time condition when the observed terms change.
Evolution evolve(const Chart& chart, const State& state, InputValues inputs, const std::vector<bool>& timed,
                 const std::vector<bool>& ended);

/// Returns `state` with the situation `situation`, which the user has set. Timing starts and stops as in an evolution;
/// stored actions are not executed. The result is empty if a time condition is undefined in this situation.
std::optional<State> with_situation(const Chart& chart, State state, std::vector<bool> situation, InputValues inputs);

/// Returns the values of the outputs for the situation and process image of `state`, indexed by variable; the entries
/// of other variables are 0. The result is empty if an assignation condition is undefined. `timed` is the argument
/// `timed` of the evolution that led to `state`.
std::optional<std::vector<std::int64_t>> output_values(const Chart& chart, const State& state, InputValues inputs,
                                                       const std::vector<bool>& timed);

/// Executes one PLC cycle; `state` determines the values of time conditions. Under stability search, the cycle consists
/// of evolutions until the situation is stable. Without stability search, it consists of one evolution. After its
/// evolutions, the cycle writes the outputs.
Cycle cycle(const Chart& chart, const State& state, InputValues inputs, ExecutionMode mode);

/// Returns `state` after `milliseconds` have passed without an evolution.
State pass_time(State state, std::int64_t milliseconds);

}  // namespace grafverif
