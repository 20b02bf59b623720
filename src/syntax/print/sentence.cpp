// SPDX-License-Identifier: MIT
#include "syntax/print/sentence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ostream>
#include <variant>

#include "support/overloaded.hpp"
#include "support/unique_names.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

std::string claim(Pattern pattern, const std::vector<std::string>& operands, const std::string& raw) {
    switch (pattern) {
    case Pattern::Always: return "always " + operands[0];
    case Pattern::Never: return "never " + operands[0];
    case Pattern::Reachable: return "reachable " + operands[0];
    case Pattern::Inevitable: return "inevitable " + operands[0];
    case Pattern::LeadsTo: return operands[0] + " leads to " + operands[1];
    case Pattern::NoDeadlock: return "no deadlock";
    case Pattern::NoTimelock: return "no timelock";
    case Pattern::ReachableAllSteps: return "reachable all steps";
    case Pattern::AlwaysPossible: return "always possible " + operands[0];
    case Pattern::RawUppaal: return "uppaal \"" + raw + '"';
    case Pattern::RawCtl: return "ctl \"" + raw + '"';
    case Pattern::RawLtl: return "ltl \"" + raw + '"';
    case Pattern::ExactlyOneOf: return fmt::format("exactly one of {{{}}}", fmt::join(operands, ", "));
    }
    unreachable();
}

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
