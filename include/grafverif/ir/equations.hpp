// SPDX-License-Identifier: MIT
// Equations: the meaning of one chart, as CEP13 equations (11) to (13) extended by stored actions and timers.
//
// One cycle, all right-hand sides reading the values before the cycle unless said otherwise:
//   (a) firing conditions   CF_t = (and of X_s, s upstream of t) and its condition                     CEP13 (11)
//   (b) step activities     X_s' = (or of CF_t, t upstream of s) or (X_s and not (or of CF_u, u downstream)) CEP13 (12)
//   (s) stored actions      v' = the value of the action that is triggered, else v
//   (c) outputs             o  = or over the actions of X_s' and the assignation condition              CEP13 (13)
//                           timers: T = X_s'
// Leaves of `exprs` are Variable only. The terms of (b) and (s) read firing conditions (of this cycle), step activities,
// internals and inputs before the cycle. The terms of (c) read step activities and internals after the cycle, and the
// inputs sampled at its start.
//
// The first evolution activates the initial steps: no transition is cleared in it, the actions on activation of the
// initial steps run (Stored::first), nothing else changes (JESA13: the evolution that leaves INIT).
//
// Invariants (see verify): ids in their tables; each step, output, stored variable has one equation; conditions are
// Boolean; firing conditions read no firing condition.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/type.hpp"
#include "grafverif/support/source.hpp"
#include "grafverif/support/table.hpp"

namespace grafverif {

struct Equations {
    enum class Role { Input, Output, Internal, Step, FiringCondition, TimerEnd };
    struct Variable {
        std::string name = {};         ///< `START`, `X_2`, `CF_T0`, `T_X2_3s_Q`
        Role role = Role::Input;
        Type type = {};
        std::int64_t initial = 0;
        Span origin = {};
        bool operator==(const Variable&) const = default;
    };

    struct Firing {
        Id<Variable> variable = {};    ///< CF_t
        Id<Expr> condition = {};
        std::string transition = {};   ///< as the chart names it
        Span origin = {};
        bool operator==(const Firing&) const = default;
    };

    struct StepActivity {
        Id<Variable> variable = {};    ///< X_s
        Id<Expr> next = {};
        Id<Expr> activated = {};       ///< X_s' and not X_s, over firing conditions and X_s
        Id<Expr> deactivated = {};     ///< X_s and not X_s'
        std::string step = {};         ///< as the chart names it, qualified: `2`, `G2.2`
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
        bool initial = false;          ///< on activation of an initial step: runs in the first evolution too
        Span origin = {};
        bool operator==(const Write&) const = default;
    };
    struct Stored {
        Id<Variable> variable = {};    ///< an internal, or an output with stored actions
        Id<Expr> next = {};            ///< Conditional chain over `writes`, else the variable itself; where Boolean constants
                                       ///< alone are stored: `set or (v and not reset)`
        Id<Expr> race = {};            ///< two writes of different values are triggered together; the constant false: never
        Id<Expr> first = {};           ///< the value after the first evolution
        Id<Expr> first_race = {};
        std::vector<Write> writes = {};
        bool operator==(const Stored&) const = default;
    };

    /// One per distinct time condition (CEP13 Fig. 33b): `end` is true from `duration_ms` after the activation of
    /// the step until its deactivation.
    struct Timer {
        std::string name = {};         ///< `T_X2_3s`
        Id<Variable> step = {};        ///< X_2
        Id<Variable> end = {};         ///< T_X2_3s_Q
        std::int64_t duration_ms = 0;
        Span origin = {};
        bool operator==(const Timer&) const = default;
    };

    /// An assumption on the inputs of the chart (`constraint`), for those who leave the inputs free.
    struct Assumption {
        Id<Expr> condition = {};       ///< over inputs alone
        Span origin = {};
        bool operator==(const Assumption&) const = default;
    };

    std::string name = {};
    Exprs exprs = {};
    Table<Variable> variables = {};
    std::vector<Firing> firings = {};
    std::vector<StepActivity> steps = {};
    std::vector<Stored> stored = {};
    std::vector<Timer> timers = {};
    std::vector<Output> outputs = {};
    std::vector<Assumption> assumptions = {};
    /// One more cycle with the same inputs would change nothing: no firing condition holds, no stored variable changed.
    /// Over firing conditions and, where needed, values before the cycle.
    Id<Expr> stable = {};
    Span origin = {};

    bool operator==(const Equations&) const = default;
};

std::vector<std::string> verify(const Equations& equations);

}  // namespace grafverif
