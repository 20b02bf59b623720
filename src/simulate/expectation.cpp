// SPDX-License-Identifier: MIT
#include "simulate/expectation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "simulate/called.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif {

namespace {

using Relation = Expectation::Relation;

constexpr std::array<std::pair<std::string_view, Relation>, 7> relations = {{{"==", Relation::Equal},
                                                                             {"!=", Relation::NotEqual},
                                                                             {"<=", Relation::AtMost},
                                                                             {">=", Relation::AtLeast},
                                                                             {"=", Relation::Equal},
                                                                             {"<", Relation::Less},
                                                                             {">", Relation::Greater}}};

bool is_sign(char c) { return std::string_view("=!<>,").find(c) != std::string_view::npos; }

std::vector<std::string> tokens(std::string_view text) {
    std::vector<std::string> list;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] == ' ' || text[at] == '\t' || text[at] == '\r') {
            ++at;
            continue;
        }
        std::size_t end = at + 1;
        if (!is_sign(text[at])) end = std::min(text.find_first_of("=!<>, \t\r", at), text.size());
        else if (text[at] != ',' && end < text.size() && text[end] == '=') ++end;
        list.emplace_back(text.substr(at, end - at));
        at = end;
    }
    return list;
}

bool compare(std::int64_t now, Relation relation, std::int64_t value) {
    switch (relation) {
    case Relation::Equal: return now == value;
    case Relation::NotEqual: return now != value;
    case Relation::Less: return now < value;
    case Relation::AtMost: return now <= value;
    case Relation::Greater: return now > value;
    default: return now >= value;
    }
}

struct Now {
    std::int64_t value = 0;
    bool is_step = false, boolean = false;
};

/// Returns the current value of the variable, step variable or location with this name, or nullopt after an error, with
/// the reason in `problem`.
std::optional<Now> now_of(const ChartRun& run, std::size_t moment, std::string_view name, const LocationOf& location_of,
                          std::string& problem) {
    const ChartRun::State& state = run.moments[moment].after;
    const std::vector<Id<ChartRun::Signal>> signals = signals_called(run, name);
    const std::vector<Id<ChartRun::Step>> steps = step_variables_called(run, name);
    std::vector<std::string> meant;
    for (const Id<ChartRun::Signal> id : signals) meant.push_back(run.signals[id].name);
    for (const Id<ChartRun::Step> id : steps) meant.push_back(variable_of(run.steps[id]));
    if (meant.size() > 1) return problem = ambiguous_text(name, meant), std::nullopt;
    if (!signals.empty())
        return Now{state.values[signals.front().index], false, run.signals[signals.front()].type.boolean};
    if (!steps.empty()) return Now{std::ranges::binary_search(state.situation, steps.front()) ? 1 : 0, true, true};
    if (const LocationOfRun place = location_called(run, name); place.instance.valid())
        return Now{location_of(run.instances[place.instance].name) == place.location ? 1 : 0, false, true};
    return problem = unknown_name_text("variable or step", name, names_of(run)), std::nullopt;
}

std::string is_so(std::string_view name, const Now& now) {
    if (now.is_step) return fmt::format("`{}` is {}", name, now.value != 0 ? "active" : "not active");
    if (now.boolean) return fmt::format("`{}` is {}", name, now.value != 0 ? "true" : "false");
    return fmt::format("`{}` is {}", name, now.value);
}

}  // namespace

std::optional<std::int64_t> number_of(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{} || end != text.data() + text.size()) return {};
    return value;
}

std::optional<std::int64_t> value_of(std::string_view text) {
    if (text == "true" || text == "false") return text == "true" ? 1 : 0;
    return number_of(text);
}

std::variant<Expectation, std::string> parse_expectation(std::string_view text) {
    const std::vector<std::string> list = tokens(text);
    Expectation claim;
    const auto is = [&](std::size_t at, std::string_view word) { return at < list.size() && list[at] == word; };
    std::size_t at = 0;
    do {
        if (!claim.parts.empty()) ++at;  // skips the operator `and` or `,`
        const bool negated = is(at, "not") || is(at, "!");
        if (negated) ++at;
        if (at >= list.size() || is_sign(list[at][0]))
            return "the condition is missing; write for example `X3`, `not LAMP` or `LEVEL >= 3`";
        Expectation::Condition part{.name = list[at++], .value = 1};
        const auto found = at < list.size()
                               ? std::ranges::find(relations, list[at], &std::pair<std::string_view, Relation>::first)
                               : relations.end();
        if (found != relations.end()) {
            const auto value = at + 1 < list.size() ? value_of(list[at + 1]) : std::nullopt;
            if (negated)
                return fmt::format(
                    "`not` is not allowed before the comparison `{} {}`; remove `not` and use the opposite comparison",
                    part.name, list[at]);
            if (!value)
                return fmt::format("the comparison `{} {}` has no valid value; write a whole number, `true` or `false`",
                                   part.name, list[at]);
            part.relation = found->second;
            part.value = *value;
            at += 2;
        } else if (is(at, "in")) {
            if (at + 1 >= list.size()) return fmt::format("the location after `{} in` is missing; add it", part.name);
            part.relation = negated ? Relation::NotIn : Relation::In;
            part.location = list[at + 1];
            at += 2;
        } else if (negated) {
            part.value = 0;
        }
        claim.parts.push_back(std::move(part));
    } while (is(at, "and") || is(at, ","));
    if (at < list.size())
        return fmt::format("unexpected `{}` in a condition; write for example `X3 and LEVEL >= 3`", list[at]);
    for (const std::string& word : list) claim.text += (claim.text.empty() || word == "," ? "" : " ") + word;
    return claim;
}

std::optional<std::string> unmet_part(const Expectation& claim, const ChartRun& run, std::size_t moment,
                                      const LocationOf& location_of, std::string& problem) {
    std::string unmet;
    for (const Expectation::Condition& part : claim.parts) {
        if (part.relation == Relation::In || part.relation == Relation::NotIn) {
            const auto location = location_of(part.name);
            const auto instance = std::ranges::find(run.instances, part.name, &ChartRun::Instance::name);
            if (!location || instance == run.instances.end())
                return problem = unknown_name_text("instance", part.name, instances_of(run)), std::nullopt;
            if (std::ranges::find(instance->locations, part.location) == instance->locations.end())
                return problem = unknown_name_text(fmt::format("location of `{}`", part.name), part.location,
                                                   instance->locations),
                       std::nullopt;
            const bool holds = (*location == part.location) == (part.relation == Relation::In);
            if (!holds && unmet.empty()) unmet = fmt::format("`{}` is in `{}`", part.name, *location);
            continue;
        }
        const auto now = now_of(run, moment, part.name, location_of, problem);
        if (!now) return std::nullopt;
        if (unmet.empty() && !compare(now->value, part.relation, part.value)) unmet = is_so(part.name, *now);
    }
    return unmet;
}

bool names_only_steps(const Expectation& claim, const ChartRun& run) {
    return std::ranges::all_of(claim.parts, [&](const Expectation::Condition& part) {
        return step_variables_called(run, part.name).size() == 1;
    });
}

}  // namespace grafverif
