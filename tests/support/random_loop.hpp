// SPDX-License-Identifier: MIT
// Random well-formed closed loops: one or two random charts, the second of which may read outputs of the first, and a
// plant of small components that drives every input: switches, wandering levels, actuators that follow an output after
// a while. With properties over everything that a property can name. For laws on plant, compose, engines and emitters.
#pragma once

#include "grafverif/ir/closed_loop.hpp"
#include "support/random_chart.hpp"

namespace grafverif {

/// A model of one loop.
Model random_loop(Random& random);

/// The same, with `questions` more properties, of every pattern and over internal variables too, a constraint on its
/// inputs now and then, and an observer that properties read.
Model random_loop_asked(Random& random, int questions);

/// The loop of one controller that nobody drives: the test plays its plant.
Model lone_controller(const Chart& chart, ExecutionMode mode = ExecutionMode::StabilitySearch);

}  // namespace grafverif
