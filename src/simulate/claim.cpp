// SPDX-License-Identifier: MIT
#include "simulate/claim.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "syntax/resolve/nearest_of.hpp"

namespace grafverif {

namespace {

using Relation = Claim::Relation;

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

/// `press.X3` is the step `press.3`.
std::optional<std::string> step_of(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    const std::size_t begin = dot == std::string_view::npos ? 0 : dot + 1;
    if (begin + 1 >= name.size() || name[begin] != 'X') return {};
    return std::string(name.substr(0, begin)) + std::string(name.substr(begin + 1));
}

struct Now {
    std::int64_t value = 0;
    bool is_step = false, boolean = false;
};

std::optional<Now> now_of(const ChartRun& run, std::string_view name) {
    const ChartRun::State& state = run.moments.back().after;
    const auto signal = std::ranges::find(run.signals, name, &ChartRun::Signal::name);
    if (signal != run.signals.end())
        return Now{state.values[static_cast<std::size_t>(signal - run.signals.begin())], false, signal->type.boolean};
    const auto wanted = step_of(name);
    if (!wanted) return {};
    for (const Id<ChartRun::Step> id : run.steps.ids())
        if (run.steps[id].full_name() == *wanted || run.steps[id].short_name == *wanted)
            return Now{std::ranges::binary_search(state.situation, id) ? 1 : 0, true, true};
    return {};
}

/// With the name that may be meant.
std::string unknown(const ChartRun& run, std::string_view name) {
    std::vector<std::string> names;
    for (const ChartRun::Signal& signal : run.signals) names.push_back(signal.name);
    for (const ChartRun::Step& step : run.steps) names.push_back("X" + step.short_name);
    const std::string meant = nearest_of(name, names);
    return fmt::format("there is no variable or step `{}`{}", name,
                       meant.empty() ? "" : fmt::format("; did you mean `{}`?", meant));
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

std::variant<Claim, std::string> claim_of(std::string_view text) {
    const std::vector<std::string> list = tokens(text);
    Claim claim;
    const auto is = [&](std::size_t at, std::string_view word) { return at < list.size() && list[at] == word; };
    std::size_t at = 0;
    do {
        if (!claim.parts.empty()) ++at;  // past `and` or `,`
        const bool negated = is(at, "not") || is(at, "!");
        if (negated) ++at;
        if (at >= list.size() || is_sign(list[at][0]))
            return "write what is to hold, such as `X3`, `not LAMP` or `LEVEL >= 3`";
        Claim::Part part{.name = list[at++], .value = 1};
        const auto found = at < list.size()
                               ? std::ranges::find(relations, list[at], &std::pair<std::string_view, Relation>::first)
                               : relations.end();
        if (found != relations.end()) {
            const auto value = at + 1 < list.size() ? value_of(list[at + 1]) : std::nullopt;
            if (!value || negated)
                return fmt::format("behind `{} {}` stands a whole number, `true` or `false`, and no `not` before it",
                                   part.name, list[at]);
            part.relation = found->second;
            part.value = *value;
            at += 2;
        } else if (is(at, "in")) {
            if (at + 1 >= list.size()) return fmt::format("`{} in` is followed by a location", part.name);
            part.relation = negated ? Relation::NotIn : Relation::In;
            part.location = list[at + 1];
            at += 2;
        } else if (negated) {
            part.value = 0;
        }
        claim.parts.push_back(std::move(part));
    } while (is(at, "and") || is(at, ","));
    if (at < list.size()) return fmt::format("`{}` does not belong to a claim such as `X3 and LEVEL >= 3`", list[at]);
    for (const std::string& word : list) claim.text += (claim.text.empty() || word == "," ? "" : " ") + word;
    return claim;
}

std::optional<std::string> unmet_part(const Claim& claim, const ChartRun& run, const LocationOf& location_of,
                                      std::string& problem) {
    std::string unmet;
    for (const Claim::Part& part : claim.parts) {
        if (part.relation == Relation::In || part.relation == Relation::NotIn) {
            const auto location = location_of(part.name);
            const auto instance = std::ranges::find(run.instances, part.name, &ChartRun::Instance::name);
            if (!location || instance == run.instances.end())
                return problem = fmt::format("there is no instance `{}`", part.name), std::nullopt;
            if (std::ranges::find(instance->locations, part.location) == instance->locations.end())
                return problem = fmt::format("`{}` has no location `{}`", part.name, part.location), std::nullopt;
            const bool holds = (*location == part.location) == (part.relation == Relation::In);
            if (!holds && unmet.empty()) unmet = fmt::format("`{}` is in `{}`", part.name, *location);
            continue;
        }
        const auto now = now_of(run, part.name);
        if (!now) return problem = unknown(run, part.name), std::nullopt;
        if (unmet.empty() && !compare(now->value, part.relation, part.value)) unmet = is_so(part.name, *now);
    }
    return unmet;
}

}  // namespace grafverif
