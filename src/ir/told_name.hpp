// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>

#include "grafverif/ir/component.hpp"

namespace grafverif {

/// What an instance's own variable is called in properties and traces: `Gate.X`; where the component has a location of that
/// name, which `Gate.X` is then, `Gate_X`.
inline std::string told_name(const std::string& instance, const Component& component, const std::string& variable) {
    const bool is_location =
        std::ranges::find(component.locations, variable, &Component::Location::name) != component.locations.end();
    return instance + (is_location ? "_" : ".") + variable;
}

}  // namespace grafverif
