// SPDX-License-Identifier: MIT
// Checks closed loops with the embedded timed engine.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include "check/decomposition/decomposition.hpp"
#include "check/inputs/inputs.hpp"
#include "check/localization/localization.hpp"
#include "check/shares.hpp"
#include "check/timed/timed.hpp"
#include "check/vacuity.hpp"
#include "compose/observe.hpp"
#include "explain/violation.hpp"
#include "ir/probes.hpp"
#include "ir/program/fault_text.hpp"
#include "pipeline/check.hpp"
#include "pipeline/explain.hpp"
#include "pipeline/models.hpp"
#include "pipeline/staged_search.hpp"
#include "pipeline/watched.hpp"
#include "plant/time_unit.hpp"
#include "report/report.hpp"
#include "run/project.hpp"

namespace grafverif {

namespace {

/// Runs several searches alternately; the first search explores the loop without observers. Returns, for each search,
/// the number of states that all other searches had explored when the last step of this search began.
std::vector<std::uint64_t> run(std::deque<StagedSearch*> searches, const Limits& limits) {
    const Deadline& deadline = limits.deadline;
    std::vector<std::uint64_t> earlier(searches.size(), 0);
    const auto step = [&](std::size_t i, const auto& search) {
        earlier[i] = 0;
        for (std::size_t k = 0; k < searches.size(); ++k)
            if (k != i) earlier[i] += searches[k]->states();
        search(*searches[i]);
    };
    const Deadline abstract = most_of(deadline);
    for (std::size_t i = 0; i < searches.size(); ++i)
        step(i, [&](StagedSearch& search) {
            LocalizationLimits bounds;
            if (i > 0 && searches.front()->is_large()) bounds.whole >>= 3U;
            search.begin(share_of(abstract, searches.size() - i), bounds);
        });
    std::vector<std::size_t> open(searches.size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    const auto refine = [&](std::uint64_t states) {
        // A search that decides only the vacuity of properties skips the third round, unless no other search remains:
        // it would use much of the time in which other searches can still decide properties.
        std::vector<std::size_t> active;
        for (const std::size_t i : open)
            if (states != search_rounds[2] || !searches[i]->decides_only_vacuity()) active.push_back(i);
        if (active.empty()) active = open;
        std::size_t left = active.size();
        for (const std::size_t i : active) {
            bool again = false;
            step(i, [&](StagedSearch& search) { again = search.refine(states, share_of(abstract, left--)); });
            if (!again) std::erase(open, i);
        }
    };
    // In each round, a search can use the time that earlier searches of the round did not use. Therefore the search of
    // the loop without observers, which usually decides the most properties, runs last in the round.
    std::ranges::reverse(open);
    for (const std::uint64_t states : search_rounds) refine(states);
    while (!open.empty() && !is_over(abstract, limits.stop)) refine(std::ranges::max(search_rounds));
    open.clear();
    for (std::size_t i = 0; i < searches.size(); ++i)
        if (searches[i]->needs_whole()) open.push_back(i);
    for (std::size_t left = open.size(); const std::size_t i : open)
        step(i, [&](StagedSearch& search) { search.search_complete(share_of(deadline, left--)); });
    return earlier;
}

TimedResult search(const LoopToCheck& loop, const CheckOptions& options, AdditionalResults additional = {}) {
    const Observe nothing = std::identity{};
    StagedSearch search(loop, nothing, loop.network, options, additional);
    run({&search}, options.limits);
    return search.result();
}

/// Converts the results of the engine to a report. If the replay of a run fails, the report contains an internal
/// failure instead of this run.
class Reporter {
public:
    /// If `explains` is true, the report also contains the causes of violations and of unreachable steps, and the runs
    /// of the verdicts as moves, which a certificate needs.
    Reporter(const LoopToCheck& loop, const CheckOptions& options, bool explains = true)
        : explains_(explains),
          loop_(loop),
          network_(loop.network),
          options_(options),
          detail_(options.every_move ? Detail::Everything : Detail::Chart) {}

    Report report(TimedResult result) {
        Report report{network_.name, settings_of(network_, "timed")};
        for (ModelError& error : result.errors) {
            if (!replays(error.run, fmt::format("the trace to `{}`", word(error.kind)))) error.run = {};
            report.error_traces.push_back(error_trace_of(network_, error, detail_));
            if (error.kind == ModelError::Kind::ActionRace) name_race(report.error_traces.back(), error.run);
        }
        std::vector<Violation> violations;
        apply_probes(network_.properties, result.verdicts);
        for (Verdict& verdict : result.verdicts) {
            if (verdict.about.valid() && is_probe(network_.properties[verdict.about])) continue;
            std::optional<Run> run = explains_ ? verdict.run : std::nullopt;
            if (verdict.outcome == Outcome::Holds && !options_.witnesses) verdict.run.reset();
            if (verdict.run && !replays(*verdict.run, fmt::format("the trace of `{}`", verdict.property))) {
                verdict.run.reset();
                run.reset();
            }
            if (verdict.run && verdict.outcome == Outcome::Violated)
                violations.push_back({report.answers.size(), *verdict.run});
            report.answers.push_back(result_of(network_, std::move(verdict), detail_));
            report.answers.back().verdict.run = std::move(run);
        }
        if (!loop_.disabled_corrections && !is_watched() && explains_) {
            explain(network_, violations, again(result, options_.limits), options_.limits, report);
            Limits limits = options_.limits;
            limits.states = std::min(limits.states.value_or(many_states), many_states);
            limits.deadline = explanation_deadline(limits.deadline, result.seconds);
            explain_dead_steps(network_, loop_.charts, again(result, limits), report);
        }
        report.profile = std::move(result.profile);
        report.failures = std::move(failures_);
        return report;
    }

private:
    /// Returns a function that checks properties of a network similar to the checked network. The result is empty if
    /// the checked network has so many states that another check may take a long time.
    PropertyChecker again(const TimedResult& result, const Limits& limits) const {
        if (result.states >= many_states) return {};
        return [this, limits](const Network& network, std::vector<std::string> names) {
            CheckOptions options = options_;
            options.properties = std::move(names);
            options.limits = limits;
            options.profile = false;
            return search({network}, options).verdicts;
        };
    }

    /// True if the network contains an observer (an automaton that monitors a property). The properties of a network
    /// with an observer differ from the properties of the closed loop.
    bool is_watched() const {
        return std::ranges::find(network_.processes, Network::ProcessKind::Observer, &Network::Process::kind) !=
               network_.processes.end();
    }

    void name_race(ModelErrorTrace& breakdown, const Run& run) const {
        const std::optional<ContradictoryActions> found = clash(project(network_, run), loop_.charts);
        if (!found) return;
        if (found->fault) {
            breakdown.code = "no-value";
            breakdown.message = fmt::format("{}, in a scan of `{}`", text_of(*found->fault), found->controller);
            return;
        }
        const std::string what =
            found->variable.empty()
                ? "contradictory forcing orders"
                : fmt::format("two stored actions assign different values to `{}`", found->variable);
        breakdown.message = fmt::format("{}, in an evolution of `{}`", what, found->controller);
    }

    bool replays(const Run& run, const std::string& what) {
        if (loop_.disabled_corrections) return true;
        const std::optional<Disagreement> found = disagreement(project(network_, run), loop_.charts);
        if (found) failures_.push_back(replay_failure(what, *found));
        return !found;
    }

    const bool explains_;
    const LoopToCheck loop_;
    const Network& network_;
    const CheckOptions& options_;
    Detail detail_;
    std::vector<std::string> failures_ = {};
};

}  // namespace

LoopToCheck loop_to_check(const Model& model, Id<ClosedLoop> loop, const Network& network) {
    return {network, charts_of(model, model.loops[loop]), false,
            [&model, loop] { return finest_duration(model, model.loops[loop]); },
            prover_by_pdr(translator_of_abstractions(model, loop))};
}

namespace {

/// Checks a property that has an observer. The checked network consists of the closed loop and this observer.
class WatchedCheck {
public:
    WatchedCheck(const LoopToCheck& loop, Id<Property> id, const CheckOptions& options)
        : loop_(loop),
          id_(id),
          observe_([name = loop.network.properties[id].name, id](const Network& of) {
              Network network = observed(of, {id}, Vacuity::Probed);
              for (const Property& property : std::exchange(network.properties, {}))
                  if (property.name == name || probed_by(property) == name) network.properties.add(property);
              return network;
          }),
          network_(observe_(loop.network)),
          own_(options_of(options)),
          search_(loop_, observe_, network_, own_) {}

