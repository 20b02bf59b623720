// SPDX-License-Identifier: MIT
#include "ir/step_names.hpp"

#include <algorithm>

namespace grafverif {

std::string step_variable_name(const Network& network, Id<Network::Variable> variable) {
    for (const Network::Controller& controller : network.controllers) {
        const auto step =
            std::ranges::find(controller.words.steps, variable, &ControllerWords<Network::Variable>::Step::variable);
        if (step == controller.words.steps.end()) continue;
        return (network.controllers.size() == 1 ? "" : controller.words.name + ".") + step->name.variable();
    }
    return network.variables[variable].name;  // reached only if `compose` did not build the network
}

}  // namespace grafverif
