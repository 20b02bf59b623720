// SPDX-License-Identifier: MIT
#include "report/settings_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "grafverif/ir/chart_run.hpp"
#include "syntax/print/constants.hpp"

namespace grafverif {

namespace {

/// Returns the first names of a list, and the number of further names: `a`, `b`, `c` and 46 more.
std::string some_of(const std::vector<std::string>& names) {
    constexpr std::size_t shown = 3;
    std::string words;
    for (std::size_t i = 0; i < std::min(shown, names.size()); ++i)
        words += fmt::format("{}`{}`", i == 0 ? "" : ", ", names[i]);
    return names.size() <= shown ? words : fmt::format("{} and {} more", words, names.size() - shown);
}

/// Returns text about the subsystems or fragments that were searched for a verdict, the omitted subsystems or
/// fragments, and the reason why the verdict does not depend on them.
std::string scope_text(const SearchScope& scope) {
    if (scope.searched.empty() && scope.left_out.empty()) return {};
    const bool one = scope.searched.size() == 1;
    const std::string what = scope.searched.empty() ? "no search"
                                                    : fmt::format("{}{} {}", scope.cells ? "cell" : "sub-loop",
                                                                  one ? "" : "s", some_of(scope.searched));
    if (scope.left_out.empty()) return what + ", each separately";
    const std::string rest =
        fmt::format("{}; omitted: {}", scope.searched.empty() ? what : what + " alone", some_of(scope.left_out));
    if (scope.because.empty()) return rest;
    return fmt::format("{}, {} {}", rest, scope.left_out.size() == 1 ? "which" : "each of which", scope.because);
}

void append(std::string& words, std::string_view more, std::string_view between) {
    if (!more.empty()) words.append(words.empty() ? "" : between).append(more);
}

/// Returns text about the instances that the input abstraction of a verdict reduced.
std::string abstraction_text(const PropertyResult& answer) {
    const Verdict& verdict = answer.verdict;
    if (!verdict.abstraction) return {};
    const auto& [chosen, untimed, paced] = *verdict.abstraction;
    std::string words;
    if (!chosen.empty()) words = "inputs chosen at each sampling: " + some_of(chosen);
    if (!untimed.empty()) append(words, "clocks ignored: " + some_of(untimed), "; ");
    if (!paced.empty()) append(words, "moves at any time, but at most once per instant: " + some_of(paced), "; ");
    if (answer.trace) append(words, "a shorter trace may exist", "; ");
    return words;
}

/// Returns text about the settings that are common to all verdicts of a report.
std::string common_text(const CheckSettings& settings) {
    const std::string constants = settings.constants.empty() ? "" : "; " + constants_text(settings.constants);
    if (settings.untimed.empty())
        return fmt::format("{} engine; {}, {} grain; time unit {}, {}{}", settings.engine, settings.mode,
                           settings.grain, seconds_text(settings.time_unit_ms),
                           settings.cycle.empty() ? "cycle time taken as zero" : settings.cycle, constants);
    const std::string grain = settings.grain.empty() ? "" : ", " + settings.grain + " grain";
    return fmt::format("{}, untimed: {}; {}{}{}{}", settings.engine, settings.untimed, settings.mode, grain,
                       settings.cycle.empty() ? "" : "; " + settings.cycle, constants);
}

/// The texts about a single verdict: number of states, subsystems, implication for the timed loop, and input
/// abstraction. Each of these texts may be empty.
using Parts = std::array<std::string, 4>;
Parts parts_of(const PropertyResult& answer) {
    const Verdict& verdict = answer.verdict;
    return {verdict.states.empty() ? "" : verdict.states + " states", scope_text(verdict.scope), answer.preservation,
            abstraction_text(answer)};
}

/// Returns, for each of the `Parts`, the text that is equal for all results; empty if the texts differ. For the number
/// of states, undecided properties without a started search are ignored.
std::array<std::optional<std::string>, 4> agreed(const std::vector<const PropertyResult*>& answers) {
    std::array<std::set<std::string>, 4> values;
    for (const PropertyResult* answer : answers) {
        const Parts parts = parts_of(*answer);
        for (std::size_t k = 0; k < parts.size(); ++k)
            if (k != 0 || !parts[0].empty() || answer->verdict.outcome != Outcome::Unknown) values[k].insert(parts[k]);
    }
    std::array<std::optional<std::string>, 4> same;
    for (std::size_t k = 0; k < same.size(); ++k)
        if (values[k].size() == 1) same[k] = *values[k].begin();
    return same;
}

}  // namespace

std::string settings_text(const Report& report, const PropertyResult& answer) {
    std::string words = common_text(report.settings);
    for (const std::string& part : parts_of(answer)) append(words, part, "; ");
    return words;
}

SharedSettings shared_settings(const Report& report, const std::vector<const PropertyResult*>& answers) {
    SharedSettings settings{common_text(report.settings), {}};
    std::map<std::string, std::size_t> known;  // for each text: index of the group with this text
    const auto same = agreed(answers);
    for (const auto& part : same) append(settings.shared, part.value_or(""), "; ");
    for (const PropertyResult* answer : answers) {
        const Parts parts = parts_of(*answer);
        std::string own;
        for (std::size_t k = 0; k < parts.size(); ++k)
            if (parts[k] != same[k]) append(own, parts[k], "; ");
        if (own.empty()) continue;
        const auto [place, fresh] = known.try_emplace(own, settings.groups.size());
        if (fresh) settings.groups.push_back({own, {}});
        settings.groups[place->second].answers.push_back(answer);
    }
    return settings;
}

std::string family_of(const PropertyResult& answer) {
    const std::size_t dot = answer.verdict.property.find('.');
    return dot == std::string::npos ? "" : answer.verdict.property.substr(0, dot);
}

FamilySizes family_sizes(const Report& report) {
    FamilySizes sizes;
    for (const PropertyResult& answer : report.answers) ++sizes[family_of(answer)];
    return sizes;
}

std::string names_of(const FamilySizes& all, const std::vector<const PropertyResult*>& answers) {
    FamilySizes here;
    for (const PropertyResult* answer : answers) ++here[family_of(*answer)];
    std::string names;
    std::set<std::string> named;
    for (const PropertyResult* answer : answers) {
        std::string name = answer->verdict.property;
        const std::string family = family_of(*answer);
        if (!family.empty() && here[family] > 1 && here[family] == all.at(family)) name = family;
        if (named.insert(name).second) append(names, name, ", ");
    }
    return names;
}

}  // namespace grafverif