    StagedSearch& search() { return search_; }

    Report report() {
        const LoopToCheck watched_loop{network_, loop_.charts, loop_.disabled_corrections, loop_.finest, loop_.prove};
        Report report = Reporter(watched_loop, own_).report(search_.result());
        const Property& sentence = loop_.network.properties[id_];
        for (PropertyResult& answer : report.answers) {
            if (answer.verdict.outcome != Outcome::Violated || !answer.trace) continue;
            if (const auto found = violation_of(sentence.watch, operand_texts(loop_.network, sentence), *answer.trace))
                answer.verdict.notes.insert(answer.verdict.notes.begin(), found->words());
        }
        return report;
    }

private:
    CheckOptions options_of(const CheckOptions& options) const {
        CheckOptions own = options;
        own.properties.clear();
        for (const Property& property : network_.properties) own.properties.push_back(property.name);
        own.profile = false;
        return own;
    }

    const LoopToCheck& loop_;
    const Id<Property> id_;
    const Observe observe_;
    const Network network_;
    const CheckOptions own_;
    StagedSearch search_;
};

/// Adds the results `found` of a search to `report`. `earlier` is the number of states that previous searches explored.
void take(Report&& found, std::uint64_t earlier, Report& report) {
    for (PropertyResult& answer : found.answers)
        report_earlier(answer.verdict, "searches for other properties", earlier);
    std::ranges::move(found.answers, std::back_inserter(report.answers));
    std::ranges::move(found.failures, std::back_inserter(report.failures));
    for (ModelErrorTrace& breakdown : found.error_traces)
        if (std::ranges::find(report.error_traces, breakdown.message, &ModelErrorTrace::message) ==
            report.error_traces.end())
            report.error_traces.push_back(std::move(breakdown));
}

/// Sorts the results in the order in which the closed loop declares the properties. Results for undeclared properties
/// come last.
void put_in_order(const Network& network, std::vector<PropertyResult>& answers) {
    for (PropertyResult& answer : answers) {
        if (!answer.verdict.declared || !answer.verdict.about.valid()) continue;
        const std::string& name = answer.verdict.property;  // the name may be `S.X7` for a property `S`
        for (const Id<Property> id : network.properties.ids())
            if (const std::string& of = network.properties[id].name; name == of || name.starts_with(of + '.'))
                answer.verdict.about = id;
    }
    std::ranges::stable_sort(answers, {}, [](const PropertyResult& answer) { return answer.verdict.about.index; });
}

Report checked(const LoopToCheck& loop, const CheckOptions& options, bool explains, AdditionalResults additional) {
    const std::vector<Id<Property>> by_observers = watched(loop.network);
    if (by_observers.empty()) return Reporter(loop, options, explains).report(search(loop, options, additional));

    const auto is_requested = [&](Id<Property> id) {
        const std::string& name = loop.network.properties[id].name;
        return options.properties.empty() || std::ranges::find(options.properties, name) != options.properties.end();
    };
    const Network alone = observed(loop.network, {});
    CheckOptions rest = options;
    std::erase_if(rest.properties, [&](const std::string& name) {
        return std::ranges::any_of(by_observers,
                                   [&](Id<Property> id) { return loop.network.properties[id].name == name; });
    });
    const bool only_watched = rest.properties.empty() && !options.properties.empty();
    if (only_watched) {
        rest.properties = {"no_timelock"};
        additional.timelock = true;
    }
    const LoopToCheck unwatched{alone, loop.charts, loop.disabled_corrections, loop.finest, loop.prove};
    const Observe nothing = std::identity{};
    StagedSearch search(unwatched, nothing, alone, rest, additional);
    // If all requested properties have observers, this search can only add a note about a timelock.
    if (only_watched) search.make_brief();
    std::deque<StagedSearch*> searches{&search};
    std::deque<WatchedCheck> checks;
    for (const Id<Property> id : by_observers)
        if (is_requested(id)) searches.push_back(&checks.emplace_back(loop, id, options).search());
    const std::vector<std::uint64_t> earlier = run(searches, options.limits);
    Report report{alone.name, settings_of(alone, "timed")};
    for (std::size_t i = 0; i < checks.size(); ++i) take(checks[i].report(), earlier[i + 1], report);
    Report made = Reporter(unwatched, rest, explains).report(search.result());
    report.profile = std::move(made.profile);
    take(std::move(made), earlier[0], report);
    put_in_order(loop.network, report.answers);
    return report;
}

}  // namespace

Report check(const LoopToCheck& loop, const CheckOptions& options) { return checked(loop, options, true, {}); }

Report check_without_causes(const LoopToCheck& loop, const CheckOptions& options, bool timelock) {
    return checked(loop, options, false, {.timelock = timelock, .profile = false});
}

std::optional<Report> check(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how,
                            const CheckOptions& options, Diagnostics& diagnostics) {
    const auto network = network_of(model, loop, how, diagnostics);
    if (!network || !all_known(options.properties, property_names(*network), diagnostics)) return {};
    return check(loop_to_check(model, loop, *network), options);
}

}  // namespace grafverif
