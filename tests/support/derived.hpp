// SPDX-License-Identifier: MIT
// The equations of the controllers of a model's only closed loop.
#pragma once

#include <optional>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Returns the equations in the order of the controllers. They are empty for a chart without equations.
std::optional<std::vector<Equations>> derived(const Model& model, Diagnostics& diagnostics);
std::optional<std::vector<Equations>> derived(const Model& model);

}  // namespace grafverif
