// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

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
    if (obstacle_ = fault_of_declaration(declaration); !obstacle_.empty()) return;
    const std::vector<lsp::Word> words = lsp::words_of(declaration);
    const auto word = [&](std::string_view text, const lsp::Word& at) {
        return text.substr(at.begin, at.end - at.begin);
    };
    const std::string_view kind = word(declaration, words[0]);
    if (kind == "input") drive(std::string(word(declaration, words[1])));
    const tree::Variables *last = nullptr, *same = nullptr;
    for (const tree::ChartItem& item : element_.chart->items)
        if (const auto* variables = std::get_if<tree::Variables>(&item)) {
            last = variables;
            const std::string_view text = layout_.text(variables->where);
            if (word(text, lsp::words_of(text)[0]) == kind) same = variables;
        }
    if (last != nullptr) return add(layout_.added_after((same != nullptr ? same : last)->where, declaration + ';'));
    const Span chart = element_.chart->where;
    for (const lsp::Word& sign : lsp::words_of(layout_.text(chart)))
        if (word(layout_.text(chart), sign) == "{") {
            const Span head{chart.source, chart.begin, chart.begin + sign.end};
            return add(layout_.added_lines_after(head, {"    " + declaration + ';'}));
        }
}

/// Adds an environment that sets a new input to any value to each closed loop that controls the chart: each input of a
/// closed loop must be driven.
void Planner::drive(const std::string& input) {
    for (const tree::Declaration& declaration : file_.declarations) {
        const auto* loop = std::get_if<tree::ClosedLoop>(&declaration);
        if (loop == nullptr) continue;
        bool is_controlled = false;
        std::optional<Span> place;
        for (const tree::LoopItem& item : loop->items) {
            const auto* controller = std::get_if<tree::Controller>(&item);
            is_controlled |= controller != nullptr && !controller->instance.valid() &&
                             controller->chart.word == element_.chart->name.word;
            if (controller != nullptr || std::holds_alternative<tree::Instance>(item)) place = place_of(item);
        }
        if (is_controlled)
            add(layout_.added_after(*place, fmt::format("environment {0}_any = free(OUT = {0});", input)));
    }
}

void Planner::add_partial(const std::string& name) {
    if (obstacle_ = not_a_name(name); !obstacle_.empty()) return;
    add_part("partial " + name, {"initial step " + fresh_step("0") + ';'});
    selected_in_ = edits_.size() - 1;
    selected_at_ = edits_.back().replacement.find("initial step");
}

void Planner::add_macro() {
    const std::string expansion = fresh_name("E");
    add_step_with("macro step ", " expands " + expansion);
    if (!obstacle_.empty()) return;
    const std::string link = fresh_transition();
    add_part("expansion " + expansion,
             {"entry step E;", "exit step S;",
              fmt::format("transition{} E -> S when true;", link.empty() ? "" : ' ' + link + ':')});
}

void Planner::add_enclosing(const std::string& partial) {
    if (obstacle_ = not_a_name(partial); !obstacle_.empty()) return;
    add_step_with("enclosing step ", " encloses " + partial);
    const bool is_known = std::ranges::any_of(element_.chart->items, [&](const tree::ChartItem& item) {
        const auto* known = std::get_if<tree::Partial>(&item);
        return known != nullptr && file_.text(known->name) == partial;
    });
    if (obstacle_.empty() && !is_known) add_part("partial " + partial, {"linked step " + fresh_step("0") + ';'});
}

void Planner::add_step_with(const std::string& words, const std::string& contents) {
    new_words_ = words;
    new_contents_ = contents;
    add_neighbour(End::To);
}

void Planner::add_part(const std::string& head, const std::vector<std::string>& lines) {
    std::vector<std::string> all = {"", head + " {"};
    for (const std::string& line : lines) all.push_back("    " + line);
    all.emplace_back("}");
    add(layout_.added_lines_after(place_of(element_.chart->items.back()), all));
}

std::string Planner::fresh_name(const std::string& stem) {
    std::set<std::string_view> words;
    for (const tree::Word& word : file_.words) words.insert(word.text);
    for (int number = 1;; ++number)
        if (std::string name = stem + std::to_string(number); !words.contains(name)) return names_.emplace_back(name);
}

}  // namespace grafverif::edit
