// SPDX-License-Identifier: MIT
// Random well-formed closed loops for randomized tests of plant, compose, engines and emitters: one or two random
// charts, the second of which may read outputs of the first. A plant of small components drives every input: switches,
// wandering levels, actuators that follow an output after a delay. The properties use all elements that a property can
// name.
#pragma once

#include "grafverif/ir/closed_loop.hpp"
#include "support/random_chart.hpp"

namespace grafverif {

/// A model of one loop.
Model random_loop(Random& random);

/// A loop with `questions` further properties, of every pattern and over internal variables too; some loops have a
/// constraint on inputs and an observer that properties read.
Model random_loop_asked(Random& random, int questions);

/// The loop of one controller without a plant: the test drives its inputs.
Model lone_controller(const Chart& chart, ExecutionMode mode = ExecutionMode::StabilitySearch);

}  // namespace grafverif
