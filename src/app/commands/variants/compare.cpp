// SPDX-License-Identifier: MIT
// `compare`: checks that two charts or PLC programs have equal outputs for all inputs, and lists the textual
// differences of charts.
#include "pipeline/variants/compare.hpp"

#include <fmt/format.h>

#include <ostream>
#include <sstream>

#include "app/commands.hpp"
#include "app/stop_text.hpp"
#include "app/system/watchdog.hpp"
#include "report/charts/comparison.hpp"
#include "support/messages_choice.hpp"

namespace grafverif::app {

namespace {

/// Returns the initial situations: `3,5` is the situation of both charts; `3,5:W3,W5` gives a
/// separate situation for each chart.
std::array<std::vector<Id<Chart::Step>>, 2> beginnings(const Chart& a, const Chart& b, CommandContext& job) {
    if (!job.options.from_situation) return {};
    const std::string_view requested = *job.options.from_situation;
    const std::size_t colon = requested.find(':');
    const std::string_view of_a = requested.substr(0, colon);
    const std::string_view of_b = colon == std::string_view::npos ? of_a : requested.substr(colon + 1);
    return {named_steps(a, of_a, "--from-situation", job), named_steps(b, of_b, "--from-situation", job)};
}

/// A file to compare, with the model of its charts.
struct ComparedFile {
    std::optional<Model> model = {};
    CompareOperand operand = {};
};

/// Reads a file to compare. `file.operand` contains a pointer into `file`; therefore, `file` must
/// not be moved afterwards. Returns false after an error.
bool read_compared(const std::string& path, CommandContext& job, ComparedFile& file) {
    const auto source = read_source(path, job);
    if (!source) return false;
    if (!job.options.imported_charts && contains_program(*source, job.sources)) {
        file.operand.program = *source;
        return true;
    }
    file.model = read_model(*source, path, job);
    const auto chart = file.model ? chosen_chart(*file.model, job) : std::nullopt;
    if (!chart) return false;
    file.operand.model = &*file.model;
    file.operand.chart = *chart;
    return true;
}

/// Returns false after an error: an option does not apply to the operands, or its value has the wrong form.
bool set_program_options(const CompareOperand& a, const CompareOperand& b, CommandContext& job,
                         ProgramCompareOptions& set) {
    const Options& options = job.options;
    const std::size_t before = job.diagnostics.errors();
    const auto reject = [&](const std::string& problem, std::string_view remedy) {
        job.diagnostics.add(messages::not_comparable({}, problem, remedy));
    };
    const bool programs = a.program.valid() && b.program.valid(), program = a.program.valid() || b.program.valid();
    for (const auto& [given, option] :
         {std::pair(options.mode.has_value(), "--mode"), std::pair(options.all_modes, "--all-modes"),
          std::pair(options.chart.has_value() || options.other_chart.has_value(), "--chart")})
        if (given && programs)
            reject(fmt::format("`{}` applies to charts, but both files are programs", option),
                   "remove it, or pass `--imported-charts`");
    if (options.from_situation && program)
        reject("`--from-situation` applies to charts, but a file is a program",
               "remove it, or pass `--imported-charts`");
    if (options.settled && !program)
        reject("`--compare settled` applies to programs, but both files are charts", "remove it");
    if (options.settled && (options.all_modes || options.mode == ExecutionMode::EveryCycle))
        reject("`--compare settled` requires the mode `stability-search`", "remove `--mode` or `--all-modes`");
    set.settles = options.settled;
    set.ignored = options.ignored_outputs;
    const auto read_pair = [&](const std::string& text, std::string_view option, std::string_view form) {
        const std::size_t sign = text.find('=');
        std::optional<std::pair<std::string, std::string>> pair;
        if (sign == std::string::npos || sign == 0 || sign + 1 == text.size())
            reject(fmt::format("invalid value `{}` of `{}`", text, option), fmt::format("use {}", form));
        else pair.emplace(text.substr(0, sign), text.substr(sign + 1));
        return pair;
    };
    for (const std::string& renaming : options.renamings)
        if (const auto pair = read_pair(renaming, "--map", "NAME=NAME")) set.map.push_back(*pair);
    if (const std::string& stop = options.stop_output; stop.find('=') != std::string::npos) {
        if (const auto pair = read_pair(stop, "--stop-output", "NAME or NAME=NAME"))
            set.stop = {pair->first, pair->second};
    } else if (!stop.empty()) set.stop = {stop};
    return job.diagnostics.errors() == before;
}

/// Returns the requested modes. An empty mode represents the mode of the loops of FILE that contain the chart.
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

ExitCode exit_code(const Comparison& comparison) {
    if (!comparison.failures.empty()) return ExitCode::Failure;
    if (comparison.faulty) return ExitCode::Verdict;
    switch (comparison.outcome) {
    case Comparison::Outcome::Equal: return ExitCode::Done;
    case Comparison::Outcome::Different: return ExitCode::Verdict;
    case Comparison::Outcome::Unknown: return ExitCode::Unknown;
    }
    return ExitCode::Failure;
}

ExitCode compare(CommandContext& job, const Streams& streams) {
    ComparedFile a, b;
    if (!read_compared(job.options.operands[0], job, a)) return ExitCode::Input;
    const std::optional<std::string> chart = job.options.chart;
    if (job.options.other_chart) job.options.chart = job.options.other_chart;
    if (!read_compared(job.options.operands[1], job, b)) return ExitCode::Input;
    job.options.chart = chart;
    ProgramCompareOptions of_programs;
    if (!set_program_options(a.operand, b.operand, job, of_programs)) return ExitCode::Input;
    const ResourceLimits bounds(job.options, streams);
    CompareOptions options{
        .mode = job.options.mode, .resolution_ms = job.options.resolution_ms, .limits = bounds.limits()};
    if (job.options.from_situation)
        options.from = beginnings(a.model->charts[a.operand.chart], b.model->charts[b.operand.chart], job);
    if (job.diagnostics.has_errors()) return ExitCode::Input;
    std::vector<Comparison> all;
    for (const std::optional<ExecutionMode> mode : requested_modes(job.options)) {
        options.mode = mode;
        auto found = grafverif::compare(a.operand, b.operand, options, of_programs, job.sources, job.diagnostics);
        if (!found) return ExitCode::Input;
        found->reason = with_who_stopped(std::move(found->reason), bounds.interrupted(), job.options);
        all.push_back(std::move(*found));
    }
    std::ostringstream out;
    const bool to_file = job.options.output && *job.options.output != "-";
    print(all, job.options, colour_on(to_file ? Screen{} : streams.out_screen, job.options), out);
    work_is_done();
    if (job.options.output) deliver(std::move(out).str(), job, streams);
    else streams.out << std::move(out).str();  // the printed text contains no control characters except colour codes
    ExitCode code = ExitCode::Done;
    for (const Comparison& found : all) {
        print_failures(found.failures, streams);
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
        "prove two charts or programs equivalent, or find inputs that distinguish them",
        "Compares a chart of FILE (a) with a chart of OTHER (b) that has the same inputs and outputs. Equivalent "
        "charts\n"
        "write the same outputs in every scan, for all inputs and all times between scans, or stop in the same scan\n"
        "(race, value out of range, total instability). The result is a proof, or a distinguishing sequence of scans,\n"
        "which is replayed under the rules of IEC 60848, and the differences of the two texts. FILE and OTHER can have "
        "any\n"
        "supported format. The default mode is the mode of the closed loop of FILE that contains this chart, or\n"
        "stability-search if there is none. The constraints of both charts are assumed.\n"
        "\n"
        "Structured Text, textual Sequential Function Charts and PLCopen XML are compared as PLC programs, with a "
        "chart\n"
        "or with another program. A difference is then replayed by the program interpreter. A run-time fault of a\n"
        "program is reported as a model error. Exit code 1: different, or a model error; 3: inconclusive (--timeout,\n"
        "--max-memory, Ctrl-C).",
        {"grafverif compare station.grafcet station.xml",
         "grafverif compare old.grafcet new.grafcet --mode every-cycle", "grafverif compare version1.st version2.st",
         "grafverif compare station.grafcet station.st --stop-output FAULT",
         "grafverif compare old.grafcet new.grafcet --from-situation 3,5 --format json"},
        {OptionGroup::Within, OptionGroup::Output, OptionGroup::Chart, OptionGroup::Compare, OptionGroup::Mode,
         OptionGroup::Format}};
}

}  // namespace grafverif::app
