// SPDX-License-Identifier: MIT
#include "grafverif/ir/drawing.hpp"

#include <cctype>
#include <cstddef>

#include "support/unique_names.hpp"

namespace grafverif {

namespace {

/// Replaces characters that are not allowed in an id by `_` and shortens long names.
std::string word_of(std::string_view name) {
    constexpr std::size_t longest = 80;
    std::string word;
    for (const char c : name.substr(0, longest))
        word += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' ? c : '_';
    return word;
}

}  // namespace

ElementIds element_ids(const Chart& chart, std::string_view prefix) {
    ElementIds ids;
    UniqueNames names;
    const std::string before = word_of(prefix);
    const auto fresh = [&](const std::string& suffix) { return names.fresh(before + suffix); };
    for (const Chart::PartialChart& partial : chart.partial_charts)
        ids.partial_charts.push_back(fresh(partial.name.empty() ? "chart" : "partial-" + word_of(partial.name)));
    for (const Chart::Step& step : chart.steps) {
        const std::string& partial = chart.partial_charts[step.chart].name;
        ids.steps.push_back(fresh("step-" + (partial.empty() ? "" : word_of(partial) + '-') + word_of(step.name)));
    }
    for (const Chart::Transition& transition : chart.transitions) {
        ids.transitions.push_back(fresh("transition-" + word_of(transition.name)));
        ids.conditions.push_back(fresh("condition-" + word_of(transition.name)));
    }
    const auto numbered = [&](const char* kind, std::size_t count, std::vector<std::string>& list) {
        for (std::size_t k = 0; k < count; ++k) list.push_back(fresh(kind + std::to_string(k)));
    };
    numbered("action-c", chart.continuous.size(), ids.continuous);
    numbered("action-s", chart.stored.size(), ids.stored);
    numbered("forcing-", chart.forcing.size(), ids.forcing);
    return ids;
}

}  // namespace grafverif
