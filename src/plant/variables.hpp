// SPDX-License-Identifier: MIT
// The variables of a plant: those that the loop shares, and the internal ones of instances.
#pragma once

#include <optional>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

struct PlantVariables {
    Table<Network::Variable> variables = {};                   ///< shared variables first, at their index
    std::vector<std::vector<Id<Network::Variable>>> own = {};  ///< per instance: internal variables in the order of the
                                                               ///< component
};

/// Empty after an error: two writers, an empty range, an initial value that is undefined or outside its range.
std::optional<PlantVariables> plant_variables(const Model& model, const ClosedLoop& loop, Diagnostics& diagnostics);

}  // namespace grafverif
