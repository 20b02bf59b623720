// SPDX-License-Identifier: MIT
// Equations: the semantics of one chart, as CEP13 equations (11) to (13) extended by stored actions, edges and timers.
//
// One cycle; all right-hand sides read the values before the cycle unless stated otherwise:
//   (a) firing conditions   CF_t = (and of X_s, s upstream of t) and its condition                     CEP13 (11)
//   (b) step activities     X_s' = (or of CF_t, t upstream of s) or (X_s and not (or of CF_u, u downstream)) CEP13 (12)
//   (s) stored actions      v' = the value of the triggered action, otherwise v
//   (e) previous values     P_e' = e, so that rise(e) is `e and not P_e` and fall(e) `P_e and not e`    IEC 60848,
//                           edges
//   (c) outputs             o  = or over the actions of X_s' and the assignation condition              CEP13 (13)
//                           observed terms: V_e' = e; timers: T = X_s' or V_e'
// Leaves of `exprs` are only Variable. The terms of (b) and (s) read firing conditions (of this cycle), step
// activities, internals, previous values and inputs, with their values before the cycle. The terms
// of (a) and (e) read the same variables as those of (b) and (s), except firing conditions. The
// terms of (c) read step activities and internals after the cycle, and the inputs and timer outputs
// sampled at its start. Hence rise(e) or fall(e) is true only in the first cycle after e changes.
//
// Time: a timer observes the value of its variable v after the previous cycle. If v is a term that reads an input, v
// may have changed since the previous cycle; then the term of the time condition contains v explicitly: `3s/a` is `a
// and T_a_3s_Q`, `a/2s` is `a or T_a_2s_Q`. A delayed action has the condition 3s/X_s; a time-limited action has the
// negation of this condition (IEC 60848, continuous actions).
//
// The first evolution activates the initial steps: no transition is cleared, the actions on activation of the initial
// steps are executed (Stored::first), no rising or falling edge occurs, and previous values and
// observed terms are initialized; no other value changes (JESA13: the evolution that leaves INIT).
//
// Invariants (see verify): ids are in their tables; each step, output and stored variable has one equation; conditions
// are Boolean; firing conditions do not read firing conditions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/step_name.hpp"
#include "grafverif/ir/type.hpp"
#include "grafverif/support/source.hpp"
#include "grafverif/support/table.hpp"

namespace grafverif {

struct Equations {
    enum class Role { Input, Output, Internal, Step, FiringCondition, TimerEnd, Previous, Watched };
    struct Variable {
        std::string name = {};  ///< name such as `START`, `X_2`, `CF_T0`, `T_X2_3s_Q`, `P_START`, `V_START`
        Role role = Role::Input;
        Type type = {};
        std::int64_t initial = 0;
        Span origin = {};
        bool operator==(const Variable&) const = default;
    };

    struct Firing {
        Id<Variable> variable = {};  ///< variable CF_t of the firing condition
        Id<Expr> condition = {};
        std::string transition = {};  ///< name of the transition in the chart
        Span origin = {};
        bool operator==(const Firing&) const = default;
    };

    struct StepActivity {
        Id<Variable> variable = {};  ///< variable X_s of the step activity
        Id<Expr> next = {};
        Id<Expr> activated = {};    ///< condition: X_s' and not X_s, where X_s' is expressed by firing conditions
        Id<Expr> deactivated = {};  ///< condition: X_s and not X_s'
        StepName step = {};
        Span origin = {};
        Id<Expr> first = {};  ///< value after the first evolution; the value at power-on if invalid
        bool operator==(const StepActivity&) const = default;
    };

    struct Output {
        Id<Variable> variable = {};
        Id<Expr> value = {};
        Span origin = {};
        bool operator==(const Output&) const = default;
    };

    /// One stored action. `value` is stored if `trigger` holds in the cycle.
    struct Write {
        Id<Expr> trigger = {};
        Id<Expr> value = {};
        /// True for an action on the activation of an initial step, which the first evolution also
        /// executes.
        bool initial = false;
        Span origin = {};
        bool operator==(const Write&) const = default;
    };
    struct Stored {
        Id<Variable> variable = {};  ///< internal variable, or output with stored actions

        /// Chain of conditional terms over `writes`; its last alternative is the variable itself. If only Boolean
        /// constants are stored, the term is `set or (v and not reset)`.
        Id<Expr> next = {};
        /// Condition under which two writes of different values are triggered; the constant false if this is
        /// impossible.
        Id<Expr> race = {};
        Id<Expr> first = {};  ///< value after the first evolution
        Id<Expr> first_race = {};
        std::vector<Write> writes = {};
        bool operator==(const Stored&) const = default;
    };

