// SPDX-License-Identifier: MIT
#include "edit/elements.hpp"

#include <algorithm>

#include "support/overloaded.hpp"

namespace grafverif::edit {

Span where(const tree::Action& action) {
    return std::visit(
        [](const auto& each) {
            return Span{each.where.source, each.where.begin, each.where.end - 1};
        },
        action);
}

Elements::Elements(const tree::File& file) {
    for (const tree::Declaration& declaration : file.declarations)
        if (const auto* chart = std::get_if<tree::Chart>(&declaration)) add(*chart, chart->items, false);
    std::ranges::stable_sort(elements_, {}, [](const Element& element) { return element.where.begin; });
    for (std::size_t k = 0; k < elements_.size(); ++k)
        if (elements_[k].is_step()) names_.emplace_back(elements_[k].step->name.where.begin, k);
    std::ranges::sort(names_);
}

void Elements::add(const tree::Chart& chart, const std::vector<tree::ChartItem>& items, bool repeated) {
    for (const tree::ChartItem& item : items)
        std::visit(overloaded{
                       [&](const tree::Step& step) {
                           const Element element{step.where, &chart,  &items,  &step,
                                                 nullptr,    nullptr, nullptr, repeated};
                           elements_.push_back(element);
                           for (const tree::Action& action : step.actions) {
                               elements_.push_back(element);
                               elements_.back().where = where(action);
                               elements_.back().action = &action;
                           }
                       },
                       [&](const tree::Transition& transition) {
                           const Element element{transition.where, &chart,  &items,  nullptr,
                                                 &transition,      nullptr, nullptr, repeated};
                           elements_.push_back(element);
                           for (const tree::Assignment& assignment : transition.assignments) {
                               elements_.push_back(element);
                               elements_.back().where = assignment.where;
                               elements_.back().assignment = &assignment;
                           }
                       },
                       [&](const tree::Partial& partial) { add(chart, partial.items, repeated); },
                       [&](const tree::ReplicatedChartItems& replicated) { add(chart, replicated.items, true); },
                       [](const auto&) {},
                   },
                   item);
}

const Element* Elements::at(std::uint32_t offset) const {
    const auto begin = [](const Element& element) { return element.where.begin; };
    const auto found = std::ranges::lower_bound(elements_, offset, {}, begin);
    if (found != elements_.end() && found->where.begin == offset) return &*found;
    const auto named = std::ranges::lower_bound(names_, std::pair(offset, std::size_t{0}));
    return named != names_.end() && named->first == offset ? &elements_[named->second] : nullptr;
}

}  // namespace grafverif::edit
