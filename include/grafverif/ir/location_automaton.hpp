// SPDX-License-Identifier: MIT
// LocationAutomaton: the behaviour of a controller that executes one chart, cycle by cycle (JESA13 section 4.1).
//
//   location    situation and stored variables; with stability search, only reachable stable situations
//   evolution   a change from one location to another, with a condition on the inputs. The conditions of one location
//               are mutually exclusive (JESA13, equation (7)). If no condition of an evolution or instability holds,
//               the controller stays in the location (JESA13, equation (8)).
//   INIT        the controller after power-on, before its first cycle. The first evolution activates the initial steps
//               and clears no transition; with stability search, the first cycle continues until the situation is
//               stable.
//   instability total instability: under these inputs no stable situation is ever reached (stability search only).
//               Under total instability, the controller writes no outputs and never reads its
//               inputs again.
//
// The first evolution is *visible* if it changes a variable, starts a timer, or leads to a
// situation that emits other outputs than power-on. With stability search, if the first evolution
// is not visible, INIT has no evolution for inputs under which the initial situation is stable.
// Without stability search, the controller always leaves INIT, because the first cycle clears no
// transition but the second cycle can.
//
// Timers are inputs that a tester can influence only by waiting. Without a fall time, the output of a timer is false
// while its step is inactive and immediately after the step is activated. The output rises when the time has elapsed,
// and falls only when the step is deactivated. With a fall time, the output falls when the fall time has elapsed. If a
// timer observes a term other than a step variable, the value of the term in the previous cycle (its level) is a stored
// variable. Conditions read timer outputs in the same way as inputs. An evolution lists the timers whose rise time it
// restarts (`restarted`) and the timers whose fall time it may start (`falling`).
//
// Expressions are stored in `exprs`; their leaves are Variable (index in `inputs`). `assumed` restricts the considered
// inputs (the chart's constraints). For inputs that satisfy `assumed`, all conditions are exact; for all other inputs,
// the values of the conditions are unspecified. The conditions may also assume the order of timers with the same
// observed term: if `3s/X2` is false, `5s/X2` is false.
//
// Invariants (see verify): ids are in their tables; the steps of a situation are in increasing order; locations except
// INIT differ in situation or values; `evolutions` and `instabilities` are sorted by `from`; no condition is the
// constant false; no evolution leads to INIT; the cycle of an instability is not empty; `assumed` does not read timers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/type.hpp"
#include "grafverif/support/source.hpp"
#include "grafverif/support/table.hpp"

namespace grafverif {

struct LocationAutomaton {
    struct Step {
        std::string name = {};  ///< qualified name in the chart: `2`, `G2.2`
        bool operator==(const Step&) const = default;
    };
    /// State of the chart in addition to the situation: an internal variable, an output with stored actions, a previous
    /// value for an edge, or a level that a timer observes.
    struct Stored {
        std::string name = {};
        Type type = {};
        std::int64_t initial = 0;
        bool operator==(const Stored&) const = default;
    };
    struct Input {
        std::string name = {};
        Type type = {};
        Id<Step> timed = {};  ///< for the output of a timer that observes a step: this step

        /// For the output of a timer that observes a level: this level. If `timed` and `watched` are invalid, the
        /// element is an input of the chart.
        Id<Stored> watched = {};
        std::int64_t rise_ms = 0, fall_ms = 0;  ///< t1 and t2 of `t1/v/t2`; not both 0 for a timer
        Span origin = {};
        bool operator==(const Input&) const = default;
    };
    struct Output {
        std::string name = {};
        Type type = {};
        bool operator==(const Output&) const = default;
    };

    /// An output that can be different from 0 in a location.
    struct Emission {
        Id<Output> output = {};
        /// Value of the output: a constant or, for a conditional action, a condition on the inputs.
        Id<Expr> value = {};
        bool operator==(const Emission&) const = default;
    };
    struct Location {
        std::vector<Id<Step>> situation = {};
        std::vector<std::int64_t> values = {};  ///< value of each element of `stored`
        std::vector<Emission> emissions = {};   ///< sorted by output; INIT emits the initial values of stored outputs
        bool operator==(const Location&) const = default;
    };
    struct Evolution {
        Id<Location> from = {}, to = {};
        Id<Expr> condition = {};
        std::vector<Id<Input>> restarted = {};  ///< timers whose observed term became true and holds in `to`

        /// Timers with a fall time whose observed term became false during the evolution. A timer that also has a rise
        /// time is listed only if its observed term held in `from`. The fall time starts only if the term had been true
        /// for the rise time.
        std::vector<Id<Input>> falling = {};
        bool operator==(const Evolution&) const = default;
    };
    struct Instability {
        Id<Location> from = {};
        Id<Expr> condition = {};
        /// Number of combinations of inputs and timer outputs that satisfy `condition`; empty if it exceeds 64 bits.
        std::optional<std::uint64_t> combinations = {};
        std::vector<std::int64_t> witness = {};         ///< for each input: values for which the instability occurs
        std::vector<std::vector<Id<Step>>> cycle = {};  ///< the situations that repeat forever
        bool operator==(const Instability&) const = default;
    };

    std::string name = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    Exprs exprs = {};
    Table<Input> inputs = {};
    Table<Output> outputs = {};
    Table<Step> steps = {};
    Table<Stored> stored = {};
    Table<Location> locations = {};
    Id<Location> init = {};
    std::vector<Evolution> evolutions = {};
    std::vector<Instability> instabilities = {};
    bool complete = true;       ///< false: a limit ended the search, and there may be further locations and evolutions
    std::size_t looked_at = 0;  ///< for the first `looked_at` locations, all evolutions are known
    Id<Expr> assumed = {};
    Span origin = {};

    bool operator==(const LocationAutomaton&) const = default;
};

/// True if the input is a timer output.
inline bool is_timer(const LocationAutomaton::Input& input) { return input.timed.valid() || input.watched.valid(); }

/// True if the term that the timer observes holds in `location`: the observed step is active, or the observed level was
/// true in the previous cycle.
bool level(const LocationAutomaton::Location& location, const LocationAutomaton::Input& timer);

/// Returns the term that the timer observes: `step 2`, `V_a`.
std::string watched_text(const LocationAutomaton& automaton, const LocationAutomaton::Input& timer);

/// Return the evolutions from `location`, or the instabilities in `location`.
std::span<const LocationAutomaton::Evolution> evolutions_from(const LocationAutomaton& automaton,
                                                              Id<LocationAutomaton::Location> location);
std::span<const LocationAutomaton::Instability> instabilities_of(const LocationAutomaton& automaton,
                                                                 Id<LocationAutomaton::Location> location);

/// Returns the names of the active steps: `{2,5}`.
std::string situation_text(const LocationAutomaton& automaton,
                           const std::vector<Id<LocationAutomaton::Step>>& situation);

std::vector<std::string> verify(const LocationAutomaton& automaton);

}  // namespace grafverif
