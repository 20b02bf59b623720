// SPDX-License-Identifier: MIT
#include "syntax/print/sentence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ostream>
#include <span>
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
    case Pattern::Watched: break;  // the overload for observers prints this property
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

namespace {

/// Returns `text` as the left operand of `and`: brackets are added if the text contains a space.
std::string bracketed(const std::string& text) { return text.find(' ') == std::string::npos ? text : '(' + text + ')'; }

/// Returns the text of the scope of a property (such as `after p`). `of` contains the operands of the scope.
std::string scope_text(Sentence::Scope scope, std::span<const std::string> of) {
    switch (scope) {
    case Sentence::Scope::Globally: return "";
    case Sentence::Scope::Before: return " before " + of[0];
    case Sentence::Scope::After: return " after " + of[0];
    case Sentence::Scope::Between: return " between " + bracketed(of[0]) + " and " + of[1];
    case Sentence::Scope::AfterUntil: return " after " + of[0] + " until " + of[1];
    }
    unreachable();
}

}  // namespace

std::string claim(const Sentence& watch, const std::vector<std::string>& of, const std::string& bound) {
    const auto within = [&](std::size_t own) { return scope_text(watch.scope, std::span(of).subspan(own)); };
    switch (watch.kind) {
    case Sentence::Kind::Absence: return "never " + of[0] + within(1);
    case Sentence::Kind::Universality: return "always " + of[0] + within(1);
    case Sentence::Kind::Existence: return "inevitable " + of[0] + within(1);
    case Sentence::Kind::Response:
        return of[0] + " leads to " + of[1] + (bound.empty() ? "" : " within " + bound) + within(2);
    case Sentence::Kind::Precedence: return of[0] + " precedes " + of[1] + within(2);
    case Sentence::Kind::HoldsFor: return of[0] + " holds for " + bound;
    case Sentence::Kind::HoldsAtMost: return of[0] + " holds at most " + bound + within(1);
    case Sentence::Kind::Since: return of[0] + " at most " + bound + " since " + of[1];
    case Sentence::Kind::Recurrence: return of[0] + " at least every " + bound + within(1);
    case Sentence::Kind::Occurrences:
        return of[0] + " at most " + bound + (bound == "1" ? " time" : " times") + within(1);
    }
    unreachable();
}

std::string bound_text(const Sentence& watch) {
    if (watch.count > 0) return std::to_string(watch.count);
    return watch.duration_ms > 0 ? duration_text(watch.duration_ms) : "";
}

std::string sentence(const ClosedLoop& loop, const ClosedLoop::Constraint& constraint) {
    constexpr std::size_t longest = 400;
    const std::string text =
        expr_text(loop.exprs, constraint.condition, chart_spelling, [&loop](std::ostream& out, const Expr& leaf) {
            const ClosedLoop::Symbol& symbol = loop.symbols[{static_cast<std::uint32_t>(leaf.value)}];
            // Constraints read only inputs, and every input has a name.
            out << loop.shared[std::get<ClosedLoop::SharedSymbol>(symbol).shared].name;
        });
    return text.size() > longest ? "a constraint of more than 400 characters holds for this plant"
                                 : text + " holds for this plant";
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
