// SPDX-License-Identifier: MIT
// LocationAutomaton: what a controller that executes one chart does, cycle by cycle (JESA13 section 4.1).
//
//   location    the situation and the stored variables; with stability search only the stable ones that can be reached
//   evolution   from one location to another, under a condition on the inputs; the conditions of one location exclude
//               each other (JESA13 (7)); where none of them holds, nor an instability, the controller stays (8)
//   INIT        the controller after power-on, before its first cycle. The first evolution activates the initial steps
//               and clears nothing; with stability search the cycle goes on until the situation is stable.
//   instability total instability: under these inputs no stable situation is ever reached (stability search only).
//               The controller writes no outputs and never reads its inputs again.
//
// With stability search INIT stays INIT under the inputs for which the initial situation is stable, provided that the
// first evolution changed no variable, started no timer, and the initial situation emits what power-on did: nothing
// happened then.
// Without it INIT is always left, for its next cycle does what its first did not: clear transitions.
//
// Timers are inputs that a tester can only wait for. Without a fall time the end of a timer is false while its step is
// inactive and when the step has just been activated; it rises while nothing else changes, and falls only with its
// step. A term that is no step is watched by its level in the last cycle, which is one of the stored variables. With a
// fall time the end falls while nothing else changes, too. Conditions read it as any input; an evolution tells the timers
// whose rise time it starts anew (`restarted`) and those whose fall time it may start (`falling`).
//
// Expressions live in `exprs`; their leaves are Variable -> inputs. Under `assumed`, which restricts the inputs
// considered (the chart's constraints), all conditions are exact; elsewhere they mean nothing. They may also rely on what
// timers of one level cannot do: `5s/X2` does not hold where `3s/X2` does not.
//
// Invariants (see verify): ids in their tables; situations increase; locations differ in situation or values, INIT
// apart; `evolutions` and `instabilities` are ordered by `from`; no condition is the constant false; INIT is
// nobody's target; a cycle of instability is not empty; what is assumed reads no timers.
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
        std::string name = {};  ///< as the chart names it, qualified: `2`, `G2.2`
        bool operator==(const Step&) const = default;
    };
    /// What outlives a cycle besides the situation: an internal, an output with stored actions, a previous value that an
    /// edge is compared with, a level that a timer watches.
    struct Stored {
        std::string name = {};
        Type type = {};
        std::int64_t initial = 0;
        bool operator==(const Stored&) const = default;
    };
    struct Input {
        std::string name = {};
        Type type = {};
        Id<Step> timed = {};                    ///< the end of a timer over this step
        Id<Stored> watched = {};                ///< the end of a timer over this level; neither valid: an input proper
        std::int64_t rise_ms = 0, fall_ms = 0;  ///< t1 and t2 of `t1/v/t2` (IEC 60848, 4.4); not both 0 for a timer
        Span origin = {};
        bool operator==(const Input&) const = default;
    };
    struct Output {
        std::string name = {};
        Type type = {};
        bool operator==(const Output&) const = default;
    };

    /// An output that is not the constant 0 in a location.
    struct Emission {
        Id<Output> output = {};
        Id<Expr> value = {};  ///< a constant, or a condition on the inputs: a conditional action
        bool operator==(const Emission&) const = default;
    };
    struct Location {
        std::vector<Id<Step>> situation = {};
        std::vector<std::int64_t> values = {};  ///< per `stored`
        std::vector<Emission> emissions = {};   ///< by output; of INIT: the stored outputs, at their initial values
        bool operator==(const Location&) const = default;
    };
    struct Evolution {
        Id<Location> from = {}, to = {};
        Id<Expr> condition = {};
        std::vector<Id<Input>> restarted = {};  ///< timers whose level holds in `to` and became true on the way
        /// Timers with a fall time whose level became false on the way, one with a rise time only where it had held in
        /// `from`: where the level had lasted for the rise time, the fall time starts.
        std::vector<Id<Input>> falling = {};
        bool operator==(const Evolution&) const = default;
    };
    struct Instability {
        Id<Location> from = {};
        Id<Expr> condition = {};
        std::optional<std::uint64_t> combinations =
            {};  ///< how many of inputs and timer ends; empty: more than 64 bits can count
        std::vector<std::int64_t> witness = {};         ///< per input: values under which it happens
        std::vector<std::vector<Id<Step>>> cycle = {};  ///< the situations that follow each other for ever
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
    bool complete = true;       ///< else there may be more locations and evolutions than those found
    std::size_t looked_at = 0;  ///< of how many locations all evolutions are known; the first so many
    Id<Expr> assumed = {};
    Span origin = {};

    bool operator==(const LocationAutomaton&) const = default;
};

/// Whether the input is the end of a timer.
inline bool is_timer(const LocationAutomaton::Input& input) { return input.timed.valid() || input.watched.valid(); }

/// Whether what the timer watches is true in `location`: its step is active, or its level was true in the last cycle.
bool level(const LocationAutomaton::Location& location, const LocationAutomaton::Input& timer);

/// `step 2`, `V_a`: what the timer watches.
std::string watched_text(const LocationAutomaton& automaton, const LocationAutomaton::Input& timer);

/// The evolutions, the instabilities that leave `location`.
std::span<const LocationAutomaton::Evolution> evolutions_from(const LocationAutomaton& automaton,
                                                              Id<LocationAutomaton::Location> location);
std::span<const LocationAutomaton::Instability> instabilities_of(const LocationAutomaton& automaton,
                                                                 Id<LocationAutomaton::Location> location);

/// `{2,5}`: the names of the active steps.
std::string situation_text(const LocationAutomaton& automaton,
                           const std::vector<Id<LocationAutomaton::Step>>& situation);

std::vector<std::string> verify(const LocationAutomaton& automaton);

}  // namespace grafverif
