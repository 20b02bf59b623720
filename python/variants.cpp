// SPDX-License-Identifier: MIT
#include "variants.hpp"

#include <sstream>

#include "check/shares.hpp"
#include "pipeline/certificate/certificate.hpp"
#include "pipeline/models.hpp"
#include "pipeline/recording/recording.hpp"
#include "pipeline/variants/faults.hpp"
#include "pipeline/variants/tune.hpp"
#include "pipeline/variants/tune_ranges.hpp"
#include "report/charts/faults.hpp"
#include "report/charts/recording.hpp"
#include "report/charts/tuning.hpp"
#include "report/terminal.hpp"

namespace grafverif::python {

namespace {

/// Returns the reason of verdicts that are unknown because the search was ended.
std::string reason(const Limits& limits) { return is_over(limits.deadline) ? "time limit reached" : "stopped"; }

void add_trace(const ChartRun& run, const std::string& title, Shown& shown) {
    std::get<2>(shown).emplace_back(text_of(run), svg_of(run, title));
}

}  // namespace

std::optional<Shown> tune(const ParseResult& reading, Id<ClosedLoop> loop, const std::vector<std::string>& over,
                          std::vector<std::string> properties, const ModelOptions& how, const ReadOptions& read,
                          bool every_point, const Limits& limits, Diagnostics& diagnostics) {
    const Model& model = *reading.model;
    TuneRequest request{
        .properties = std::move(properties), .how = how, .read = read, .limits = limits, .every_point = every_point};
    request.constants = constants_over(over, model.loops[loop], read.constants, diagnostics);
    if (request.constants.empty()) return {};
    auto found = tuned(model, loop, *reading.sources.ids().begin(), reading.sources, request, diagnostics);
    if (!found) return {};
    if (is_over(limits.deadline, limits.stop)) found->reasons.front() = reason(limits);
    std::ostringstream text;
    print_tuning(*found, text);
    return Shown(std::move(text).str(), tuning_json(*found, reading.sources), {});
}

std::uint64_t most_faults_of_combination() { return most_faults; }

std::optional<Shown> faults(const ParseResult& reading, Id<ClosedLoop> loop, std::uint64_t order,
                            std::vector<std::string> properties, const ModelOptions& how, const Limits& limits,
                            Diagnostics& diagnostics) {
    const Model& model = *reading.model;
    if (!faults_can_be_combined(model.loops[loop], order, diagnostics)) return {};
    const FaultsRequest request{.order = order, .properties = std::move(properties), .how = how, .limits = limits};
    auto found = analysed_faults(model, loop, request, diagnostics);
    if (!found) return {};
    for (FaultAnalysis::Row& row : found->rows)
        for (FaultAnalysis::Open& open : row.open)
            if (open.reason.empty()) open.reason = reason(limits);
    std::ostringstream text;
    print_faults(*found, false, text);
    Shown shown(std::move(text).str(), faults_json(*found, reading.sources), {});
    for (const FaultAnalysis::Row& row : found->rows)
        for (const FaultAnalysis::Cut& cut : row.minimal)
            if (cut.result.trace && is_shown(row)) add_trace(*cut.result.trace, row.property, shown);
    return shown;
}

std::optional<CertificateFiles> certify(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how,
                                        const CheckOptions& options, Report& report) {
    Diagnostics reported;  // the check has already reported them
    const auto network = network_of(model, loop, how, reported);
    if (!network) return {};
    Certificate certificate = certificate_of(loop_to_check(model, loop, *network), report, options);
    report.failures.insert(report.failures.end(), certificate.failures.begin(), certificate.failures.end());
    CertificateFiles made;
    for (CertificateSummary::Certified& one : certificate.summary.certified)
        made.certified.push_back(std::move(one.property));
    for (Certificate::File& file : certificate.files)
        made.files.emplace_back(std::move(file.path), std::move(file.content));
    for (CertificateSummary::Omitted& one : certificate.summary.omitted)
        made.omitted.emplace_back(std::move(one.property), std::move(one.reason));
    return made;
}

struct Recording::State {
    std::shared_ptr<const ParseResult> reading = {};
    Sources sources = {};
    Diagnostics diagnostics = {};
    std::optional<RecordingMonitor> monitor = {};
};

Recording::Recording(std::shared_ptr<const ParseResult> reading, const std::vector<Id<Chart>>& charts,
                     std::optional<ExecutionMode> mode, std::int64_t jitter_ms, const Skew& skew,
                     std::vector<std::pair<std::string, std::string>> map, bool stop_early)
    : state_(std::make_unique<State>()) {
    state_->reading = std::move(reading);
    state_->sources = state_->reading->sources;
    for (const Id<Chart> chart : charts)
        if (!can_be_recorded(*state_->reading->model, chart, mode, state_->diagnostics)) return;
    RecordingOptions options{.jitter_ms = jitter_ms, .map = std::move(map), .stop_early = stop_early};
    for (const auto& [columns, bound_us] : skew) options.clocks.push_back({columns, bound_us});
    state_->monitor.emplace(*state_->reading->model, charts, "<samples>", std::move(options), state_->sources,
                            state_->diagnostics);
}

Recording::~Recording() = default;

bool Recording::add(const std::string& line) { return state_->monitor && state_->monitor->add(line); }

std::optional<Shown> Recording::finish() {
    const auto report = state_->monitor ? state_->monitor->finish() : std::nullopt;
    state_->monitor.reset();
    if (!report) return {};
    std::ostringstream text;
    print_recording(*report, Colour::Plain, text);
    Shown shown(std::move(text).str(), recording_json(*report), {});
    for (const RecordingVerdict& verdict : report->verdicts)
        if (verdict.deviation) add_trace(verdict.run, verdict.chart, shown);
    return shown;
}

const Diagnostics& Recording::diagnostics() const { return state_->diagnostics; }
const Sources& Recording::sources() const { return state_->sources; }

}  // namespace grafverif::python
