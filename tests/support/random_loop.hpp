// SPDX-License-Identifier: MIT
// Generates random well-formed closed loops for randomized tests of plant, compose, engines and emitters. A loop has
// one or two random charts; the second chart may read outputs of the first. Every input is driven by a plant of small
// components: switches, varying levels, and actuators that follow an output after a delay. The properties use all
// elements that a property can name.
#pragma once

#include "grafverif/ir/closed_loop.hpp"
#include "support/random_chart.hpp"

namespace grafverif {

/// Returns a model with one loop.
Model random_loop(Random& random);

/// Returns a model with one loop and `questions` additional properties with every pattern, also over internal
/// variables. Some loops have a constraint on inputs and an observer that properties read.
Model random_loop_asked(Random& random, int questions);

/// Gives some controllers of the loop, at least one, a task cycle of a few seconds, which may be a range.
void add_task_cycles(Model& model, Random& random);

/// Returns a loop of one controller without a plant; the test drives its inputs.
Model lone_controller(const Chart& chart, ExecutionMode mode = ExecutionMode::StabilitySearch);

}  // namespace grafverif
