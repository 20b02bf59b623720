// SPDX-License-Identifier: MIT
#include "syntax/print/sentence.hpp"

#include <ostream>
#include <variant>

#include "support/unique_names.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

std::string sentence(const ClosedLoop& loop, const ClosedLoop::Constraint& constraint) {
    constexpr std::size_t longest = 400;
    const std::string text =
        expr_text(loop.exprs, constraint.condition, chart_spelling, [&loop](std::ostream& out, const Expr& leaf) {
            const ClosedLoop::Symbol& symbol = loop.symbols[{static_cast<std::uint32_t>(leaf.value)}];
            out << loop.shared[std::get<ClosedLoop::SharedSymbol>(symbol).shared].name;  // it reads inputs only
        });
    return text.size() > longest ? "a long constraint holds of this plant" : text + " holds of this plant";
}

std::vector<Property> constraints_to_prove(const ClosedLoop& loop) {
    UniqueNames names;
    for (const Property& property : loop.properties) names.fresh(property.name);
    std::vector<Property> properties;
    for (const ClosedLoop::Constraint& constraint : loop.constraints)
        properties.push_back({.name = names.fresh(constraint.name),
                              .text = sentence(loop, constraint),
                              .pattern = Pattern::Always,
                              .operands = {constraint.condition},
                              .origin = constraint.origin});
    return properties;
}

}  // namespace grafverif
