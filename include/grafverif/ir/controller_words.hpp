// SPDX-License-Identifier: MIT
// ControllerWords: maps the variables of a model to the chart of one of its controllers. Used by reports to express a
// run of a Network or of a TransitionSystem in terms of the chart, and by the replay to compare it with the chart.
// Names are those of the chart; lists are in its order.
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

/// `Variable`: type of the model's state variables.
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
        std::optional<std::size_t> step = {};   ///< the observed step, index in `steps`; empty for another term
        std::int64_t rise_ms = 0, fall_ms = 0;  ///< t1 and t2
        std::string watched = {};               ///< the observed term as in conditions: `X2`, `a`; otherwise empty
        bool operator==(const Timer&) const = default;
    };

    std::string name = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::vector<Step> steps = {};
    std::vector<Named> transitions = {};  ///< with their firing conditions
    std::vector<Named> inputs = {};
    std::vector<Named> outputs = {};  ///< as written to the plant
    std::vector<Named> internals = {};
    std::vector<Timer> timers = {};
    std::vector<std::optional<std::size_t>> conditions =
        {};  ///< per time condition: its timer; empty if it is not read
    bool operator==(const ControllerWords&) const = default;
};

}  // namespace grafverif
