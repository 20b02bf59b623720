// SPDX-License-Identifier: MIT
// Equations: the meaning of one chart, as CEP13 equations (11) to (13) extended by stored actions, edges and timers.
//
// One cycle, all right-hand sides reading the values before the cycle unless said otherwise:
//   (a) firing conditions   CF_t = (and of X_s, s upstream of t) and its condition                     CEP13 (11)
//   (b) step activities     X_s' = (or of CF_t, t upstream of s) or (X_s and not (or of CF_u, u downstream)) CEP13 (12)
//   (s) stored actions      v' = the value of the action that is triggered, else v
//   (e) previous values     P_e' = e, so that rise(e) is `e and not P_e` and fall(e) `P_e and not e`    IEC 60848, 4.5
//   (c) outputs             o  = or over the actions of X_s' and the assignation condition              CEP13 (13)
//                           watched terms: V_e' = e; timers: T = X_s' or V_e'
// Leaves of `exprs` are Variable only. The terms of (b) and (s) read firing conditions (of this cycle), step activities,
// internals, previous values and inputs before the cycle; those of (a) and (e) all of these but firing conditions. The
// terms of (c) read step activities and internals after the cycle, and the inputs and timer ends sampled at its start.
// An edge is thus true in the first cycle after the change only.
//
// Time: a timer knows the level of its watched variable as the last cycle left it. Where an input may have changed since,
// a term says so itself: `3s/a` is `a and T_a_3s_Q`, `a/2s` is `a or T_a_2s_Q`. A delayed action is one on the condition
// 3s/X_s, a time-limited one on its negation (IEC 60848, 4.8.2).
//
// The first evolution activates the initial steps: no transition is cleared in it, the actions on activation of the
// initial steps run (Stored::first), there is no edge, previous values and watched terms take their values; nothing else
// changes (JESA13: the evolution that leaves INIT).
//
// Invariants (see verify): ids in their tables; each step, output, stored variable has one equation; conditions are
// Boolean; firing conditions read no firing condition.
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
        std::string name = {};  ///< `START`, `X_2`, `CF_T0`, `T_X2_3s_Q`, `P_START`, `V_START`
        Role role = Role::Input;
        Type type = {};
        std::int64_t initial = 0;
        Span origin = {};
        bool operator==(const Variable&) const = default;
    };

    struct Firing {
        Id<Variable> variable = {};  ///< CF_t
        Id<Expr> condition = {};
        std::string transition = {};  ///< as the chart names it
        Span origin = {};
        bool operator==(const Firing&) const = default;
    };

    struct StepActivity {
        Id<Variable> variable = {};  ///< X_s
        Id<Expr> next = {};
        Id<Expr> activated = {};    ///< X_s' and not X_s, over firing conditions and X_s
        Id<Expr> deactivated = {};  ///< X_s and not X_s'
        StepName step = {};
        Span origin = {};
        bool operator==(const StepActivity&) const = default;
    };

    struct Output {
        Id<Variable> variable = {};
        Id<Expr> value = {};
        Span origin = {};
        bool operator==(const Output&) const = default;
    };

    /// One stored action: `value` is stored when `trigger` holds in the cycle.
    struct Write {
        Id<Expr> trigger = {};
        Id<Expr> value = {};
        bool initial = false;  ///< on activation of an initial step: runs in the first evolution too
        Span origin = {};
        bool operator==(const Write&) const = default;
    };
    struct Stored {
        Id<Variable> variable = {};  ///< an internal, or an output with stored actions
        Id<Expr> next = {};   ///< Conditional chain over `writes`, else the variable itself; where Boolean constants
                              ///< alone are stored: `set or (v and not reset)`
        Id<Expr> race = {};   ///< two writes of different values are triggered together; the constant false: never
        Id<Expr> first = {};  ///< the value after the first evolution
        Id<Expr> first_race = {};
        std::vector<Write> writes = {};
        bool operator==(const Stored&) const = default;
    };

    /// Two forcing orders that cannot be obeyed together are active after the cycle: a fault like a race.
    struct Conflict {
        Id<Expr> condition = {};  ///< over firing conditions and values before the cycle
        Span origin = {};         ///< one of the orders
        bool operator==(const Conflict&) const = default;
    };

    /// The value of a term whose edges are read, as it was in the last cycle.
    struct Previous {
        Id<Variable> variable = {};  ///< P_e
        Id<Expr> value = {};         ///< e, over values before the cycle; in the first evolution over initial values
        Span origin = {};
        bool operator==(const Previous&) const = default;
    };

    /// The level of a term that a timer watches.
    struct Watch {
        Id<Variable> variable = {};  ///< V_e
        Id<Expr> value = {};         ///< e, over values after the cycle
        Span origin = {};
        bool operator==(const Watch&) const = default;
    };

    /// One per distinct time condition `t1/v/t2` (IEC 60848, 4.4; CEP13 Fig. 33b). A time for which v is true, from r to
    /// f, makes `end` true from r + rise_ms on if v lasts that long, until f + fall_ms.
    struct Timer {
        std::string name = {};      ///< `T_X2_3s`
        Id<Variable> watched = {};  ///< X_2, or the V_e of a watch: the level of v after the last cycle
        Id<Variable> end = {};      ///< T_X2_3s_Q
        std::int64_t rise_ms = 0;   ///< t1; 0: none
        std::int64_t fall_ms = 0;   ///< t2; 0: none
        Span origin = {};
        bool operator==(const Timer&) const = default;
    };

    /// An assumption on the inputs of the chart (`constraint`), for those who leave the inputs free.
    struct Assumption {
        Id<Expr> condition = {};  ///< over inputs alone
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
    std::vector<Watch> watches = {};
    std::vector<Timer> timers = {};
    std::vector<Id<Timer>> conditions =
        {};  ///< per time condition of the chart: its timer; not valid: none waits for it
    std::vector<Output> outputs = {};
    std::vector<Assumption> assumptions = {};
    /// One more cycle with the same inputs would change nothing: no firing condition holds, no stored variable changed,
    /// no previous value differs from the present one. Over firing conditions and, where needed, values before the cycle.
    Id<Expr> stable = {};
    Span origin = {};

    bool operator==(const Equations&) const = default;
};

std::vector<std::string> verify(const Equations& equations);

/// What a cycle leaves for the next one. All next values are taken before any is changed, but of those `after`.
struct Kept {
    Id<Equations::Variable> variable = {};
    Id<Expr> next = {};
    Id<Expr> first = {};  ///< after the first evolution; not valid: as at power-on
    bool after = false;   ///< both are over the values after the cycle; else over those before it
};
/// Stored variables (`next` as a whole), previous values, step activities, watched levels, in this order.
std::vector<Kept> kept(const Equations& equations);
/// The previous values and watched levels among them: what is remembered besides the situation and stored variables.
std::vector<Kept> remembered(const Equations& equations);

/// What ends a run where it holds in a cycle: two writes of different values to `variable`, or (`variable` not valid) two
/// orders that cannot be obeyed together. Values outside of their range, and those that do not exist, are faults too, but
/// of the terms that are stored.
struct Fault {
    Id<Equations::Variable> variable = {};
    Id<Expr> condition = {};
    Id<Expr> first = {};  ///< the same of the first evolution
};
/// Those that can happen at all, and every conflict of orders.
std::vector<Fault> faults(const Equations& equations);

/// Whether stored actions run, or race, in the first evolution.
bool acts_at_first(const Equations& equations);

}  // namespace grafverif
