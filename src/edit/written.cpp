// SPDX-License-Identifier: MIT
#include "edit/written.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/wording.hpp"
#include "syntax/language/parse.hpp"

namespace grafverif::edit {

namespace {

/// Parses a chart with a part that a user wrote. Returns the reason for rejection, or an empty string if `accepts` is
/// true for the only declaration of the chart.
template <class Item, class Accepts>
std::string fault_of(const std::string& written, std::string_view what, const std::string& before,
                     const Accepts& accepts) {
    Sources sources;
    const Id<Source> source = sources.add({"", before + written + ";" + (before.ends_with("{ ") ? " } }" : " }")});
    Diagnostics diagnostics;
    const tree::File file = parse_file(source, sources, diagnostics);
    if (file.broken || file.incomplete)
        return fmt::format("`{}` is not {}: {}", messages::clipped(written), what,
                           diagnostics.all().empty() ? "syntax error" : diagnostics.all().front().message);
    const auto* chart = file.declarations.size() == 1 ? std::get_if<tree::Chart>(&file.declarations[0]) : nullptr;
    const auto* item = chart != nullptr && chart->items.size() == 1 ? std::get_if<Item>(&chart->items[0]) : nullptr;
    if (item != nullptr && accepts(*item)) return {};
    return fmt::format("`{}` is not {}", messages::clipped(written), what);
}

}  // namespace

std::string trimmed(std::string_view text) {
    const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && (is_space(text.back()) || text.back() == ';')) text.remove_suffix(1);
    return std::string(text);
}

std::string fault_of_condition(const std::string& text) {
    return fault_of<tree::Transition>(
        text, "a condition", "grafcet g { transition t: a -> b when ",
        [](const tree::Transition& t) { return t.condition.valid() && t.assignments.empty(); });
}

std::string fault_of_action(const std::string& text) {
    return fault_of<tree::Step>(text, "one action", "grafcet g { step s { ",
                                [](const tree::Step& step) { return step.actions.size() == 1; });
}

std::string fault_of_assignment(const std::string& text) {
    return fault_of<tree::Transition>(text, "one assignment", "grafcet g { transition t: a -> b when c do ",
                                      [](const tree::Transition& t) { return t.assignments.size() == 1; });
}

std::string fault_of_declaration(const std::string& text) {
    return fault_of<tree::Variables>(text, "the declaration of one variable", "grafcet g {",
                                     [](const tree::Variables& all) { return all.variables.size() == 1; });
}

}  // namespace grafverif::edit
