// SPDX-License-Identifier: MIT
#include "ir/step_names.hpp"

#include <algorithm>

namespace grafverif {

std::string step_variable_name(std::string_view label) {
    const std::size_t dot = label.rfind('.');
    const std::size_t own = dot == std::string_view::npos ? 0 : dot + 1;
    return std::string(label.substr(0, own)) + "X" + std::string(label.substr(own));
}

std::string step_variable_name(const Network& network, Id<Network::Variable> variable) {
    for (const Network::Controller& controller : network.controllers) {
        const auto step =
            std::ranges::find(controller.words.steps, variable, &ControllerWords<Network::Variable>::Named::variable);
        if (step == controller.words.steps.end()) continue;
        return (network.controllers.size() == 1 ? "" : controller.words.name + ".") + step_variable_name(step->name);
    }
    return network.variables[variable].name;  // of no controller: a network that nobody composed
}

}  // namespace grafverif
