// SPDX-License-Identifier: MIT
// Checks with the embedded timed engine.
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
#include "pipeline/check.hpp"
#include "pipeline/explain.hpp"
#include "pipeline/models.hpp"
#include "pipeline/watched.hpp"
#include "plant/time_unit.hpp"
#include "report/report.hpp"
#include "run/project.hpp"

namespace grafverif {

namespace {

/// Returns the number with thousands separators: `1,234,567`.
std::string grouped(std::uint64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
    return text;
}

std::string progress_text(const TimedProgress& now) {
    const double rate = now.seconds > 0 ? static_cast<double>(now.states) / now.seconds / 1e6 : 0;
    return fmt::format("{} states, {:.2f} million/s, {} open, {} MiB, {:.0f} s", grouped(now.states), rate,
                       grouped(now.queue), now.bytes >> 20U, now.seconds);
}

TimedOptions timed_options(const LoopToCheck& loop, const CheckOptions& options) {
    TimedOptions timed;
    timed.finest = loop.finest;
    timed.properties = options.properties;
    timed.max_states = options.limits.states.value_or(timed.max_states);
    set_limits(timed, options.limits);
    if (options.limits.progress)
        timed.progress = [&options](const TimedProgress& now) {
            options.limits.progress({[&now] { return progress_text(now); }});
        };
    timed.jobs = options.jobs;
    timed.profile = options.profile;
    timed.many = options.many;
    return timed;
}

bool is_open(const Verdict& verdict) {
    return verdict.obstacle == UnknownReason::Bound || verdict.obstacle == UnknownReason::Stopped;
}

/// A search in steps, so that several searches under one limit can alternate. The steps are: a bounded search of the
/// complete loop with localization, rounds of input abstraction, and the search of the complete loop for the properties
/// that remain open.
class StagedSearch {
public:
    /// `observe` builds `network` from the loop by adding the observer of the only property, or it changes nothing.
    /// Localization does not apply to an observer, which reads the complete loop. All references must outlive the
    /// search.
    StagedSearch(const LoopToCheck& loop, const Observe& observe, const Network& network, const CheckOptions& options)
        : is_watched_(&network != &loop.network),
          in_steps_(!options.whole),
          loop_(loop),
          observe_(observe),
          network_(network),
          options_(timed_options(loop, options)) {
        if (is_watched_) options_.timelock = false;  // decided in the loop without the observer
    }

    /// Performs the first step. `is_large` is true if the complete loop exceeds the bound of this step.
    void begin(const Deadline& deadline, bool is_large) {
        LocalizationLimits limits;
        if (options_.max_states <= limits.whole || loop_.disabled_corrections) in_steps_ = in_steps_ && !is_watched_;
        options_.deadline = deadline;
        if (!in_steps_) return void(result_ = check_timed(network_, options_));
        if (is_large) limits.whole >>= 3U;
        if (is_watched_) limits.local = 0;
        const WholeSearch whole = is_watched_ ? WholeSearch(check_timed) : WholeSearch(check_timed_by_parts);
        complete_.emplace(expand(network_), options_, limits, LocalAblations{}, whole);
        complete_->begin();
        if (options_.max_states <= limits.whole || loop_.disabled_corrections || !needs_whole()) return;
        expanded_ = expand(loop_.network);
        abstract_ = options_;
        abstract_.max_states = TimedOptions{}.max_states;
        inputs_.emplace(expanded_, observe_, abstract_, complete_->found());
    }

    /// Performs one round of input abstraction. Returns false if no further round is possible.
    bool refine(std::uint64_t states, const Deadline& deadline) { return inputs_ && inputs_->run(states, deadline); }

    /// True if requested verdicts are open that the last step may decide.
    bool needs_whole() {
        return complete_ && complete_->needs_whole() &&
               std::ranges::any_of(complete_->found().verdicts, [&](const Verdict& verdict) {
                   return is_open(verdict) && !(verdict.about.valid() && is_probe(network_.properties[verdict.about]));
               });
    }

    /// Searches the complete loop.
    void search_complete(const Deadline& deadline) {
        options_.deadline = deadline;
        complete_->search_complete();
    }

