// SPDX-License-Identifier: MIT
#include "support/derived.hpp"

#include "derive/derive.hpp"

namespace grafverif {

std::optional<std::vector<Equations>> derived(const Model& model, Diagnostics& diagnostics) {
    std::vector<Equations> equations;
    for (const ClosedLoop::Controller& controller : model.loops[{0}].controllers) {
        auto one = derive(model.charts[controller.chart], diagnostics);
        if (!one) return {};
        equations.push_back(std::move(*one));
    }
    return equations;
}

std::optional<std::vector<Equations>> derived(const Model& model) {
    Diagnostics ignored;
    return derived(model, ignored);
}

}  // namespace grafverif
