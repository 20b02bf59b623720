// SPDX-License-Identifier: MIT
#include "syntax/print/component.hpp"

#include <fmt/format.h>

#include <ostream>
#include <string_view>

#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

void join(std::string& list, const std::string& word, std::string_view between) {
    if (word.empty()) return;
    if (!list.empty()) list += between;
    list += word;
}

}  // namespace

std::string term_text(const Component& component, Id<Expr> term) {
    return expr_text(component.exprs, term, chart_spelling, [&](std::ostream& out, const Expr& leaf) {
        const auto index = static_cast<std::uint32_t>(leaf.value);
        if (leaf.op == Op::Parameter) out << component.parameters[{index}].name;
        else if (leaf.op == Op::Variable) out << component.variables[{index}].name;
        else out << duration_text(leaf.value);
    });
}

std::string clocks_text(const Component& component, const std::vector<Component::ClockConstraint>& constraints) {
    std::string words;
    for (const Component::ClockConstraint& each : constraints)
        join(words,
             fmt::format("{} {} {}", component.clocks[each.clock].name, chart_spelling(each.relation).token,
                         term_text(component, each.bound)),
             " && ");
    return words;
}

std::string guard_text(const Component& component, const Component::Edge& edge) {
    std::string words = is_true(component.exprs, edge.guard) ? "" : term_text(component, edge.guard);
    join(words, clocks_text(component, edge.constraint), " && ");
    return words;
}

std::string effect_text(const Component& component, const Component::Edge& edge) {
    std::string words;
    for (const Component::Assignment& each : edge.assignments)
        join(words, term_text(component, each.target) + " := " + term_text(component, each.value), ", ");
    for (const Id<Component::Clock> clock : edge.resets) join(words, component.clocks[clock].name + " := 0", ", ");
    return words;
}

}  // namespace grafverif
