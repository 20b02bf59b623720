// SPDX-License-Identifier: MIT
// Explains why a step is never active. The explanation consists of the transitions that lead to the step, and of the
// conjuncts of their conditions that are never true. Candidate statements are terms of the model; an engine decides
// which of them are true in no reachable state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/controller_words.hpp"

namespace grafverif {

/// The variables of a model that store the values that conditions read: active steps, variables and timer outputs. Each
/// variable is identified by its index, which is the value of a leaf Op::Variable.
struct ConditionLeaves {
    std::vector<std::uint32_t> steps = {};
    std::map<std::string, std::uint32_t> variables = {};  ///< inputs and internal variables by name

    /// For each time condition: the output of its timer, if it has a timer.
    std::vector<std::optional<std::uint32_t>> ends = {};
};

template <class Variable>
ConditionLeaves condition_leaves(const ControllerWords<Variable>& words) {
    ConditionLeaves leaves;
    for (const auto& step : words.steps) leaves.steps.push_back(step.variable.index);
    for (const auto* list : {&words.inputs, &words.internals})
        for (const auto& named : *list) leaves.variables.emplace(named.name, named.variable.index);
    for (const std::optional<std::size_t>& timer : words.conditions)
        leaves.ends.push_back(timer ? std::optional(words.timers[*timer].end.index) : std::nullopt);
    return leaves;
}

/// A candidate statement: if the term `never` is true in no reachable state, `transition` is never cleared. `words`
/// describes the reason.
struct DeadTransition {
    Id<Chart::Transition> transition = {};
    Id<Expr> never = {};
    std::string words = {};
};

/// Returns candidates for the transitions that lead directly to `step` or, if it is an entry step, to its macro-step.
/// The candidates for each transition begin with the most specific one. The function adds terms to `exprs`, which
/// belongs to the model. Conjuncts that read edges or outputs are omitted.
std::vector<DeadTransition> dead_transitions(const Chart& chart, const ConditionLeaves& leaves, Id<Chart::Step> step,
                                             Exprs& exprs);

}  // namespace grafverif
