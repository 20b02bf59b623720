// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>

#include "grafverif/ir/component.hpp"

namespace grafverif {

/// Returns the displayed name of a variable of an instance in properties and traces: `Gate.X`. If the component has a
/// location X, `Gate.X` denotes the location, and the name of the variable is `Gate_X`.
inline std::string display_name(const std::string& instance, const Component& component, const std::string& variable) {
    const bool is_location =
        std::ranges::find(component.locations, variable, &Component::Location::name) != component.locations.end();
    return instance + (is_location ? "_" : ".") + variable;
}

}  // namespace grafverif
