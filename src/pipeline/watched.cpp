// SPDX-License-Identifier: MIT
#include "pipeline/watched.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <ostream>
#include <utility>
#include <vector>

#include "grafverif/ir/chart_run.hpp"
#include "ir/network_run.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/chart.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

/// When the observer came to its locations: one entry a change, the last time it came to each.
struct Sighting {
    std::vector<std::pair<std::string, std::int64_t>> changes = {};
    std::map<std::string, std::int64_t> last = {};

    std::string at(const std::string& location) const {
        const auto known = last.find(location);
        return seconds_text(known == last.end() ? 0 : known->second);
    }
};

Sighting sighting(const Network& network, const Run& run) {
    Sighting seen;
    const auto observer = network.processes.size() - 1;
    const Network::Template& automaton =
        network.templates[network.processes[{static_cast<std::uint32_t>(observer)}].automaton];
    NetworkState state = initial_state(network);
    Id<Network::Location> here = state.locations[observer];
    std::int64_t time_ms = 0;
    for (const Move& move : run.moves) {
        if (const auto* delay = std::get_if<Delay>(&move)) time_ms += delay->units * network.time_unit_ms;
        if (perform(network, state, move).result != Step::Result::Done) break;
        if (state.locations[observer] == here) continue;
        here = state.locations[observer];
        seen.changes.emplace_back(automaton.locations[here].name, time_ms);
        seen.last[automaton.locations[here].name] = time_ms;
    }
    return seen;
}

/// What charts call the variables of theirs that have another name in the network.
std::map<Id<Network::Variable>, std::string> told_variables(const Network& network) {
    std::map<Id<Network::Variable>, std::string> told;
    for (const Network::Controller& controller : network.controllers) {
        const std::string owner = prefix_of(network, controller);
        for (const auto& step : controller.words.steps) told[step.variable] = owner + step.name.variable();
        for (const auto& internal : controller.words.internals) told[internal.variable] = owner + internal.name;
        for (std::size_t k = 0; k < controller.timers.size(); ++k)
            if (const std::string timer = time_text(network, controller, k); !timer.empty())
                told[controller.words.timers[k].end] = timer;
    }
    return told;
}

std::string term_words(const Network& network, Id<Expr> term) {
    const auto told = told_variables(network);
    return expr_text(network.exprs, term, chart_spelling, [&](std::ostream& out, const Expr& leaf) {
        if (leaf.op == Op::Variable) {
            const Id<Network::Variable> variable{static_cast<std::uint32_t>(leaf.value)};
            const auto known = told.find(variable);
            out << (known == told.end() ? network.variables[variable].name : known->second);
            return;
        }
        const Network::Process& process = network.processes[{at_process(leaf)}];
        out << process.name << '.' << network.templates[process.automaton].locations[{at_location(leaf)}].name;
    });
}

std::string observer_words(const Sighting& seen) {
    std::vector<std::string> changes;
    for (const auto& [location, time_ms] : seen.changes) changes.push_back(location + " at " + seconds_text(time_ms));
    return fmt::format("its observer: {}", fmt::join(changes, ", "));
}

/// When `term` came within the scope that fails.
std::string occurrences_words(const std::string& term, std::int64_t count, const Sighting& seen) {
    std::vector<std::string> times;
    for (const auto& [location, time_ms] : seen.changes) {
        if (location == "outside") times.clear();
        const bool too_often = std::ssize(times) == count && !location.starts_with("off_");
        if (location.starts_with("on_") || too_often) times.push_back(seconds_text(time_ms));
    }
    if (std::ssize(times) <= count) return observer_words(seen);  // a run that does not fail
    const std::string last = times.back();
    times.pop_back();
    const std::string earlier = times.size() < 6 ? fmt::format("{}", fmt::join(times, ", "))
                                                 : fmt::format("{} times from {}", times.size(), times.front());
    return fmt::format("{} comes at {} and at {}, more than {}", term, earlier, last,
                       count == 1 ? "once" : fmt::format("{} times", count));
}

}  // namespace

std::string watched_words(const Network& network, const Property& property, const Network& observed, const Run& run) {
    const Sighting seen = sighting(observed, run);
    std::vector<std::string> of;
    for (const Id<Expr> operand : property.operands) of.push_back('`' + term_words(network, operand) + '`');
    if (property.watch.kind == Sentence::Kind::Occurrences) return occurrences_words(of[0], property.watch.count, seen);
    const std::string duration = duration_text(property.watch.duration_ms);
    if (property.watch.duration_ms > 0 && property.watch.scope == Sentence::Scope::Globally)
        switch (property.watch.kind) {
        case Sentence::Kind::Response:
            return fmt::format("{} at {}, and {} does not come within {}", of[0], seen.at("due"), of[1], duration);
        case Sentence::Kind::HoldsFor:
            return fmt::format("{} holds from {} to {} only, not for {}", of[0], seen.at("on"), seen.at("failed"),
                               duration);
        case Sentence::Kind::HoldsAtMost:
            return fmt::format("{} holds for more than {} from {} on", of[0], duration, seen.at("on"));
        case Sentence::Kind::Recurrence:
            return fmt::format("no {} for more than {} from {} on", of[0], duration, seen.at("due"));
        case Sentence::Kind::Since:
            if (!seen.last.contains("during"))
                return fmt::format("{} at {}, and {} has not been", of[0], seen.at("failed"), of[1]);
            return fmt::format("{} at {}, more than {} since {} ended at {}", of[0], seen.at("failed"), duration, of[1],
                               seen.at("after"));
        case Sentence::Kind::Absence:
        case Sentence::Kind::Universality:
        case Sentence::Kind::Existence:
        case Sentence::Kind::Precedence:
        case Sentence::Kind::Occurrences: break;
        }
    return observer_words(seen);
}

}  // namespace grafverif