    /// A fault: two contradictory forcing orders are active after the cycle, or a program has a run-time fault.
    struct Conflict {
        Id<Expr> condition = {};  ///< term over firing conditions and values before the cycle
        Span origin = {};  ///< position of one of the two forcing orders, or of the statement with the run-time fault

        /// Condition of this fault in the first evolution; invalid if the fault cannot occur in the first evolution.
        Id<Expr> first = {};
        bool operator==(const Conflict&) const = default;
    };

    /// The value, in the previous cycle, of a term whose edges are read.
    struct Previous {
        Id<Variable> variable = {};  ///< variable P_e of the previous value

        /// Term e, which reads values before the cycle; in the first evolution, it reads initial values.
        Id<Expr> value = {};
        Span origin = {};
        bool operator==(const Previous&) const = default;
    };

    /// The level (value after the previous cycle) of a term that a timer observes.
    struct ObservedTerm {
        Id<Variable> variable = {};  ///< variable V_e of the level
        Id<Expr> value = {};         ///< term e, which reads values after the cycle
        Span origin = {};
        bool operator==(const ObservedTerm&) const = default;
    };

    /// A timer; each distinct time condition `t1/v/t2` has one timer (IEC 60848; CEP13 Fig. 33b). If v is true from
    /// time r to time f, and f - r is at least rise_ms, `end` is true from r + rise_ms to f + fall_ms.
    struct Timer {
        std::string name = {};      ///< name such as `T_X2_3s`
        Id<Variable> watched = {};  ///< X_s of a step s, or V_e of a term e; the level after the previous cycle
        Id<Variable> end = {};      ///< variable of the timer output, such as `T_X2_3s_Q`
        std::int64_t rise_ms = 0;   ///< time t1; 0 if the condition has no t1
        std::int64_t fall_ms = 0;   ///< time t2; 0 if the condition has no t2
        Span origin = {};
        bool operator==(const Timer&) const = default;
    };

    /// An assumption on the inputs of the chart (`constraint`), for models with free inputs.
    struct Assumption {
        Id<Expr> condition = {};  ///< condition on the inputs
        Span origin = {};
        bool operator==(const Assumption&) const = default;
    };

    std::string name = {};
    Exprs exprs = {};
    Table<Variable> variables = {};
    std::vector<Firing> firings = {};
    std::vector<StepActivity> steps = {};
    std::vector<Stored> stored = {};
    std::vector<Conflict> conflicts = {};
    std::vector<Previous> previous = {};
    std::vector<ObservedTerm> watches = {};
    std::vector<Timer> timers = {};
    /// For each time condition of the chart: its timer; invalid if the condition is not read.
    std::vector<Id<Timer>> conditions = {};
    std::vector<Output> outputs = {};
    std::vector<Assumption> assumptions = {};
    /// True if one more cycle with the same inputs would change nothing except previous values: no firing condition
    /// holds, no event executes an action, and no firing condition would hold in a cycle in which no signal has an
    /// edge. `stable` reads firing conditions and values before the cycle. For a program: true if the scan changes
    /// nothing.
    Id<Expr> stable = {};
    /// True for a PLC program: each cycle, including the first evolution, is one scan, and terms
    /// share many subterms.
    bool is_program = false;
    Span origin = {};

    bool operator==(const Equations&) const = default;
};

std::vector<std::string> verify(const Equations& equations);

/// A value passed to the next cycle. Next values for which `after` is false are computed before any value changes. Next
/// values for which `after` is true are computed after all other next values have been assigned.
struct Kept {
    Id<Equations::Variable> variable = {};
    Id<Expr> next = {};
    Id<Expr> first = {};  ///< value after the first evolution; the value at power-on if invalid

    /// True if `next` and `first` read values after the cycle, false if `next` and `first` read values before the
    /// cycle.
    bool after = false;
};
/// Returns stored variables (`next`), previous values, step activities and observed levels, in this order.
std::vector<Kept> kept(const Equations& equations);
/// Returns only the previous values and observed levels: the state without the situation and the stored variables.
std::vector<Kept> remembered(const Equations& equations);

/// A condition that ends the run if it holds in a cycle. If `variable` is valid, the condition states that two
/// different values are written to it. If `variable` is invalid, the condition is that of a Conflict. Undefined and
/// out-of-range values are not included; they are detected when the stored terms are evaluated.
struct Fault {
    Id<Equations::Variable> variable = {};
    Id<Expr> condition = {};
    Id<Expr> first = {};  ///< condition of this fault in the first evolution
};
/// Returns all races and conflicts that may occur.
std::vector<Fault> faults(const Equations& equations);

/// True if the first evolution executes stored actions, gives a step activity a value other than its value at power-on,
/// or can have a fault.
bool acts_at_first(const Equations& equations);

}  // namespace grafverif
