// SPDX-License-Identifier: MIT
// ControllerWords: maps the variables of a model to the chart of one of its controllers. Reports use ControllerWords to
// express a run of a Network or of a TransitionSystem in terms of the chart. The replay uses ControllerWords to compare
// the run with the chart. All names are names of the chart; lists are in the order of the tables of the chart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/step_name.hpp"
#include "grafverif/support/id.hpp"

namespace grafverif {

/// `Variable` is the type of the model's state variables.
template <class Variable>
struct ControllerWords {
    struct Step {
        StepName name = {};
        Id<Variable> variable = {};
        bool operator==(const Step&) const = default;
    };
    struct Named {
        std::string name = {};
        Id<Variable> variable = {};
        bool operator==(const Named&) const = default;
    };
    struct Timer {
        Id<Variable> end = {};
        /// Index in `steps` of the step that the timer observes; empty if the timer observes another term.
        std::optional<std::size_t> step = {};
        std::int64_t rise_ms = 0, fall_ms = 0;  ///< times t1 and t2 of the time condition `t1/v/t2`

        /// Name of the step variable or other variable that the timer observes, such as `X2` or `a`; empty if the timer
        /// observes a term that is not a variable.
        std::string watched = {};
        bool operator==(const Timer&) const = default;
    };

    std::string name = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::optional<TaskCycle> cycle = {};  ///< task cycle; if empty, the cycle time is zero
    std::vector<Step> steps = {};
    std::vector<Named> transitions = {};  ///< the transitions; `variable` is the variable of the firing condition
    std::vector<Named> inputs = {};
    /// For each input: the variable that holds its value during a scan of several evolutions; empty if each evolution
    /// samples the inputs.
    std::vector<Id<Variable>> held = {};
    std::vector<Named> outputs = {};  ///< outputs as written to the plant
    std::vector<Named> internals = {};
    std::vector<Timer> timers = {};
    std::vector<std::optional<std::size_t>> conditions =
        {};  ///< index of the timer of each time condition; empty if the condition is not read
    bool operator==(const ControllerWords&) const = default;
};

}  // namespace grafverif
