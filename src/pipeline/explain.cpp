// SPDX-License-Identifier: MIT
#include "pipeline/explain.hpp"

#include <algorithm>
#include <utility>

#include "explain/settling.hpp"

namespace grafverif {

namespace {

/// Whether those violated at power-on hold `at stable` is looked up in one more search.
void explain_power_on(const Network& network, const std::vector<Violation>& violations, const Search& search,
                      Report& report) {
    Network settled = network;
    std::vector<std::string> names;
    std::vector<std::size_t> trapped;
    for (const Violation& each : violations) {
        const Id<Property> about = report.answers[each.answer].verdict.about;
        if (!about.valid() || !is_violated_at_power_on(network, network.properties[about], each.run)) continue;
        settled.properties[about].at_stable = true;
        names.push_back(network.properties[about].name);
        trapped.push_back(each.answer);
    }
    if (names.empty()) return;
    const std::vector<Verdict> found = search ? search(settled, names) : std::vector<Verdict>{};
    for (const std::size_t answer : trapped) {
        Verdict& verdict = report.answers[answer].verdict;
        const auto at_stable = std::ranges::find(found, verdict.property, &Verdict::property);
        verdict.notes.push_back(power_on_words(at_stable == found.end() ? Verdict{} : *at_stable));
    }
}

}  // namespace

void explain(const Network& network, const std::vector<Violation>& violations, const Search& search, Report& report) {
    explain_power_on(network, violations, search, report);
    for (const Violation& each : violations) {
        Answer& answer = report.answers[each.answer];
        if (answer.verdict.pattern != Pattern::NoTimelock || !answer.trace) continue;
        if (std::string words = unsettled_words(*answer.trace); !words.empty())
            answer.verdict.notes.push_back(std::move(words));
    }
}

}  // namespace grafverif
