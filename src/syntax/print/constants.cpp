// SPDX-License-Identifier: MIT
#include "syntax/print/constants.hpp"

#include "support/overloaded.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

std::string value_text(const NamedConstant& constant) {
    switch (constant.kind) {
    case NamedConstant::Kind::Boolean: return constant.value != 0 ? "true" : "false";
    case NamedConstant::Kind::Integer: return std::to_string(constant.value);
    case NamedConstant::Kind::Duration: return duration_text(constant.value);
    }
    unreachable();
}

std::string constants_text(const std::vector<NamedConstant>& constants) {
    std::string text;
    for (const NamedConstant& each : constants)
        text += (text.empty() ? "" : ", ") + each.name + " = " + value_text(each) + (each.set ? " (set)" : "");
    return text;
}

}  // namespace grafverif
