// SPDX-License-Identifier: MIT
// The embedded timed engine, run for `check`. No trace is shown that does not replay on the rules.
#include <fmt/format.h>

#include <ostream>

#include "app/engines.hpp"
#include "app/progress_line.hpp"
#include "app/traces.hpp"
#include "run/project.hpp"
#include "check/timed/timed.hpp"

namespace grafverif::app {

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

TimedResult search(const Network& network, const Options& options, const Streams& streams, const Interrupt& interrupt) {
    ProgressLine line(streams.err, streams.err_is_terminal && !options.quiet);
    TimedOptions timed;
    timed.properties = options.properties;
    timed.max_states = options.max_states.value_or(timed.max_states);
    timed.max_memory = options.max_memory.value_or(timed.max_memory);
    timed.deadline = options.deadline;
    timed.stop = &interrupt.asked();
    timed.progress = [&line](const TimedProgress& now) { line.show([&] { return progress_text(now); }); };
    return check_timed(network, timed);
}

/// Turns what the engine found into a report; runs that do not replay are failures and are not told.
class Reporter {
public:
    Reporter(const Network& network, std::vector<const Chart*> charts, const Options& options)
        : network_(network),
          charts_(std::move(charts)),
          detail_(options.verbose ? Detail::Everything : Detail::Chart),
          cures_left_out_(!options.cures_left_out.empty()),
          witnesses_(options.verbose || options.format == Format::Json || options.trace_vcd || options.trace_svg) {}

    Report report(TimedResult result) {
        Report report{network_.name, basis_of(network_, "timed"), {}, {}};
        for (ModelError& error : result.errors) {
            if (!replays(error.run, fmt::format("the way to `{}`", word(error.kind)))) error.run = {};
            report.breakdowns.push_back(breakdown_of(network_, error, detail_));
            if (error.kind == ModelError::Kind::ActionRace) name_race(report.breakdowns.back(), error.run);
        }
        for (Verdict& verdict : result.verdicts) {
            if (verdict.outcome == Outcome::Holds && !witnesses_) verdict.run.reset();
            if (verdict.run && !replays(*verdict.run, fmt::format("the trace of `{}`", verdict.property)))
                verdict.run.reset();
            report.answers.push_back(answer_of(network_, std::move(verdict), detail_));
        }
        return report;
    }

    std::vector<std::string> failures() && { return std::move(failures_); }

private:
    void name_race(Breakdown& breakdown, const Run& run) const {
        const std::optional<Clash> found = clash(project(network_, run), charts_);
        if (!found) return;
        const std::string what = found->variable.empty()
                                     ? "forcing orders contradict each other"
                                     : fmt::format("two stored actions give `{}` different values", found->variable);
        breakdown.message = fmt::format("{}, in an evolution of `{}`", what, found->controller);
    }

    bool replays(const Run& run, const std::string& what) {
        if (cures_left_out_) return true;   // not the runs of a chart: that is their point
        const std::optional<Disagreement> found = disagreement(project(network_, run), charts_);
        if (found) failures_.push_back(replay_failure(what, *found));
        return !found;
    }

    const Network& network_;
    std::vector<const Chart*> charts_;
    Detail detail_;
    bool cures_left_out_;
    bool witnesses_;  ///< whether anybody looks at them
    std::vector<std::string> failures_ = {};
};

}  // namespace

Findings check_embedded(const LoopToCheck& loop, const Options& options, const Streams& streams, const Interrupt& interrupt) {
    TimedResult result = search(loop.network, options, streams, interrupt);
    Reporter reporter(loop.network, loop.charts, options);
    Report report = reporter.report(std::move(result));
    return {std::move(report), std::move(reporter).failures()};
}

}  // namespace grafverif::app
