// SPDX-License-Identifier: MIT
// The embedded timed engine at work.
#include <fmt/format.h>

#include <utility>

#include "check/cells/cells.hpp"
#include "check/timed/timed.hpp"
#include "pipeline/check.hpp"
#include "pipeline/explain.hpp"
#include "pipeline/models.hpp"
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
    return fmt::format("{} states, {:.2f} million/s, {} to go on from, {} MiB, {:.0f} s", grouped(now.states), rate,
                       grouped(now.queue), now.bytes >> 20U, now.seconds);
}

TimedResult search(const Network& network, const CheckOptions& options) {
    TimedOptions timed;
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
    return options.whole ? check_timed(network, timed) : check_timed_by_cells(network, timed);
}

/// Turns what the engine found into a report; runs that do not replay are failures and are not told.
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
            if (!replays(error.run, fmt::format("the way to `{}`", word(error.kind)))) error.run = {};
            report.breakdowns.push_back(breakdown_of(network_, error, detail_));
            if (error.kind == ModelError::Kind::ActionRace) name_race(report.breakdowns.back(), error.run);
        }
        std::vector<Violation> violations;
        for (Verdict& verdict : result.verdicts) {
            if (verdict.outcome == Outcome::Holds && !options_.witnesses) verdict.run.reset();
            if (verdict.run && !replays(*verdict.run, fmt::format("the trace of `{}`", verdict.property)))
                verdict.run.reset();
            if (verdict.run && verdict.outcome == Outcome::Violated)
                violations.push_back({report.answers.size(), *verdict.run});
            report.answers.push_back(answer_of(network_, std::move(verdict), detail_));
        }
        if (!loop_.cures_left_out) explain(network_, violations, again(result), report);
        report.profile = std::move(result.profile);
        if (report.profile && loop_.finest) report.profile->finest = loop_.finest();
        report.failures = std::move(failures_);
        return report;
    }

private:
    /// Decides some properties of a network like ours; nothing where that may take long.
    Search again(const TimedResult& result) const {
        if (result.states >= many_states) return {};
        return [this](const Network& network, std::vector<std::string> names) {
            CheckOptions options = options_;
            options.properties = std::move(names);
            options.profile = false;
            return search(network, options).verdicts;
        };
    }

    void name_race(Breakdown& breakdown, const Run& run) const {
        const std::optional<Clash> found = clash(project(network_, run), loop_.charts);
        if (!found) return;
        const std::string what = found->variable.empty()
                                     ? "forcing orders contradict each other"
                                     : fmt::format("two stored actions give `{}` different values", found->variable);
        breakdown.message = fmt::format("{}, in an evolution of `{}`", what, found->controller);
    }

    bool replays(const Run& run, const std::string& what) {
        if (loop_.cures_left_out) return true;
        const std::optional<Disagreement> found = disagreement(project(network_, run), loop_.charts);
        if (found) failures_.push_back(replay_failure(what, *found));
        return !found;
    }

    const LoopToCheck& loop_;
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

Report check(const LoopToCheck& loop, const CheckOptions& options) {
    return Reporter(loop, options).report(search(loop.network, options));
}

std::optional<Report> check(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how,
                            const CheckOptions& options, Diagnostics& diagnostics) {
    const auto network = network_of(model, loop, how, diagnostics);
    if (!network || !all_known(options.properties, property_names(*network), diagnostics)) return {};
    return check(loop_to_check(model, loop, *network), options);
}

}  // namespace grafverif
