// SPDX-License-Identifier: MIT
#include "edit/planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "syntax/language/format.hpp"

namespace grafverif::edit {

namespace {

bool is_number(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

Span Planner::declared(const tree::Action& action) {
    const Span place = where(action);
    return {place.source, place.begin, place.end + 1};
}

void Planner::add_step(const std::string& fresh, const std::vector<tree::Name>& neighbours, const std::string& words,
                       const std::string& contents) {
    const tree::Step* near = neighbours.empty() ? nullptr : connections_.step(neighbours.front());
    if (near == nullptr) near = last_step();
    const Span place = near != nullptr ? near->where : element_.where;
    select(layout_.added_after(place, words + fresh + contents + ';'), words);
}

const tree::Step* Planner::last_step() const {
    const tree::Step* last = nullptr;
    for (const tree::ChartItem& item : *element_.items)
        if (const auto* step = std::get_if<tree::Step>(&item)) last = step;
    return last;
}

Span Planner::place_of_link(const Transitions& near, const Transitions& next) const {
    for (const Transitions* const list : {&near, &next, &connections_.transitions()})
        if (!list->empty()) return list->back()->where;
    return last_step() != nullptr ? last_step()->where : element_.where;
}

void Planner::add_link(Span place, const std::string& from, const std::string& to, const std::string& condition) {
    const std::string name = fresh_transition();
    add(layout_.added_after(place, fmt::format("transition{} {}->{}{} when {};", name.empty() ? "" : ' ' + name + ':',
                                               from.empty() ? "" : from + ' ', to.empty() ? "" : " ", to, condition)));
}

std::string Planner::exclusive(const Transitions& links) const {
    std::string all;
    for (const tree::Transition* const link : links) {
        if (!link->condition.valid()) continue;
        const std::string term = negation(link->condition);
        if (term == "false") return term;
        if (term != "true") all += (all.empty() ? "" : " && ") + term;
    }
    return all.empty() ? "true" : all;
}

std::string Planner::negation(Id<tree::Expr> condition) const {
    const tree::Expr& expr = file_.exprs[condition];
    const auto is_simple = [&](Id<tree::Expr> term) {
        const tree::Op op = file_.exprs[term].op;
        return op == tree::Op::Name || op == tree::Op::Member || op == tree::Op::Rise || op == tree::Op::Fall;
    };
    if (expr.op == tree::Op::True) return "false";
    if (expr.op == tree::Op::False) return "true";
    if (expr.op == tree::Op::Not && is_simple(expr.first)) return formatted(file_, expr.first);
    const std::string term = formatted(file_, condition);
    return is_simple(condition) ? '!' + term : "!(" + term + ')';
}

std::string Planner::fresh_step(const std::vector<tree::Name>& neighbours) {
    return fresh_step(std::string(neighbours.empty() ? "0" : file_.text(neighbours.front())));
}

std::string Planner::fresh_step(std::string stem) {
    std::uint64_t next = 2;
    if (is_number(stem)) {
        next = 0;
        stem.clear();
        for (const Element& each : elements_.all()) {
            if (each.items != element_.items || !each.is_step()) continue;
            const std::string_view name = file_.text(each.step->name);
            std::uint64_t number = 0;
            if (is_number(name) && name.size() < 10) std::from_chars(name.data(), name.data() + name.size(), number);
            if (is_number(name)) next = std::max(next, number + 1);
        }
    } else {
        const std::size_t digits = stem.find_last_not_of("0123456789") + 1;
        if (digits < stem.size() && stem.size() - digits < 10) {
            std::from_chars(stem.data() + digits, stem.data() + stem.size(), next);
            ++next;
            stem.resize(digits);
        }
    }
    std::string name = stem + std::to_string(next);
    while (is_used(name)) name = stem + std::to_string(++next);
    return *used().insert(name).first;
}

std::set<std::string, std::less<>>& Planner::used() {
    if (used_.empty())
        for (const tree::Word& word : file_.words) used_.insert(word.text);
    return used_;
}

std::string Planner::fresh_transition() {
    std::uint64_t next = 1;
    for (const Element& each : elements_.all()) {
        if (each.chart != element_.chart || !each.is_transition()) continue;
        if (!each.transition->name.valid()) return {};
        ++next;
    }
    std::string name = fmt::format("t{}", next);
    while (used().contains(name)) name = fmt::format("t{}", ++next);
    return *used().insert(name).first;
}

void Planner::add(std::vector<TextEdit> edits) {
    for (TextEdit& edit : edits) edits_.push_back(std::move(edit));
}

void Planner::select(TextEdit edit, std::string_view words) {
    add(std::move(edit));
    select_last(words);
}

void Planner::select_last(std::string_view words) {
    selected_in_ = edits_.size() - 1;
    selected_at_ = edits_.back().replacement.find(words);
}

Plan Planner::finished() {
    if (!obstacle_.empty()) return {{}, obstacle_};
    Plan plan;
    std::vector<std::size_t> order(edits_.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return std::pair(edits_[k].begin, edits_[k].end); });
    std::uint32_t grown = 0;
    for (const std::size_t k : order) {
        TextEdit& edit = edits_[k];
        if (selected_in_ == k) plan.selected = edit.begin + grown + static_cast<std::uint32_t>(selected_at_);
        if (!plan.edits.empty() && edit.begin < plan.edits.back().end) {  // two deletions overlap
            plan.edits.back().end = std::max(plan.edits.back().end, edit.end);
            continue;
        }
        grown += static_cast<std::uint32_t>(edit.replacement.size()) - (edit.end - edit.begin);
        plan.edits.push_back(std::move(edit));
    }
    if (selected_) {
        plan.selected = *selected_;
        for (const TextEdit& edit : plan.edits)
            if (edit.end <= *selected_)
                *plan.selected += static_cast<std::uint32_t>(edit.replacement.size()) - (edit.end - edit.begin);
    }
    return plan;
}

}  // namespace grafverif::edit
