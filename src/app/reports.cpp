// SPDX-License-Identifier: MIT
#include "app/reports.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <string_view>

#include "app/outputs.hpp"
#include "app/stop_text.hpp"
#include "pipeline/files.hpp"
#include "report/json.hpp"
#include "report/junit.hpp"

namespace grafverif::app {

namespace {

namespace fs = std::filesystem;

/// True if the last line of `text` has the form of the last line of `analyse`, such as `press: 1 error, 2 notes`.
bool ends_in_tally(std::string_view text) {
    if (!text.ends_with('\n')) return false;
    text.remove_suffix(1);
    const std::string_view line = text.substr(text.rfind('\n') + 1);
    const std::size_t colon = line.find(": ");
    if (colon == std::string_view::npos) return false;
    const std::string_view rest = line.substr(colon + 2);
    constexpr std::array<std::string_view, 7> endings = {"error", "errors", "warning", "warnings",
                                                         "note",  "notes",  "accepted"};
    return rest == "no findings" ||
           (rest.find_first_not_of("0123456789") == rest.find(' ') &&
            std::ranges::any_of(endings, [&](std::string_view ending) { return rest.ends_with(ending); }));
}

/// True if `text` is the beginning of a report of this program.
bool is_report(std::string_view text) {
    constexpr std::string_view page = "<!DOCTYPE html>\n", generator = "<meta name=\"generator\" content=\"grafverif ";
    if (text.starts_with(page)) return text.substr(0, 2048).find(generator) != std::string_view::npos;
    constexpr std::array<std::string_view, 5> beginnings = {"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>",
                                                            "{\n  \"$schema\": \"https://json.schemastore.org/sarif",
                                                            "$comment ", "<svg ", "{\n  \"chart\": "};
    return ends_in_tally(text) ||
           std::ranges::any_of(beginnings, [&](std::string_view each) { return text.starts_with(each); });
}

/// True if the file at `path` may be replaced before the inputs of the command are known.
bool is_replaceable(const std::string& path, const CommandContext& job) {
    const std::string identity = path == "-" || own_descriptor(path) ? "" : file_identity(path);
    if (identity.empty()) return false;
    std::vector<std::string> named = job.options.operands;
    for (const NamedPath& one : named_paths(job.options))
        if (one.use == PathUse::Read || one.use == PathUse::Updated) named.push_back(one.path);
    for (const std::string& input : named)
        if (file_identity(input) == identity) return false;
    std::error_code failure;
    const fs::path folder = fs::path(path).parent_path();
    if (!fs::exists(path, failure)) return folder.empty() || job.options.create || fs::exists(folder, failure);
    std::string why;
    const auto content = content_of_file(path, why);
    return content && is_report(*content);
}

std::string sarif_text(const SarifLog& log) {
    std::ostringstream text;
    print_sarif(log, GRAFVERIF_VERSION, text);
    return std::move(text).str();
}

/// Returns the displayed name of the file that a run concerns.
std::string file_of(const CommandContext& job) {
    return job.options.operands.empty() ? "" : job.options.operands.front();
}

}  // namespace

std::string report_page(PageContent content, const CommandContext& job) {
    content.file = job.options.operands[0];
    content.version = GRAFVERIF_VERSION;
    content.date = job.options.date;
    content.requested = job.options.properties;
    std::vector<Diagnostic> warnings;
    for (const Diagnostic& diagnostic : job.diagnostics.all())
        if (diagnostic.severity != Severity::Error) warnings.push_back(diagnostic);
    std::ostringstream text;
    render_text(warnings, job.sources, Colour::Plain, text);
    content.warnings = std::move(text).str();
    return page_of(content);
}

std::optional<PageContent> verdict_content(const Model& model, const Decided& decided, Id<Chart> chart,
                                           CommandContext& job, const ResourceLimits& bounds) {
    auto content =
        page_content(model, job.sources, decided.loop, chart, job.options.mode, bounds.limits(), job.diagnostics);
    if (!content) return {};
    for (ChartContent& one : content->charts)
        one.analysis.obstacle = with_who_stopped(std::move(one.analysis.obstacle), bounds.interrupted(), job.options);
    if (decided.certificate) content->certificate = decided.certificate->summary;
    return content;
}

bool has_failed(const PageContent& content) {
    return std::ranges::any_of(content.charts,
                               [](const ChartContent& chart) { return !chart.analysis.failures.empty(); });
}

void begin_reports(bool output, CommandContext& job) {
    const Options& options = job.options;
    std::vector<std::optional<std::string>> others = {options.trace_vcd, options.trace_svg, options.page};
    if (output) others.push_back(options.output);
    for (const std::optional<std::string>& path : others)
        if (path && fs::exists(*path) && is_replaceable(*path, job)) fs::remove(fs::canonical(*path));

    constexpr std::string_view unfinished = "the command did not complete";
    std::vector<OutputFile> files;
    if (options.junit && is_replaceable(*options.junit, job))
        files.push_back({*options.junit, junit_document(junit_suite(file_of(job), "unfinished", unfinished))});
    if (options.sarif && is_replaceable(*options.sarif, job)) {
        SarifLog log{.successful = false};
        log.notifications.push_back({{"level", "error"}, {"message", {{"text", unfinished}}}});
        files.push_back({*options.sarif, sarif_text(log)});
    }
    write_files(files);
}

void note(const Decided& decided, const Model& model, CommandContext& job) {
    const ReportSource written{job.sources, model, decided.loop, decided.chart};
    if (job.options.junit) job.reports->suites += junit_suite(decided.report, written);
    if (job.options.sarif) add_report(decided.report, written, job.reports->sarif);
}

void note_diagnostics(CommandContext& job, const Streams& streams) {
    const std::vector<Diagnostic>& all = job.diagnostics.all();
    if (job.options.junit) job.reports->suites += junit_suite(file_of(job), all, job.sources);
    if (job.options.sarif) add_diagnostics(all, job.sources, !job.options.quiet, job.reports->sarif);
    if (job.options.format == Format::JsonLines) print_json_lines(file_of(job), all, job.sources, streams.out);
}

bool write_reports(bool failed, CommandContext& job, const Streams& streams) {
    const Options& options = job.options;
    std::vector<OutputFile> files = std::move(job.reports->files);
    const auto add = [&](const std::optional<std::string>& path, const auto& text) {
        if (path && (!failed || *path == "-" || is_replaceable(*path, job))) files.push_back({*path, text()});
    };
    add(options.junit, [&] { return junit_document(job.reports->suites); });
    add(options.sarif, [&] { return sarif_text(job.reports->sarif); });
    return files.empty() || write_outputs(files, job, streams);
}

}  // namespace grafverif::app
