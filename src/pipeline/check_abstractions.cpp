// SPDX-License-Identifier: MIT
// Localization and input abstraction for untimed models.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <utility>

#include "check/inputs/inputs.hpp"
#include "explain/moves.hpp"
#include "ir/patterns.hpp"
#include "pipeline/check.hpp"
#include "pipeline/models.hpp"

namespace grafverif {

namespace {

/// Returns the time at which localization and input abstraction must end: after a third of the time until the deadline,
/// and after at most 20 s. The other engines use the remaining time.
std::chrono::steady_clock::time_point end_of_abstractions(
    std::optional<std::chrono::steady_clock::time_point> deadline) {
    constexpr std::chrono::seconds most(20);
    const auto now = std::chrono::steady_clock::now();
    return deadline ? std::min(now + most, now + (*deadline - now) / 3) : now + most;
}

/// Uses input abstraction to decide properties that are undecided in `result`. Only verdicts that are proved without a
/// run are used. Therefore the search for the concrete runs of an abstract run ends after 1000 states.
void decide_by_inputs(const Network& network, const TimedOptions& options, TimedResult& result) {
    constexpr std::size_t followed = 1000;
    const Observe nothing = std::identity{};
    TimedOptions own = options;
    own.max_states = TimedOptions{}.max_states;
    InputSearch search(network, nothing, own, result,
                       {.alternatives = 0, .followed = followed, .followed_coarse = followed, .explored = 0});
    for (const std::uint64_t states : search_rounds)
        if (!search.run(states, own.deadline)) return;
}

}  // namespace

std::vector<Verdict> decided_by_abstractions(const SystemToCheck& check, const CheckOptions& options,
                                             const LocalizationLimits& limits) {
    if (options.whole || !check.network || !check.network()) return {};
    Network network = check.system.ticks.valid() ? *check.network() : without_clocks(*check.network());
    const auto is_observer = [](const Network::Process& process) {
        return process.kind == Network::ProcessKind::Observer;
    };
    if (std::ranges::any_of(network.processes, is_observer)) return {};  // an observer reads the complete network
    TimedOptions timed;
    set_limits(timed, options.limits);
    timed.deadline = end_of_abstractions(options.limits.deadline);
    if (options.limits.progress)
        timed.progress = [&options](const TimedProgress& now) {
            options.limits.progress({[&now] { return fmt::format("abstractions: {} states", now.states); }});
        };
    timed.max_states = limits.local;
    timed.jobs = options.jobs;
    timed.timelock = false;
    timed.profile = ProfileFor::None;
    std::map<std::string_view, Id<Property>> requested;
    for (const std::size_t index : selected_properties(check.system, options.properties)) {
        const Id<Property> id{static_cast<std::uint32_t>(index)};
        const Property& property = check.system.properties[id];
        const auto same = [&](const Property& other) {
            return other.name == property.name && other.pattern == property.pattern;
        };
        if (!is_about_single_states(property.pattern) || std::ranges::none_of(network.properties, same)) continue;
        requested.emplace(property.name, id);
        timed.properties.push_back(property.name);
    }
    if (requested.empty()) return {};
    // Removes all properties that are not requested. Otherwise each search would also decide a declared `no timelock`,
    // although the verdict would not be used.
    for (const Property& property : std::exchange(network.properties, {}))
        if (requested.contains(property.name)) network.properties.add(property);
    // Searches the complete network only briefly, because other engines search it completely.
    const auto first_look = [&](const Network& whole, TimedOptions look) {
        look.max_states = std::min(look.max_states, limits.whole);
        return check_timed_by_parts(whole, look);
    };
    TimedResult result = check_timed_by_cells(network, timed, limits, {}, first_look);
    decide_by_inputs(network, timed, result);
    std::vector<Verdict> decided;
    for (Verdict& found : result.verdicts) {
        const bool is_proof = found.scope.cells || (found.abstraction && !found.run);
        const auto at = requested.find(found.property);
        if (!is_proof || found.outcome == Outcome::Unknown || at == requested.end()) continue;
        const Id<Property> id = at->second;
        Verdict& verdict = decided.emplace_back(verdict_on(id, check.system.properties[id]));
        verdict.outcome = found.outcome;
        verdict.vacuous = found.vacuous;
        verdict.states = std::move(found.states);
        verdict.transitions = found.transitions;
        verdict.seconds = found.seconds;
        verdict.scope = std::move(found.scope);
        verdict.abstraction = std::move(found.abstraction);
        verdict.notes.emplace_back(verdict.abstraction ? "decided by input abstraction"
                                                       : "decided by localization (cells)");
    }
    return decided;
}

}  // namespace grafverif
