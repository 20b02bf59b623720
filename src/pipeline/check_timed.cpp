// SPDX-License-Identifier: MIT
// Checks by the embedded timed engine.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <iterator>
#include <utility>

#include "check/cells/cells.hpp"
#include "check/inputs/inputs.hpp"
#include "check/parts/parts.hpp"
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

/// `1,234,567`
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

/// A bounded search of observe(loop), then until `deadline` input abstractions for the properties that it leaves open.
TimedResult search_first(const Network& loop, const Observe& observe, const TimedOptions& options,
                         const WholeSearch& search, const Deadline& deadline) {
    TimedResult result = search(observe(loop), options);
    TimedOptions abstract = options;
    abstract.max_states = TimedOptions{}.max_states;
    abstract.deadline = deadline;
    decide_by_inputs(loop, observe, abstract, result);
    return result;
}

bool has_open(const TimedResult& result) {
    return std::ranges::any_of(result.verdicts,
                               [](const Verdict& verdict) { return verdict.obstacle == Obstacle::Bound; });
}

/// `complete`, with the verdicts that abstractions gave before.
TimedResult with_abstracted(TimedResult&& before, TimedResult&& complete) {
    for (std::size_t k = 0; k < complete.verdicts.size(); ++k)
        if (before.verdicts[k].abstraction) complete.verdicts[k] = std::move(before.verdicts[k]);
    return std::move(complete);
}

TimedResult search(const LoopToCheck& loop, const CheckOptions& options) {
    const TimedOptions timed = timed_options(loop, options);
    const CellLimits limits;
    if (options.whole) return check_timed(loop.network, timed);
    // Localization is cheap and scales with the number of fragments, so input abstraction follows it.
    const auto whole = [&](const Network& network, const TimedOptions& of) {
        if (of.max_states <= limits.whole || loop.cures_left_out) return check_timed_by_parts(network, of);
        TimedOptions first = of;
        first.max_states = limits.whole;
        TimedResult found = search_first(network, std::identity{}, first, check_timed_by_parts, most_of(of.deadline));
        return has_open(found) ? with_abstracted(std::move(found), check_timed_by_parts(network, of)) : found;
    };
    return check_timed_by_cells(loop.network, timed, limits, {}, whole);
}

/// Searches for a property with an observer, in two steps. An observer reads the complete loop, so localization does not
/// apply. Timelocks are searched in the loop without the observer.
class WatchedSearch {
public:
    /// `observe` adds the observer of the only property; `network` is that of the loop with it. All outlive the search.
    WatchedSearch(const LoopToCheck& loop, const Observe& observe, const Network& network, const CheckOptions& options)
        : loop_(loop), observe_(observe), network_(network), timed_(timed_options(loop, options)) {
        timed_.timelock = false;
        const CellLimits limits;
        const bool in_two_steps = !options.whole && !loop.cures_left_out && timed_.max_states > limits.whole;
        bound_ = in_two_steps ? limits.whole : timed_.max_states;
    }

    /// A bounded search and input abstractions. True if a verdict is left open that the second step may decide.
    bool begin(const Deadline& deadline) {
        if (bound_ == timed_.max_states) {
            timed_.deadline = deadline;
            result_ = check_timed(network_, timed_);
            return false;
        }
        TimedOptions first = timed_;
        first.max_states = bound_;
        first.many = {};
        first.deadline = most_of(deadline);
        result_ = search_first(expand(loop_.network), observe_, first, check_timed, first.deadline);
        return std::ranges::any_of(result_.verdicts, [&](const Verdict& verdict) {
            const bool is_open = verdict.obstacle == Obstacle::Bound || verdict.obstacle == Obstacle::Stopped;
            return is_open && !is_probe(network_.properties[verdict.about]);
        });
    }

    /// The search of the complete loop.
    void complete(const Deadline& deadline) {
        timed_.deadline = deadline;
        result_ = with_abstracted(std::move(result_), check_timed(network_, timed_));
    }

    std::uint64_t states() const { return result_.states; }
    TimedResult result() { return std::move(result_); }

private:
    const LoopToCheck& loop_;
    const Observe& observe_;
    const Network& network_;
    TimedOptions timed_;
    std::uint64_t bound_ = 0;  // of the first step
    TimedResult result_ = {};
};

/// Converts the results of the engine to a report; runs that do not replay are failures and are not reported.
class Reporter {
public:
    Reporter(const LoopToCheck& loop, const CheckOptions& options)
        : loop_(loop),
          network_(loop.network),
          options_(options),
          detail_(options.every_move ? Detail::Everything : Detail::Chart) {}

    Report report(TimedResult result) {
        Report report{network_.name, basis_of(network_, "timed")};
        for (ModelError& error : result.errors) {
            if (!replays(error.run, fmt::format("the trace to `{}`", word(error.kind)))) error.run = {};
            report.breakdowns.push_back(breakdown_of(network_, error, detail_));
            if (error.kind == ModelError::Kind::ActionRace) name_race(report.breakdowns.back(), error.run);
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
            report.answers.push_back(answer_of(network_, std::move(verdict), detail_));
        }
        if (!loop_.cures_left_out && !is_watched())
            explain(network_, violations, again(result), options_.limits, report);
        report.profile = std::move(result.profile);
        report.failures = std::move(failures_);
        return report;
    }

private:
    /// Decides properties of a similar network; empty if that may take long.
    Search again(const TimedResult& result) const {
        if (result.states >= many_states) return {};
        return [this](const Network& network, std::vector<std::string> names) {
            CheckOptions options = options_;
            options.properties = std::move(names);
            options.profile = false;
            return search({network}, options).verdicts;
        };
    }

