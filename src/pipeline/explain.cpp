// SPDX-License-Identifier: MIT
#include "pipeline/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>

#include "explain/causes.hpp"
#include "explain/change.hpp"
#include "explain/inputs.hpp"
#include "explain/instants.hpp"
#include "explain/moves.hpp"
#include "explain/settling.hpp"
#include "ir/network_run.hpp"
#include "ir/patterns.hpp"

namespace grafverif {

namespace {

/// Searches once more for properties violated at power-on: whether they hold `at stable`.
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

std::string gave_up(std::size_t count, std::string_view what, std::size_t tried) {
    return fmt::format("no minimal set among the {} {} of the counterexample was found after {} attempts", count, what,
                       tried);
}

/// Returns true if a search is to stop; `limits` must outlive it.
StopAsked stopped_by(const Limits& limits) {
    return [&limits] {
        if (limits.stop != nullptr && limits.stop->load(std::memory_order_relaxed)) return true;
        return limits.deadline && std::chrono::steady_clock::now() >= *limits.deadline;
    };
}

/// The default effort of a search.
constexpr std::size_t most_moves = 5000, most_steps = 20'000;

/// Marks the values that cause the failure, and finds moves without which the property holds.
void explain_run(const Network& network, const Run& run, const Limits& limits, Answer& answer) {
    if (!answer.verdict.about.valid() || !answer.trace) return;
    const Property& property = network.properties[answer.verdict.about];
    const auto states = replay(network, run);
    const auto causes = states ? causes_of(network, property, *states, run.loop) : std::nullopt;
    if (!causes) return;
    mark(network, *states, *causes, *answer.trace);
    const ShortestChange change = shortest_change(network, property, run, most_moves, stopped_by(limits));
    if (change.found)
        for (const std::size_t move : change.found->left_out) answer.trace->left_out.push_back(move + 1);
    if (change.exhausted) answer.verdict.notes.push_back(gave_up(change.free_moves, "free moves", change.tried));
}

/// For a run without a plant, whose inputs are free.
void explain_inputs(const TransitionSystem& system, const Property& property, const SystemRun& run,
                    const Limits& limits, Answer& answer) {
    const InputChange change = fewest_input_changes(system, property, run, most_steps, stopped_by(limits));
    if (change.left_out) mark(system, *change.left_out, *answer.trace);
    if (change.exhausted)
        answer.verdict.notes.push_back(gave_up(change.events.size(), "input changes and timer expiries", change.tried));
}

/// For a run with interleaved plant automata.
void explain_moves(const Network& timed, const TransitionSystem& system, const Property& property, const SystemRun& run,
                   const Limits& limits, Answer& answer) {
    const Network played = system.ticks.valid() ? timed : without_clocks(timed);
    const auto asked = std::ranges::find(played.properties, property.name, &Property::name);
    if (asked == played.properties.end() || asked->pattern != property.pattern) return;
    const auto moves = moves_of(played, system, run);
    if (!moves) return;
    const ShortestChange change = shortest_change(played, timed, *asked, moves->run, most_moves, stopped_by(limits));
    if (change.found) mark(*moves, change.found->left_out, *answer.trace);
    if (change.exhausted) answer.verdict.notes.push_back(gave_up(change.free_moves, "free moves", change.tried));
}

}  // namespace

void explain(const Network& network, const std::vector<Violation>& violations, const Search& search,
             const Limits& limits, Report& report) {
    explain_power_on(network, violations, search, report);
    for (const Violation& each : violations) {
        Answer& answer = report.answers[each.answer];
        explain_run(network, each.run, limits, answer);
        if (answer.verdict.pattern != Pattern::NoTimelock || !answer.trace) continue;
        if (std::string words = unsettled_words(*answer.trace); !words.empty())
            answer.verdict.notes.push_back(std::move(words));
    }
}

void explain(const SystemToCheck& check, const SystemRun& run, const Limits& limits, Answer& answer) {
    const TransitionSystem& system = check.system;
    if (!answer.verdict.about.valid() || !answer.trace) return;
    const Property& property = system.properties[answer.verdict.about];
    const auto causes = causes_of(system, property, run);
    if (!causes) return;
    mark(system, run, *causes, *answer.trace);
    if (!is_about_all_states(property.pattern)) return;
    const std::optional<Network>* const network = check.network ? &check.network() : nullptr;
    if (network != nullptr && *network) explain_moves(**network, system, property, run, limits, answer);
    else explain_inputs(system, property, run, limits, answer);
}

void explain(const Chart& chart, ExecutionMode mode, const Limits& limits, Answer& answer) {
    if (!answer.trace) return;
    InstantChange change = fewest_changes(chart, mode, *answer.trace, most_steps, stopped_by(limits));
    if (change.left_out) answer.trace->left_out_values = std::move(*change.left_out);
    if (change.exhausted) answer.verdict.notes.push_back(gave_up(change.events, "input changes", change.tried));
}

}  // namespace grafverif
