// SPDX-License-Identifier: MIT
// `faults`: decides which combinations of faults of a closed loop violate its properties.
#include "pipeline/variants/faults.hpp"

#include <algorithm>
#include <ostream>
#include <sstream>
#include <utility>

#include "app/commands.hpp"
#include "app/outputs.hpp"
#include "app/reports.hpp"
#include "app/stop_text.hpp"
#include "app/system/watchdog.hpp"
#include "check/shares.hpp"
#include "report/charts/faults.hpp"

namespace grafverif::app {

namespace {

/// Sets the reason of each combination that was not checked.
void name_reasons(FaultAnalysis& analysis, const std::string& reason) {
    for (FaultAnalysis::Row& row : analysis.rows)
        for (FaultAnalysis::Open& open : row.open)
            if (open.reason.empty()) open.reason = reason;
}

ExitCode exit_code(const FaultAnalysis& analysis) {
    if (!analysis.failures.empty()) return ExitCode::Failure;
    if (!analysis.errors.empty()) return ExitCode::Verdict;
    const auto& rows = analysis.rows;
    if (std::ranges::any_of(rows, [](const FaultAnalysis::Row& row) {
            return !row.minimal.empty() || (row.without_faults == Outcome::Violated && !row.expected_violated);
        }))
        return ExitCode::Verdict;
    const bool open = std::ranges::any_of(rows, [](const FaultAnalysis::Row& row) {
        return row.without_faults == Outcome::Unknown || !row.open.empty();
    });
    return open ? ExitCode::Unknown : ExitCode::Done;
}

}  // namespace

ExitCode faults(CommandContext& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto loop = model ? chosen_loop(*model, job) : std::nullopt;
    if (!loop || !faults_can_be_combined(model->loops[*loop], job.options.faults.order, job.diagnostics))
        return ExitCode::Input;
    const Options& options = job.options;
    FaultsRequest request{.order = options.faults.order,
                          .properties = options.properties,
                          .how = model_options(options),
                          .jobs = options.jobs};
    const ResourceLimits bounds(options, streams);
    request.limits = bounds.limits();
    auto found = analysed_faults(*model, *loop, request, job.diagnostics);
    if (!found) return ExitCode::Input;
    name_reasons(*found, with_remedy(with_who_stopped("stopped", bounds.interrupted(), options), options));
    print_failures(found->failures, streams);
    work_is_done();
    std::ostringstream out;
    if (options.format == Format::Json) out << faults_json(*found, job.sources) << '\n';
    else print_faults(*found, options.verbose, out);
    deliver(std::move(out).str(), job, streams);
    const ExitCode code = exit_code(*found);
    std::vector<OutputFile> files;
    if (options.open_psa) files.push_back({*options.open_psa, open_psa_of(*found)});
    if (options.page) {
        PageContent content = drawn_content(*model, job.sources, *loop);
        content.report.model = found->model;
        content.report.settings = found->settings;
        content.faults = std::move(*found);
        files.push_back({*options.page, report_page(std::move(content), job)});
    }
    return files.empty() || write_outputs(files, job, streams) ? code : ExitCode::Input;
}

CliCommand faults_usage() {
    return {
        "faults",
        "FILE",
        1,
        1,
        "find combinations of faults that lead to violations of properties",
        "Decides for each property of a closed loop in FILE which combinations of its declared faults lead to a\n"
        "violation. A fault makes an instance behave as another component, from power-on or from any later time.\n"
        "Prints the minimal combinations of at most --order faults, each with a run. Also prints the effects of each\n"
        "fault, and the steps and outputs that show the fault (docs/how-to/faults.md). Properties that are violated\n"
        "without faults are not analysed. --report writes these results as an HTML report with a player for runs.\n"
        "Exit code 0: no combination leads to a violation; 1: some combination does, or causes a model error,\n"
        "or a property is violated without faults and not declared as `expected violated`; 3: some verdicts are\n"
        "unknown (--timeout, Ctrl-C).",
        {"grafverif faults station.grafcet", "grafverif faults station.grafcet --order 2 --openpsa tree.xml",
         "grafverif faults station.grafcet --order 2 --property P15 --format json",
         "grafverif faults station.grafcet --order 2 --report faults.html"},
        {OptionGroup::Within, OptionGroup::Output, OptionGroup::Loop, OptionGroup::Constants, OptionGroup::Mode,
         OptionGroup::Grain, OptionGroup::Faults, OptionGroup::Verbose, OptionGroup::Format}};
}

}  // namespace grafverif::app
