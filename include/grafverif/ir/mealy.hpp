// SPDX-License-Identifier: MIT
// MealyMachine: a location automaton as a machine with outputs for every input combination (JESA13 section 6).
//
//   state       a location; in a chart with timers, also the elapsed time of each running timer
//   transition  for a set of inputs, or by waiting, to the next state, with the outputs written then
//
// INIT is merged with the location of the initial situation, if this location exists: with stability search both have
// the same responses. Without stability search, `activation` represents a cycle that only activates the initial steps,
// before the first transition of the machine.
//
// Conditions are sets of inputs, never enumerated; those of one state are disjoint and, with `unstable`, cover
// `assumed`. The inputs are those of the chart, without timers: a `wait` transition lets time pass until the next timer
// event, with constant inputs.
//
// Invariants (see verify): ids are in their tables; `transitions` and `unstable` are sorted by `from`; outputs are
// complete; no condition is the constant false; waits are positive; state names differ.
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
#include "grafverif/support/table.hpp"

namespace grafverif {

struct MealyMachine {
    struct Variable {
        std::string name = {};
        Type type = {};
        bool operator==(const Variable&) const = default;
    };
    struct State {
        std::string situation = {};  ///< `{2,5}`; merged states list all situations: `{1} or {3}`
        std::string detail = {};     ///< stored values and running timers: `LOCK=1, T_X2_3s 1s`; may be empty
        bool operator==(const State&) const = default;
    };
    struct OutputWord {
        std::vector<std::int64_t> values = {};  ///< value of each output
        bool operator==(const OutputWord&) const = default;
    };
    struct Transition {
        Id<State> from = {}, to = {};
        Id<Expr> condition = {};  ///< condition on the inputs
        Id<OutputWord> answer = {};
        std::int64_t wait_ms = 0;  ///< time for which the inputs are kept; 0 while they are applied
        bool operator==(const Transition&) const = default;
    };
    /// Inputs for which the machine enters total instability and never responds again.
    struct Unstable {
        Id<State> from = {};
        Id<Expr> condition = {};
        bool operator==(const Unstable&) const = default;
    };
    /// Outputs of the cycle that activates the initial steps, depending on its inputs.
    struct Activation {
        Id<Expr> condition = {};
        Id<OutputWord> answer = {};
        bool operator==(const Activation&) const = default;
    };

    std::string name = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    Exprs exprs = {};
    std::vector<Variable> inputs = {}, outputs = {};
    Table<State> states = {};
    Table<OutputWord> answers = {};
    Id<State> initial = {};
    std::vector<Transition> transitions = {};
    std::vector<Unstable> unstable = {};
    std::vector<Activation> activation = {};  ///< empty if the first cycle is an ordinary one
    Id<Expr> assumed = {};
    std::optional<std::uint64_t> combinations = 1;    ///< of inputs, as assumed; empty beyond 64 bits
    std::optional<std::uint64_t> unstable_pairs = 0;  ///< state-input pairs without a stable situation

    bool operator==(const MealyMachine&) const = default;
};

/// Returns the transitions that leave `state`.
std::span<const MealyMachine::Transition> transitions_from(const MealyMachine& machine, Id<MealyMachine::State> state);

std::vector<std::string> verify(const MealyMachine& machine);

}  // namespace grafverif
