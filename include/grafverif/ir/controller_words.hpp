// SPDX-License-Identifier: MIT
// ControllerWords: what the variables of a model are to the chart of one of its controllers. What a report needs to
// tell a run of a Network or of a TransitionSystem in the words of the chart, and a replay to compare it with the
// chart. Names are those of the chart; lists are in its order.
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

/// `Variable`: what a state of the model gives a value.
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
        std::optional<std::size_t> step = {};   ///< whose time it is, index in `steps`; empty: of another term
        std::int64_t rise_ms = 0, fall_ms = 0;  ///< t1 and t2
        std::string watched = {};               ///< that term as conditions write it: `X2`, `a`; empty for a longer one
        bool operator==(const Timer&) const = default;
    };

    std::string name = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::vector<Step> steps = {};
    std::vector<Named> transitions = {};  ///< its firing condition
    std::vector<Named> inputs = {};
    std::vector<Named> outputs = {};  ///< as written to the plant
    std::vector<Named> internals = {};
    std::vector<Timer> timers = {};
    std::vector<std::optional<std::size_t>> conditions =
        {};  ///< per time condition: its timer; empty: none waits for it
    bool operator==(const ControllerWords&) const = default;
};

}  // namespace grafverif