    std::uint64_t states() { return complete_ ? complete_->found().states : result_.states; }
    bool is_large() { return complete_ && std::ranges::any_of(complete_->found().verdicts, is_open); }
    TimedResult result() { return complete_ ? complete_->result() : std::move(result_); }

private:
    const bool is_watched_;
    bool in_steps_;
    const LoopToCheck& loop_;
    const Observe& observe_;
    const Network& network_;
    TimedOptions options_, abstract_ = {};
    Network expanded_ = {};
    std::optional<CellSearch> complete_ = {};
    std::optional<InputSearch> inputs_ = {};
    TimedResult result_ = {};
};

/// Performs all steps of several searches. Returns, per search, the number of states that the others explored before
/// its last step. The first search is that of the loop without observers.
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
            search.begin(share_of(abstract, searches.size() - i), i > 0 && searches.front()->is_large());
        });
    std::vector<std::size_t> open(searches.size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    const auto refine = [&](std::uint64_t states) {
        std::size_t left = open.size();
        std::erase_if(open, [&](std::size_t i) {
            bool again = false;
            step(i, [&](StagedSearch& search) { again = search.refine(states, share_of(abstract, left--)); });
            return !again;
        });
    };
    // A search may use the time that other searches leave. Therefore the search with most properties is the last one.
    std::ranges::reverse(open);
    for (const std::uint64_t states : input_rounds) refine(states);
    while (!open.empty() && !is_over(abstract, limits.stop)) refine(std::ranges::max(input_rounds));
    open.clear();
    for (std::size_t i = 0; i < searches.size(); ++i)
        if (searches[i]->needs_whole()) open.push_back(i);
    for (std::size_t left = open.size(); const std::size_t i : open)
        step(i, [&](StagedSearch& search) { search.search_complete(share_of(deadline, left--)); });
    return earlier;
}

TimedResult search(const LoopToCheck& loop, const CheckOptions& options) {
    const Observe nothing = std::identity{};
    StagedSearch search(loop, nothing, loop.network, options);
    run({&search}, options.limits);
    return search.result();
}

/// Converts the results of the engine to a report. If a run does not replay, it is a failure and is not reported.
class Reporter {
public:
    Reporter(const LoopToCheck& loop, const CheckOptions& options)
        : loop_(loop),
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
            if (verdict.outcome == Outcome::Holds && !options_.witnesses) verdict.run.reset();
            if (verdict.run && !replays(*verdict.run, fmt::format("the trace of `{}`", verdict.property)))
                verdict.run.reset();
            if (verdict.run && verdict.outcome == Outcome::Violated)
                violations.push_back({report.answers.size(), *verdict.run});
            report.answers.push_back(result_of(network_, std::move(verdict), detail_));
        }
        if (!loop_.disabled_corrections && !is_watched()) {
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
    /// Returns a function that decides properties of a similar network; empty if that may take long.
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

    /// True if the network contains an observer, whose property is not a property of the loop.
    bool is_watched() const {
        return std::ranges::find(network_.processes, Network::ProcessKind::Observer, &Network::Process::kind) !=
               network_.processes.end();
    }

    void name_race(ModelErrorTrace& breakdown, const Run& run) const {
        const std::optional<ContradictoryActions> found = clash(project(network_, run), loop_.charts);
        if (!found) return;
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

    const LoopToCheck loop_;
    const Network& network_;
    const CheckOptions& options_;
    Detail detail_;
    std::vector<std::string> failures_ = {};
};

}  // namespace

LoopToCheck loop_to_check(const Model& model, Id<ClosedLoop> loop, const Network& network) {
    return {network, charts_of(model, model.loops[loop]), false,
            [&model, loop] { return finest_duration(model, model.loops[loop]); }};
}

namespace {

/// The check of a property with an observer, in the loop with only that observer.
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
        const LoopToCheck watched_loop{network_, loop_.charts, loop_.disabled_corrections, loop_.finest};
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

/// Adds the results of another search. `earlier` is the number of states that previous searches explored.
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

/// Sorts the results in the order of the loop's properties; all other results follow.
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

}  // namespace

Report check(const LoopToCheck& loop, const CheckOptions& options) {
    const std::vector<Id<Property>> by_observers = watched(loop.network);
    if (by_observers.empty()) return Reporter(loop, options).report(search(loop, options));

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
    if (only_watched) {  // the timelock is only a note in this case and does not justify a search of the complete loop
        rest.properties = {"no_timelock"};
        rest.limits.states =
            std::min(rest.limits.states.value_or(LocalizationLimits{}.whole), LocalizationLimits{}.whole);
    }
    const LoopToCheck unwatched{alone, loop.charts, loop.disabled_corrections, loop.finest};
    const Observe nothing = std::identity{};
    StagedSearch search(unwatched, nothing, alone, rest);
    std::deque<StagedSearch*> searches{&search};
    std::deque<WatchedCheck> checks;
    for (const Id<Property> id : by_observers)
        if (is_requested(id)) searches.push_back(&checks.emplace_back(loop, id, options).search());
    const std::vector<std::uint64_t> earlier = run(searches, options.limits);
    Report report{alone.name, settings_of(alone, "timed")};
    for (std::size_t i = 0; i < checks.size(); ++i) take(checks[i].report(), earlier[i + 1], report);
    Report made = Reporter(unwatched, rest).report(search.result());
    report.profile = std::move(made.profile);
    take(std::move(made), earlier[0], report);
    put_in_order(loop.network, report.answers);
    return report;
}

std::optional<Report> check(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how,
                            const CheckOptions& options, Diagnostics& diagnostics) {
    const auto network = network_of(model, loop, how, diagnostics);
    if (!network || !all_known(options.properties, property_names(*network), diagnostics)) return {};
    return check(loop_to_check(model, loop, *network), options);
}

}  // namespace grafverif
