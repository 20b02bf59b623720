// SPDX-License-Identifier: MIT
// Creates the variables of a plant: the shared variables of the loop and the internal variables of instances.
#pragma once

#include <optional>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

struct PlantVariables {
    Table<Network::Variable> variables = {};  ///< shared variables come first and keep their indices
    /// For each instance: internal variables, in the order of the component.
    std::vector<std::vector<Id<Network::Variable>>> own = {};
};

/// Returns the variables of the plant. The result is empty after an error: two writers, an empty range, or an initial
/// value that is undefined or outside its range.
std::optional<PlantVariables> plant_variables(const Model& model, const ClosedLoop& loop, Diagnostics& diagnostics);

}  // namespace grafverif