    /// True if the network contains an observer; its property is not one of the loop.
    bool is_watched() const {
        return std::ranges::find(network_.processes, Network::ProcessKind::Observer, &Network::Process::kind) !=
               network_.processes.end();
    }

    void name_race(Breakdown& breakdown, const Run& run) const {
        const std::optional<Clash> found = clash(project(network_, run), loop_.charts);
        if (!found) return;
        const std::string what =
            found->variable.empty()
                ? "contradictory forcing orders"
                : fmt::format("two stored actions assign different values to `{}`", found->variable);
        breakdown.message = fmt::format("{}, in an evolution of `{}`", what, found->controller);
    }

    bool replays(const Run& run, const std::string& what) {
        if (loop_.cures_left_out) return true;
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

/// The check of a property with an observer, in the loop with only this observer added.
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

    bool begin(const Deadline& deadline) { return search_.begin(deadline); }
    void complete(const Deadline& deadline) { search_.complete(deadline); }
    std::uint64_t states() const { return search_.states(); }

    Report report() {
        const LoopToCheck watched_loop{network_, loop_.charts, loop_.cures_left_out, loop_.finest};
        Report report = Reporter(watched_loop, own_).report(search_.result());
        const Property& sentence = loop_.network.properties[id_];
        for (Answer& answer : report.answers) {
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
    WatchedSearch search_;
};

/// Adds the results of another search; `earlier`: number of states explored by the searches before.
void take(Report&& found, std::uint64_t earlier, Report& report) {
    for (Answer& answer : found.answers) tell_earlier(answer.verdict, "searches for other properties", earlier);
    std::ranges::move(found.answers, std::back_inserter(report.answers));
    std::ranges::move(found.failures, std::back_inserter(report.failures));
    for (Breakdown& breakdown : found.breakdowns)
        if (std::ranges::find(report.breakdowns, breakdown.message, &Breakdown::message) == report.breakdowns.end())
            report.breakdowns.push_back(std::move(breakdown));
}

/// The states that the longest search of a report explored.
std::uint64_t states_of(const Report& report) {
    std::uint64_t states = 0;
    for (const Answer& answer : report.answers)
        states = std::max<std::uint64_t>(states, std::stoull('0' + answer.verdict.states));
    return states;
}

/// Sorts by the properties of the loop, followed by the others.
void put_in_order(const Network& network, std::vector<Answer>& answers) {
    for (Answer& answer : answers) {
        if (!answer.verdict.declared || !answer.verdict.about.valid()) continue;
        const std::string& name = answer.verdict.property;  // `S.X7` of a property `S`
        for (const Id<Property> id : network.properties.ids())
            if (const std::string& of = network.properties[id].name; name == of || name.starts_with(of + '.'))
                answer.verdict.about = id;
    }
    std::ranges::stable_sort(answers, {}, [](const Answer& answer) { return answer.verdict.about.index; });
}

}  // namespace

Report check(const LoopToCheck& loop, const CheckOptions& options) {
    const std::vector<Id<Property>> by_observers = watched(loop.network);
    if (by_observers.empty()) return Reporter(loop, options).report(search(loop, options));

    const auto is_asked = [&](Id<Property> id) {
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
    if (only_watched) {  // here the timelock is only a note and does not justify a search of the complete loop
        rest.properties = {"no_timelock"};
        rest.limits.states = std::min(rest.limits.states.value_or(CellLimits{}.whole), CellLimits{}.whole);
    }
    std::vector<Id<Property>> asked;
    std::ranges::copy_if(by_observers, std::back_inserter(asked), is_asked);
    // The abstractions of all properties come before the searches of the complete loop.
    const Deadline deadline = options.limits.deadline;
    std::deque<WatchedCheck> checks;
    std::vector<std::uint64_t> earlier(asked.size(), 0);  // states explored before the last search of each
    std::vector<std::size_t> open;
    std::uint64_t states = 0;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        earlier[i] = states;
        if (checks.emplace_back(loop, asked[i], options).begin(share_of(deadline, asked.size() - i + 1)))
            open.push_back(i);
        states += checks[i].states();
    }
    if (!open.empty()) rest.limits.deadline = share_of(deadline, 2);
    const LoopToCheck unwatched{alone, loop.charts, loop.cures_left_out, loop.finest};
    Report made = Reporter(unwatched, rest).report(search(unwatched, rest));
    const std::uint64_t before_rest = std::exchange(states, states + states_of(made));
    for (std::size_t k = 0; k < open.size(); ++k) {
        earlier[open[k]] = states;
        checks[open[k]].complete(share_of(deadline, open.size() - k));
        states += checks[open[k]].states();
    }
    Report report{alone.name, basis_of(alone, "timed")};
    for (std::size_t i = 0; i < checks.size(); ++i) take(checks[i].report(), earlier[i], report);
    report.profile = std::move(made.profile);
    take(std::move(made), before_rest, report);
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
