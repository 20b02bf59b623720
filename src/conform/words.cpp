// SPDX-License-Identifier: MIT
#include "conform/words.hpp"

namespace grafverif::conform {

std::string inputs_text(const std::vector<std::pair<std::string, Type>>& inputs, const std::vector<std::int64_t>& values) {
    std::string text;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        const auto& [name, type] = inputs[k];
        if (!text.empty()) text += ", ";
        if (!type.boolean) text += name + " = " + std::to_string(values[k]);
        else text += values[k] != 0 ? name : "not " + name;
    }
    return text;
}

}  // namespace grafverif::conform
