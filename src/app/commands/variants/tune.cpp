// SPDX-License-Identifier: MIT
// `tune`: decides for which values of constants of a closed loop its properties hold.
#include "pipeline/variants/tune.hpp"

#include <ostream>
#include <sstream>
#include <utility>

#include "app/commands.hpp"
#include "app/outputs.hpp"
#include "app/reports.hpp"
#include "app/stop_text.hpp"
#include "app/system/watchdog.hpp"
#include "check/shares.hpp"
#include "pipeline/variants/tune_points.hpp"
#include "pipeline/variants/tune_ranges.hpp"
#include "report/charts/tuning.hpp"

namespace grafverif::app {

namespace {

ExitCode exit_code(const Tuning& tuning) {
    if (!tuning.failures.empty()) return ExitCode::Failure;
    bool open = false, unexpected = tuning.model_error;
    for (const Tuning::Row& row : tuning.rows)
        for (const PointVerdict& verdict : row.verdicts) {
            if (verdict.outcome == Outcome::Unknown) open = open || row.declared;
            else unexpected = unexpected || verdict.outcome != row.expected();
        }
    return unexpected ? ExitCode::Verdict : open ? ExitCode::Unknown : ExitCode::Done;
}

/// For each property: maximum number of points whose runs are in the HTML report.
constexpr std::size_t most_shown_runs = 24;

/// Returns the HTML report. For each point that has runs, the model is read again.
std::string page_about(const Model& model, Id<ClosedLoop> loop, Tuning&& tuning, const CommandContext& job) {
    PageContent content = drawn_content(model, job.sources, loop);
    content.report.model = tuning.model;
    content.report.settings = tuning.settings;
    for (const Tuning::Row& row : tuning.rows)
        for (const auto& [point, _] : row.runs) {
            if (content.point_models.contains(point)) continue;
            Sources sources;
            Diagnostics diagnostics;
            if (auto read = model_at(tuning, point, *job.sources.ids().begin(), job.sources, read_options(job.options),
                                     sources, diagnostics))
                content.point_models.emplace(point, std::move(*read));
        }
    content.tuning = std::move(tuning);
    return report_page(std::move(content), job);
}

}  // namespace

ExitCode tune(CommandContext& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto loop = model ? chosen_loop(*model, job) : std::nullopt;
    if (!loop) return ExitCode::Input;
    const Options& options = job.options;
    TuneRequest request{
        .constants = constants_over(options.tune.ranges, model->loops[*loop], options.constants, job.diagnostics),
        .properties = options.properties,
        .how = model_options(options),
        .read = read_options(options),
        .jobs = options.jobs,
        .runs = options.page ? most_shown_runs : 0,
        .every_point = options.tune.every_point};
    if (request.constants.empty()) return ExitCode::Input;
    const ResourceLimits bounds(options, streams);
    request.limits = bounds.limits();
    auto found = tuned(*model, *loop, *job.sources.ids().begin(), job.sources, request, job.diagnostics);
    if (!found) return ExitCode::Input;
    const bool stopped = bounds.interrupted() || is_over(request.limits.deadline);
    if (stopped) found->reasons.front() = with_who_stopped("stopped", bounds.interrupted(), options);
    found->reasons.front() = with_remedy(found->reasons.front(), options);
    print_failures(found->failures, streams);
    work_is_done();
    std::ostringstream out;
    if (options.format == Format::Json) out << tuning_json(*found, job.sources) << '\n';
    else print_tuning(*found, out);
    deliver(std::move(out).str(), job, streams);
    const ExitCode code = exit_code(*found);
    if (!options.page) return code;
    const std::string page = page_about(*model, *loop, std::move(*found), job);
    return write_outputs({{*options.page, page}}, job, streams) ? code : ExitCode::Input;
}

CliCommand tune_usage() {
    return {
        "tune",
        "FILE",
        1,
        1,
        "decide for which values of constants the properties hold",
        "Decides the properties of a closed loop in FILE for every combination (point) of the values that --over\n"
        "states for constants of the loop. Prints for which values each property holds, and by how much each current\n"
        "value can change before the verdict changes. The verdict at a point is that of `check` with these values.\n"
        "Most points need no separate check: their verdicts follow from a network with more behaviour, or from a\n"
        "trace that is possible at several points (docs/how-to/tune.md). --report writes the results as an HTML "
        "report,\n"
        "with a map for one or two constants and a player for runs that violate a property.\n"
        "Exit code 0: each property has its expected verdict at each point; 1: a property has an unexpected verdict\n"
        "at some point; 3: some verdicts are unknown (--timeout, Ctrl-C).",
        {"grafverif tune station.grafcet --over TEST=1s..20s",
         "grafverif tune station.grafcet --over TEST=500ms..4s:500ms --over N=1..8 --property P15 --format json"},
        {OptionGroup::Within, OptionGroup::Output, OptionGroup::Loop, OptionGroup::Constants, OptionGroup::Mode,
         OptionGroup::Grain, OptionGroup::Tuning, OptionGroup::Format}};
}

}  // namespace grafverif::app
