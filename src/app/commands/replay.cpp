// SPDX-License-Identifier: MIT
// `replay`, `monitor`: check a recording of a real controller against its chart.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <utility>

#include "app/commands.hpp"
#include "app/outputs.hpp"
#include "app/reports.hpp"
#include "app/system/cancellable_input.hpp"
#include "app/system/watchdog.hpp"
#include "pipeline/descriptor.hpp"
#include "pipeline/files.hpp"
#include "pipeline/recording/recording.hpp"
#include "report/charts/recording.hpp"
#include "support/messages.hpp"
#include "support/messages_choice.hpp"
#include "support/messages_log.hpp"

namespace grafverif::app {

namespace {

/// Returns the chart given by `--chart`, otherwise all charts of the model. The result is empty after an error.
std::vector<Id<Chart>> recorded_charts(const Model& model, CommandContext& job) {
    std::vector<Id<Chart>> charts;
    if (job.options.chart || model.charts.empty()) {
        if (const auto chart = chosen_chart(model, job)) charts.push_back(*chart);
    } else {
        for (const Id<Chart> id : model.charts.ids()) charts.push_back(id);
    }
    for (const Id<Chart> id : charts)
        if (!can_be_recorded(model, id, job.options.mode, job.diagnostics)) return {};
    return charts;
}

/// Minimum number of instants that the HTML report shows of a long recording.
constexpr std::uint64_t least_played_instants = 2'000;

std::optional<RecordingOptions> recording_options(CommandContext& job, const Limits& limits) {
    RecordingOptions options{.limits = limits};
    if (job.options.page) options.shown_instants = least_played_instants;
    if (job.options.jitter_ms) options.jitter_ms = static_cast<std::int64_t>(*job.options.jitter_ms);
    for (const std::string& entry : job.options.renamings) {
        const std::size_t sign = entry.rfind('=');
        if (sign == std::string::npos || sign == 0 || sign + 1 == entry.size()) {
            job.diagnostics.add(
                messages::bad_log({}, fmt::format("invalid value `{}` of `--map`; use COLUMN=NAME", entry)));
            return {};
        }
        options.map.emplace_back(entry.substr(0, sign), entry.substr(sign + 1));
    }
    for (const std::string& entry : job.options.skews) {
        const auto clock = recording_clock(entry, job.diagnostics);
        if (!clock) return {};
        options.clocks.push_back(*clock);
    }
    return options;
}

ExitCode exit_code(const RecordingReport& report) {
    ExitCode code = report.stopped ? ExitCode::Unknown : ExitCode::Done;
    for (const RecordingVerdict& verdict : report.verdicts) {
        if (verdict.kind == RecordingVerdict::Kind::Deviates) code = worse(code, ExitCode::Verdict);
        if (verdict.kind == RecordingVerdict::Kind::Unknown) code = worse(code, ExitCode::Unknown);
    }
    for (const RecordedProperty& property : report.properties)
        if (property.violated) code = worse(code, ExitCode::Verdict);
    return code;
}

/// Returns a function that reads an open file. Throws std::system_error if the file cannot be read.
LogBlocks blocks_of(const Descriptor& file) {
    return [&file](std::string& block) {
        block.resize(65'536);
        ssize_t count = 0;
        do count = ::read(file.number(), block.data(), block.size());
        while (count < 0 && errno == EINTR);
        if (count < 0) grafverif::fail(errno, "the log cannot be read");
        block.resize(static_cast<std::size_t>(count));
        return count > 0;
    };
}

/// Returns a function that waits for bytes and reads those that are available.
LogBlocks blocks_of(rpc::Receive receive) {
    return [receive = std::move(receive)](std::string& block) {
        block.resize(65'536);
        block.resize(receive(block));
        return !block.empty();
    };
}

/// Checks the log that `log` reads, or standard input if `log` is null.
ExitCode check_log(LogBlocks log, const std::string& name, bool stop_early, CommandContext& job,
                   const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto charts = model ? recorded_charts(*model, job) : std::vector<Id<Chart>>{};
    const ResourceLimits bounds(job.options, streams);
    auto options = recording_options(job, bounds.limits());
    if (charts.empty() || !options) return ExitCode::Input;
    options->stop_early = stop_early;
    const CancellableInput input(*bounds.limits().stop, bounds.limits().deadline);
    if (!log)
        log = blocks_of(streams.alone ? [&](std::span<char> buffer) { return input.receive(buffer); }
                                      : receive_from(streams.in));
    auto report = check_recording(*model, charts, std::move(log), name, *options, job.sources, job.diagnostics);
    if (!report) return ExitCode::Input;
    work_is_done();
    if (job.options.format == Format::Json) streams.out << recording_json(*report);
    else print_recording(*report, colour_on(streams.out_screen, job.options), streams.out);
    const ExitCode code = job.diagnostics.has_errors() ? ExitCode::Input : exit_code(*report);
    if (!job.options.page) return code;
    PageContent content = drawn_charts(*model, job.sources, charts);
    for (const Id<Chart> chart : charts)
        content.report.model += (content.report.model.empty() ? "" : ", ") + model->charts[chart].name;
    content.recording = std::move(*report);
    return write_outputs({{*job.options.page, report_page(std::move(content), job)}}, job, streams) ? code
                                                                                                    : ExitCode::Input;
}

}  // namespace

ExitCode replay(CommandContext& job, const Streams& streams) {
    const std::string& path = *job.options.log;
    const std::optional<int> descriptor = path == "-" ? std::optional(STDIN_FILENO) : own_descriptor(path);
    if (descriptor == STDIN_FILENO)
        return note_input(path, job) ? check_log({}, "<standard input>", false, job, streams) : ExitCode::Input;
    std::string why;
    const Descriptor log = descriptor ? Descriptor(::fcntl(*descriptor, F_DUPFD_CLOEXEC, 3)) : open_regular(path, why);
    if (!log.open()) {
        job.diagnostics.add(messages::cannot_read(path, why.empty() ? std::strerror(errno) : why));
        return ExitCode::Input;
    }
    if (!note_input(path, job)) return ExitCode::Input;
    return check_log(blocks_of(log), path, false, job, streams);
}

ExitCode monitor(CommandContext& job, const Streams& streams) {
    return check_log({}, "<standard input>", true, job, streams);
}

CliCommand replay_usage() {
    return {"replay",
            "FILE",
            1,
            1,
            "check a recording of a controller against its chart",
            "Checks a recording of the inputs and outputs of a controller against the charts of FILE. The recording\n"
            "conforms if the chart can produce the recorded outputs for the recorded inputs. Each recorded time may\n"
            "differ from the time in the controller by at most the jitter (docs/how-to/check-recordings.md). If the\n"
            "recording does not conform, the first deviation is printed. The log is CSV with a first line of column\n"
            "names, JSON lines or VCD; `-` is standard input. The mode is stability-search. With --skew, columns can\n"
            "be recorded with separate clocks. --report writes the verdicts as an HTML report, with a player for the\n"
            "run. Exit code 1: the recording deviates or violates a property; 3: inconclusive.",
            {"grafverif replay press.grafcet --log night.csv --jitter 20ms",
             "grafverif replay press.grafcet --log night.csv --skew VALVE,LAMP=500ms",
             "grafverif replay press.grafcet --log night.csv --map %I0.3=START --format json",
             "grafverif replay press.grafcet --log night.csv --report night.html"},
            {OptionGroup::Log, OptionGroup::Recording, OptionGroup::Chart, OptionGroup::Mode, OptionGroup::Format}};
}

CliCommand monitor_usage() {
    return {
        "monitor",
        "FILE",
        1,
        1,
        "check samples of a controller against its chart as they arrive",
        "Checks samples on standard input like `replay`, and ends at the first deviation, violated property or\n"
        "invalid line. A deviation is reported when the samples cover a period of four times the jitter and twice\n"
        "the skew after the deviation. At the end of the samples, or if the command is interrupted, the verdict is\n"
        "printed.",
        {"recorder --csv | grafverif monitor press.grafcet --jitter 50ms"},
        {OptionGroup::Recording, OptionGroup::Chart, OptionGroup::Mode, OptionGroup::Format}};
}

}  // namespace grafverif::app
