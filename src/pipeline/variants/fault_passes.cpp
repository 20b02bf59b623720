// SPDX-License-Identifier: MIT
#include "pipeline/variants/fault_passes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>

#include "check/shares.hpp"
#include "pipeline/staged_search.hpp"

namespace grafverif {

namespace {

/// Maximum number of states that the second pass explores. This pass searches only the complete network.
constexpr std::uint64_t second_states = std::uint64_t{1} << 22U;

/// Adds the results of a later pass to `report`. Verdicts that an earlier pass decided are kept.
void merge(Report&& later, Report& report) {
    if (report.answers.empty()) return void(report = std::move(later));
    for (PropertyResult& result : later.answers) {
        const auto known = std::ranges::find(report.answers, result.verdict.property,
                                             [](const PropertyResult& each) { return each.verdict.property; });
        if (known == report.answers.end()) report.answers.push_back(std::move(result));
        else if (known->verdict.outcome == Outcome::Unknown) *known = std::move(result);
    }
    add_errors(std::move(later.error_traces), report.error_traces);
    std::ranges::move(later.failures, std::back_inserter(report.failures));
}

/// The undecided properties of a report.
struct OpenProperties {
    std::set<std::string> names = {};
    bool limited = false;  ///< a property is undecided because of the limit on states
};

OpenProperties open_properties(const Report& report) {
    OpenProperties found;
    for (const PropertyResult& result : report.answers) {
        if (result.verdict.outcome != Outcome::Unknown) continue;
        found.names.insert(base_name(result.verdict.property, result.verdict.pattern));
        found.limited = found.limited || result.verdict.obstacle == UnknownReason::Bound;
    }
    return found;
}

}  // namespace

std::string base_name(const std::string& property, Pattern pattern) {
    return pattern == Pattern::ReachableAllSteps ? property.substr(0, property.find('.')) : property;
}

void add_errors(std::vector<ModelErrorTrace>&& found, std::vector<ModelErrorTrace>& errors) {
    for (ModelErrorTrace& error : found)
        if (std::ranges::none_of(errors, [&](const ModelErrorTrace& each) {
                return each.code == error.code && each.message == error.message;
            }))
            errors.push_back(std::move(error));
}

double states_of(const Report& report) {
    double most = 0;
    for (const PropertyResult& result : report.answers) {
        const UnknownReason obstacle = result.verdict.obstacle;
        if (obstacle == UnknownReason::Bound || obstacle == UnknownReason::Memory || obstacle == UnknownReason::Stopped)
            return 0;
        most = std::max(most, static_cast<double>(std::stoull("0" + result.verdict.states)));
    }
    return most;
}

Report check_in_passes(const LoopToCheck& loop, CheckOptions options, const FaultsRequest& request, bool timelock,
                       double expected) {
    Report report;
    const Deadline deadline = options.limits.deadline;
    const bool swaps = expected > static_cast<double>(request.first_states) && expected <= second_states;
    bool limited = false;
    for (const int pass : swaps ? std::array{2, 1, 3} : std::array{1, 2, 3}) {
        const bool early = swaps && pass == 2;
        options.limits.deadline = early ? share_of(deadline, 2) : deadline;
        if (pass == 3) options.limits.states.reset();
        else options.limits.states = pass == 1 ? request.first_states : second_states;
        options.whole = pass == 2;
        merge(check_without_causes(loop, options, timelock), report);
        const OpenProperties open = open_properties(report);
        options.properties.assign(open.names.begin(), open.names.end());
        limited = open.limited || (limited && pass == 1);
        if (open.names.empty() || !(early || limited)) break;
        if (is_over(request.limits.deadline, request.limits.stop)) break;
    }
    return report;
}

}  // namespace grafverif
