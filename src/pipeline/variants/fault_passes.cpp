// SPDX-License-Identifier: MIT
#include "pipeline/variants/fault_passes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
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

/// Tries to prove `no deadlock` and `no timelock` by the arguments about processes and PLC cycles, after a search of few
/// states. These proofs also exclude model errors. If the network has many states, they usually need less time than a
/// search. Removes the proved properties from `options`; returns true if `no timelock` is proved.
bool prove_briefly(const LoopToCheck& loop, CheckOptions& options) {
    CheckOptions brief = options;
    std::erase_if(brief.properties, [&](const std::string& name) {
        const auto found = std::ranges::find(loop.network.properties, name, &Property::name);
        // Only `no timelock` can be requested without a declaration.
        return found != loop.network.properties.end() && found->pattern != Pattern::NoDeadlock &&
               found->pattern != Pattern::NoTimelock;
    });
    if (brief.properties.empty()) return false;
    const Observe nothing = std::identity{};
    StagedSearch search(loop, nothing, loop.network, brief, {.profile = false});
    search.begin(options.limits.deadline, {.whole = search_rounds[0] >> 2U, .local = 0});
    (void)search.refine(search_rounds[0], options.limits.deadline);
    const TimedResult found = search.result();
    bool time_passes = false;
    for (const Verdict& verdict : found.verdicts) {
        if (verdict.outcome != Outcome::Holds || !found.errors.empty()) continue;
        std::erase(options.properties, verdict.property);
        time_passes = time_passes || verdict.pattern == Pattern::NoTimelock;
    }
    return time_passes;
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
    bool proved = false;
    if (expected > static_cast<double>(request.first_states >> 3U) && timelock) {
        options.limits.deadline = share_of(deadline, 4);
        proved = prove_briefly(loop, options);
        if (options.properties.empty()) return report;
    }
    const bool swaps = expected > static_cast<double>(request.first_states) && expected <= second_states;
    bool limited = false;
    for (const int pass : swaps ? std::array{2, 1, 3} : std::array{1, 2, 3}) {
        const bool early = swaps && pass == 2;
        options.limits.deadline = early ? share_of(deadline, 2) : deadline;
        if (pass == 3) options.limits.states.reset();
        else options.limits.states = pass == 1 ? request.first_states : second_states;
        options.whole = pass == 2;
        // With `no timelock`, the last pass is that of a plain check.
        merge(check_without_causes(loop, options, timelock && (pass == 3 || !proved)), report);
        const OpenProperties open = open_properties(report);
        options.properties.assign(open.names.begin(), open.names.end());
        limited = open.limited || (limited && pass == 1);
        if (open.names.empty() || !(early || limited)) break;
        if (is_over(request.limits.deadline, request.limits.stop)) break;
    }
    return report;
}

}  // namespace grafverif
