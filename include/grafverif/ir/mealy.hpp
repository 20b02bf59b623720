// SPDX-License-Identifier: MIT
// MealyMachine: a location automaton as a machine with outputs for every input combination (JESA13 section 6).
//
//   state       a location; in a chart with timers, also the elapsed time of each running timer
//   transition  leads to the next state for a set of inputs, or after a wait; `answer` contains the outputs that are
//               written after the inputs are applied or the wait has ended
//
// With stability search, INIT is merged with the location of the initial situation if both respond to all inputs with
// the same outputs and next states. Without stability search, the first cycle only activates the
// initial steps. If the first cycle leads to the same state for all inputs, `activation` represents
// the cycle, and the first transition of the machine represents the second cycle.
//
// A condition represents a set of input combinations without enumerating them. The inputs are the inputs of the chart,
// without timers. A `wait` transition lets time pass until the next timer event, with constant inputs. For each state,
// the conditions of its entries in `unstable` and of its transitions without a wait are disjoint, and together they
// cover `assumed`.
//
// Invariants (see verify): ids are in their tables; `transitions` and `unstable` are sorted by `from`; each OutputWord
// has one value per output; no condition is the constant false; no `wait_ms` is negative; state names differ.
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
        std::string situation = {};  ///< active steps, such as `{2,5}`; for merged states, such as `{1} or {3}`
        std::string detail = {};     ///< stored values and running timers, such as `LOCK=1, T_X2_3s 1s`; may be empty
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
        std::int64_t wait_ms = 0;  ///< time for which the inputs stay constant; 0 for a transition that applies inputs
        bool operator==(const Transition&) const = default;
    };
    /// Inputs for which the machine enters total instability and never responds again.
    struct Unstable {
        Id<State> from = {};
        Id<Expr> condition = {};
        bool operator==(const Unstable&) const = default;
    };
    /// Outputs of the cycle that activates the initial steps, for the inputs that satisfy `condition`.
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
    std::vector<Activation> activation = {};  ///< empty if transitions of the machine represent the first cycle
    Id<Expr> assumed = {};
    /// Number of input combinations that satisfy `assumed`; empty if it exceeds 64 bits.
    std::optional<std::uint64_t> combinations = 1;
    /// Number of pairs of a state and an input combination for which the machine enters total instability; empty if it
    /// exceeds 64 bits.
    std::optional<std::uint64_t> unstable_pairs = 0;

    bool operator==(const MealyMachine&) const = default;
};

/// Returns the transitions that leave `state`.
std::span<const MealyMachine::Transition> transitions_from(const MealyMachine& machine, Id<MealyMachine::State> state);

std::vector<std::string> verify(const MealyMachine& machine);

}  // namespace grafverif
