// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "edit/planner.hpp"
#include "edit/written.hpp"
#include "lsp/scan.hpp"

namespace grafverif::edit {

namespace {

template <class Item>
Span place_of(const Item& item) {
    return std::visit([](const auto& each) { return each.where; }, item);
}

std::string not_a_name(const std::string& name) {
    return lsp::is_name(name, false) ? std::string() : fmt::format("`{}` is not a valid name", name);
}

}  // namespace

void Planner::declare(const std::string& declaration) {
    const Declared declared = declared_variable(declaration);
    if (obstacle_ = declared.fault; !obstacle_.empty()) return;
    if (declared.kind == tree::VariableKind::Input) drive(declared);
    const tree::Variables *last = nullptr, *same = nullptr;
    for (const tree::ChartItem& item : element_.chart->items)
        if (const auto* variables = std::get_if<tree::Variables>(&item)) {
            last = variables;
            if (variables->kind == declared.kind) same = variables;
        }
    if (last != nullptr) return add(layout_.added_after((same != nullptr ? same : last)->where, declaration + ';'));
    const Span chart = element_.chart->where;
    const std::string_view text = layout_.text(chart);
    for (const lsp::Word& sign : lsp::words_of(text))
        if (text.substr(sign.begin, sign.end - sign.begin) == "{") {
            const Span head{chart.source, chart.begin, chart.begin + sign.end};
            return add(layout_.added_lines_after(head, {"    " + declaration + ';'}));
        }
}

/// Adds an environment that can set a new input to any value to each closed loop with the chart, because each input of
/// a closed loop must be driven. Rejects an input with an index, and an input of an instance of the chart.
void Planner::drive(const Declared& input) {
    std::string name;
    for (const tree::Declaration& declaration : file_.declarations) {
        const auto* loop = std::get_if<tree::ClosedLoop>(&declaration);
        if (loop == nullptr) continue;
        bool is_controlled = false;
        std::optional<Span> place;
        for (const tree::LoopItem& item : loop->items) {
            const auto* controller = std::get_if<tree::Controller>(&item);
            if (controller != nullptr && controller->chart.word == element_.chart->name.word) {
                is_controlled = true;
                if (controller->instance.valid()) {
                    obstacle_ = fmt::format(
                        "the instance `{}` of the chart requires an argument for the input; declare the input and "
                        "pass the argument in the text of the file",
                        file_.text(controller->instance));
                    return;
                }
            }
            if (controller != nullptr || std::holds_alternative<tree::Instance>(item)) place = place_of(item);
        }
        if (!is_controlled) continue;
        if (input.has_index) {
            obstacle_ = fmt::format(
                "`{}` has an index, and closed loop `{}` uses the chart as a controller; declare the input and its "
                "environment in the text",
                input.name, file_.text(loop->name));
            return;
        }
        if (name.empty()) name = fresh_or(input.name + "_any");
        add(layout_.added_after(
            *place, fmt::format("environment {} = {}(OUT = {}{});", name, input.range.empty() ? "free" : "free_integer",
                                input.name, input.range)));
    }
}

void Planner::add_partial(const std::string& name) {
    if (obstacle_ = not_a_name(name); !obstacle_.empty()) return;
    add_part("partial " + name, {"initial step " + fresh_step("0") + ';'});
    select_last("initial step");
}

void Planner::add_macro() {
    const std::string expansion = fresh_name("E");
    add_neighbour(End::To, "macro step ", " expands " + expansion);
    if (!obstacle_.empty()) return;
    const std::string entry = fresh_or("E"), exit = fresh_or("S"), link = fresh_transition();
    add_part("expansion " + expansion,
             {"entry step " + entry + ';', "exit step " + exit + ';',
              fmt::format("transition{} {} -> {} when true;", link.empty() ? "" : ' ' + link + ':', entry, exit)});
}

void Planner::add_enclosing(const std::string& partial) {
    if (obstacle_ = not_a_name(partial); !obstacle_.empty()) return;
    add_neighbour(End::To, "enclosing step ", " encloses " + partial);
    const bool is_known = std::ranges::any_of(element_.chart->items, [&](const tree::ChartItem& item) {
        const auto* known = std::get_if<tree::Partial>(&item);
        return known != nullptr && file_.text(known->name) == partial;
    });
    if (obstacle_.empty() && !is_known) add_part("partial " + partial, {"linked step " + fresh_step("0") + ';'});
}

void Planner::add_part(const std::string& head, const std::vector<std::string>& lines) {
    std::vector<std::string> all = {"", head + " {"};
    for (const std::string& line : lines) all.push_back("    " + line);
    all.emplace_back("}");
    add(layout_.added_lines_after(place_of(element_.chart->items.back()), all));
}

std::string Planner::fresh_name(const std::string& stem) {
    for (int number = 1;; ++number)
        if (std::string name = stem + std::to_string(number); !is_used(name)) return *used().insert(name).first;
}

std::string Planner::fresh_or(const std::string& name) {
    if (is_used(name)) return fresh_name(name);
    return *used().insert(name).first;
}

}  // namespace grafverif::edit
