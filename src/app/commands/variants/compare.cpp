// SPDX-License-Identifier: MIT
// `compare`: checks that two charts have equal outputs for all inputs, and lists other textual differences.
#include <ostream>
#include <sstream>

#include "app/commands.hpp"
#include "app/stop_text.hpp"
#include "app/system/watchdog.hpp"
#include "report/charts/comparison.hpp"

namespace grafverif::app {

namespace {

/// Returns the initial situations: `3,5` applies to both charts, `3,5:W3,W5` to each chart separately.
std::array<std::vector<Id<Chart::Step>>, 2> beginnings(const Chart& a, const Chart& b, CommandContext& job) {
    if (!job.options.from_situation) return {};
    const std::string_view requested = *job.options.from_situation;
    const std::size_t colon = requested.find(':');
    const std::string_view of_a = requested.substr(0, colon);
    const std::string_view of_b = colon == std::string_view::npos ? of_a : requested.substr(colon + 1);
    return {named_steps(a, of_a, "--from-situation", job), named_steps(b, of_b, "--from-situation", job)};
}

ExitCode exit_code(const Comparison& comparison) {
    if (!comparison.failures.empty()) return ExitCode::Failure;
    switch (comparison.outcome) {
    case Comparison::Outcome::Equal: return ExitCode::Done;
    case Comparison::Outcome::Different: return ExitCode::Verdict;
    case Comparison::Outcome::Unknown: return ExitCode::Unknown;
    }
    return ExitCode::Failure;
}

/// Returns the requested modes. An empty mode is the mode of the loop in FILE.
std::vector<std::optional<ExecutionMode>> requested_modes(const Options& options) {
    if (!options.all_modes) return {options.mode};
    return {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle};
}

/// Prints one object, or a list with `--all-modes`. In text output, textual differences are printed once, at the end.
void print(const std::vector<Comparison>& all, const Options& options, Colour colour, std::ostream& out) {
    const bool json = options.format == Format::Json, list = options.all_modes;
    if (json && list) out << "[\n";
    for (std::size_t k = 0; k < all.size(); ++k) {
        const bool last = k + 1 == all.size();
        if (json) out << comparison_json(all[k]) << (last ? "\n" : ",\n");
        else if (last) print_comparison(all[k], colour, out);
        else print_result(all[k], colour, out);
    }
    if (json && list) out << "]\n";
}

}  // namespace

ExitCode compare(CommandContext& job, const Streams& streams) {
    const auto a = read_model(job.options.operands[0], job);
    const auto of_a = a ? chosen_chart(*a, job) : std::nullopt;
    if (!of_a) return ExitCode::Input;
    const auto b = read_model(job.options.operands[1], job);
    if (job.options.other_chart) job.options.chart = job.options.other_chart;
    const auto of_b = b ? chosen_chart(*b, job) : std::nullopt;
    if (!of_b) return ExitCode::Input;
    const ResourceLimits bounds(job.options, streams);
    CompareOptions options{.mode = job.options.mode,
                           .resolution_ms = job.options.resolution_ms,
                           .from = beginnings(a->charts[*of_a], b->charts[*of_b], job),
                           .limits = bounds.limits()};
    if (job.diagnostics.has_errors()) return ExitCode::Input;
    std::vector<Comparison> all;
    for (const std::optional<ExecutionMode> mode : requested_modes(job.options)) {
        options.mode = mode;
        auto found = compare(*a, *of_a, *b, *of_b, options, job.diagnostics);
        if (!found) return ExitCode::Input;
        found->reason = with_who_stopped(std::move(found->reason), bounds.interrupted(), job.options);
        all.push_back(std::move(*found));
    }
    std::ostringstream out;
    const bool to_file = job.options.output && *job.options.output != "-";
    print(all, job.options, colour_on(to_file ? Screen{} : streams.out_screen, job.options), out);
    work_is_done();
    if (job.options.output) deliver(std::move(out).str(), job, streams);
    else streams.out << std::move(out).str();  // text contains no control characters, except for colour codes
    ExitCode code = ExitCode::Done;
    for (const Comparison& found : all) {
        for (const std::string& failure : found.failures)
            streams.err << "grafverif: internal error: " << failure << '\n';
        code = worse(code, exit_code(found));
    }
    return code;
}

CliCommand compare_usage() {
    return {
        "compare",
        "FILE OTHER",
        2,
        2,
        "prove two charts equivalent, or find inputs that distinguish them",
        "Compares a chart of FILE (a) with a chart of OTHER (b) that has the same inputs and outputs. Equivalent "
        "charts\n"
        "write the same outputs in every scan, for all inputs and all times between scans, or stop in the same scan\n"
        "(race, value out of range, total instability). The result is a proof, or a distinguishing sequence of scans,\n"
        "which is replayed on the rules of IEC 60848, and the differences of the two texts. FILE and OTHER can have "
        "any\n"
        "supported format. The default mode is the mode of the closed loop of FILE that contains this chart, or\n"
        "stability-search if there is none. The constraints of both charts are assumed. Exit code 1: different; 3:\n"
        "inconclusive (--timeout, --max-memory, Ctrl-C).",
        {"grafverif compare station.grafcet station.xml",
         "grafverif compare old.grafcet new.grafcet --mode every-cycle",
         "grafverif compare old.grafcet new.grafcet --from-situation 3,5 --format json"},
        {OptionGroup::Output, OptionGroup::Chart, OptionGroup::Compare, OptionGroup::Mode, OptionGroup::Format}};
}

}  // namespace grafverif::app
