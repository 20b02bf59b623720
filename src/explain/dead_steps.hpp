// SPDX-License-Identifier: MIT
// Explains why a step is never active: the transitions that lead to it, and the part of their conditions that is never
// true. Candidate statements are terms of the model; an engine decides which of them are true in no reachable state.
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

/// Where a model stores the values that conditions of a chart read: indices of Variable leaves.
struct ConditionLeaves {
    std::vector<std::uint32_t> steps = {};
    std::map<std::string, std::uint32_t> variables = {};  ///< inputs and internals by name
    std::vector<std::optional<std::uint32_t>> ends = {};  ///< per time condition, if it has a timer
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

/// If `never` is true in no reachable state, `transition` is never cleared, for the reason in `words`.
struct DeadTransition {
    Id<Chart::Transition> transition = {};
    Id<Expr> never = {};
    std::string words = {};
};

/// Candidates for the transitions that lead directly to `step`, or to its macro-step if it is an entry, for each the
/// most specific first. `exprs`, of the model, gains terms. Parts of conditions that read edges or outputs are omitted.
std::vector<DeadTransition> dead_transitions(const Chart& chart, const ConditionLeaves& leaves, Id<Chart::Step> step,
                                             Exprs& exprs);

}  // namespace grafverif
