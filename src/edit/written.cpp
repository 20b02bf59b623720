// SPDX-License-Identifier: MIT
#include "edit/written.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/wording.hpp"
#include "syntax/language/format.hpp"
#include "syntax/language/parse.hpp"

namespace grafverif::edit {

namespace {

/// Parses a chart that contains only the text `written`, which a user has entered. Returns an empty string if `accepts`
/// is true for the only declaration of this chart, otherwise the reason why the text is rejected.
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
    if (item != nullptr && accepts(*item, file)) return {};
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
        [](const tree::Transition& t, const tree::File&) { return t.condition.valid() && t.assignments.empty(); });
}

std::string fault_of_action(const std::string& text) {
    return fault_of<tree::Step>(text, "one action", "grafcet g { step s { ",
                                [](const tree::Step& step, const tree::File&) { return step.actions.size() == 1; });
}

std::string fault_of_assignment(const std::string& text) {
    return fault_of<tree::Transition>(
        text, "one assignment", "grafcet g { transition t: a -> b when c do ",
        [](const tree::Transition& t, const tree::File&) { return t.assignments.size() == 1; });
}

Declared declared_variable(const std::string& text) {
    Declared found;
    const auto take = [&](const tree::Variables& all, const tree::File& file) {
        if (all.variables.size() != 1) return false;
        const tree::Variable& variable = all.variables.front();
        found.kind = all.kind;
        found.name = file.text(variable.name);
        found.has_index = variable.name.index.valid();
        if (variable.range)
            found.range = fmt::format(", LOW = {}, HIGH = {}", formatted(file, variable.range->low),
                                      formatted(file, variable.range->high));
        return true;
    };
    found.fault = fault_of<tree::Variables>(text, "the declaration of one variable", "grafcet g {", take);
    return found;
}

}  // namespace grafverif::edit
