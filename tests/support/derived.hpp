// SPDX-License-Identifier: MIT
// The equations of the controllers of a model's only closed loop.
#pragma once

#include <optional>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Returns the equations of each controller, in order. Returns nothing if derive rejects a chart.
std::optional<std::vector<Equations>> derived(const Model& model, Diagnostics& diagnostics);
std::optional<std::vector<Equations>> derived(const Model& model);

}  // namespace grafverif
