// SPDX-License-Identifier: MIT
#include "pipeline/recording/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "check/shares.hpp"
#include "pipeline/recording/recorded_properties.hpp"
#include "read/recording/log_reader.hpp"
#include "run/recording/recording_check.hpp"
#include "run/scanner.hpp"
#include "support/messages_choice.hpp"
#include "support/messages_log.hpp"
#include "support/wording.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif {

namespace {

using Variable = Id<Chart::Variable>;

std::string list_of(const std::vector<std::string>& names) {
    constexpr std::size_t shown = 8;
    std::string text;
    for (std::size_t k = 0; k < std::min(names.size(), shown); ++k)
        text += fmt::format("{}`{}`", k == 0 ? "" : ", ", messages::clipped(names[k]));
    return text + (names.size() > shown ? fmt::format(", and {} more", names.size() - shown) : "");
}

std::vector<std::string> names_of(const Chart& chart, const std::vector<Variable>& variables) {
    std::vector<std::string> names;
    for (const Variable id : variables) names.push_back(chart.variables[id].name);
    return names;
}

}  // namespace

class RecordingReader {
public:
    RecordingReader(LogBlocks log, const std::string& name, const RecordingOptions& options, Sources& sources,
                    Diagnostics& diagnostics)
        : reader_(std::move(log), name, sources, diagnostics),
          options_(options),
          diagnostics_(diagnostics),
          errors_(diagnostics.errors()) {
        report_.log = name;
        report_.jitter_us = options.jitter_ms * 1000;
        for (const RecordingClock& clock : options.clocks) report_.skew_us = std::max(report_.skew_us, clock.bound_us);
    }

    /// Reads the names of the variables. Returns false after an error.
    bool open(const Model& model, const std::vector<Id<Chart>>& charts) {
        if (options_.stop_early) reader_.stop_at_error();
        if (!reader_.open()) return false;
        for (const Id<Chart> id : charts) charts_.push_back(bound(model.charts[id]));
        check_names();
        if (failed()) return false;
        std::vector<std::string> names;
        for (std::size_t k = 0; k < reader_.columns().size(); ++k)
            names.push_back(is_used(k) ? mapped(reader_.columns()[k].name) : "");
        std::vector<std::size_t> clock_of;
        for (const LogColumn& column : reader_.columns()) clock_of.push_back(clock_of_column(column.name));
        std::vector<std::int64_t> bounds;
        for (const RecordingClock& clock : options_.clocks) bounds.push_back(clock.bound_us);
        properties_.emplace(model, names,
                            RecordingTolerance{report_.jitter_us, std::move(clock_of), std::move(bounds)});
        return true;
    }

    /// Reads the next row of the log. Returns false if there is no further row, if all verdicts are final, or if the
    /// check was stopped.
    bool read_row() {
        if (is_decided() || stopped() || !reader_.next(row_)) return false;
        add(row_);
        return true;
    }

    /// Returns the verdicts; empty after an error.
    std::optional<RecordingReport> finish() {
        if (report_.samples == 0 && !failed())
            diagnostics_.add(messages::bad_log(reader_.where(), "the log has no sample; add at least one row"));
        finish_sample();
        if (failed() && (!options_.stop_early || report_.samples < 2)) return {};
        report_.stopped = failed() || (!is_decided() && stopped());
        collect_verdicts();
        return std::move(report_);
    }

    bool failed() const { return diagnostics_.errors() != errors_; }

    bool is_decided() const {
        const auto decided = [](const CheckedChart& checked) { return checked.decided; };
        if (!options_.stop_early) return std::ranges::all_of(charts_, decided);
        return std::ranges::any_of(charts_, decided) ||
               std::ranges::any_of(properties_->results(), &RecordedProperty::violated);
    }

private:
    /// A chart that is checked against the recording.
    struct CheckedChart {
        const Chart* chart = nullptr;
        std::vector<Variable> variable_of = {};    ///< for each column: its variable, or an invalid id
        std::vector<std::size_t> column_of = {};   ///< for each variable: column + 1, or 0
        std::vector<std::string> unrecorded = {};  ///< names of the outputs without a column
        std::vector<std::size_t> clocks = {};      ///< the clocks of the variables: indices of RecordingOptions::clocks
        std::unique_ptr<RecordingCheck> check = {};
        RecordedSample sample = {};  ///< all values with the time of the last row
        bool decided = false;
    };

    void collect_verdicts() {
        for (CheckedChart& checked : charts_) {
            report_.verdicts.push_back(checked.check->verdict());
            RecordingVerdict& verdict = report_.verdicts.back();
            verdict.unrecorded = checked.unrecorded;
            for (std::size_t k = 0; k < verdict.offsets.size(); ++k) {
                verdict.offsets[k].columns = options_.clocks[checked.clocks[k]].columns;
                verdict.offsets[k].bound_us = options_.clocks[checked.clocks[k]].bound_us;
            }
            if (!report_.stopped || verdict.kind != RecordingVerdict::Kind::Conforms) continue;
            verdict.kind = RecordingVerdict::Kind::Unknown;
            verdict.reason = failed() ? "an invalid line ended the check; no deviation up to this line"
                                      : "stopped before the end of the log; no deviation up to the last sample read";
        }
        report_.properties = properties_->results();
    }

    const std::string& mapped(const std::string& column) const {
        for (const auto& [from, to] : options_.map)
            if (from == column) return to;
        return column;
    }

    /// Returns the clock of a column as the index in RecordingOptions::clocks plus 1, or 0 if no clock is declared for
    /// it.
    std::size_t clock_of_column(const std::string& column) const {
        const auto contains = [&](const RecordingClock& clock) {
            return std::ranges::find(clock.columns, column) != clock.columns.end();
        };
        const auto found = std::ranges::find_if(options_.clocks, contains);
        return found == options_.clocks.end() ? 0 : static_cast<std::size_t>(found - options_.clocks.begin()) + 1;
    }

    /// Adds the clocks that recorded the columns of `checked` to the settings of its check.
    void add_clocks(CheckedChart& checked, RecordingSettings& settings) const {
        settings.clock_of.resize(checked.column_of.size());
        for (std::size_t k = 0; k < checked.column_of.size(); ++k) {
            if (checked.column_of[k] == 0) continue;
            const std::size_t clock = clock_of_column(reader_.columns()[checked.column_of[k] - 1].name);
            if (clock == 0) continue;
            const auto found = std::ranges::find(checked.clocks, clock - 1);
            settings.clock_of[k] = static_cast<std::size_t>(found - checked.clocks.begin()) + 1;
            if (found != checked.clocks.end()) continue;
            checked.clocks.push_back(clock - 1);
            settings.clocks.push_back(options_.clocks[clock - 1].bound_us);
        }
    }

    /// Assigns the columns of the recording to the inputs and outputs of `chart`.
    CheckedChart bound(const Chart& chart) {
        CheckedChart checked{.chart = &chart};
        checked.column_of.resize(chart.variables.size());
        for (std::size_t k = 0; k < reader_.columns().size(); ++k) {
            const LogColumn& column = reader_.columns()[k];
            const auto found = std::ranges::find(chart.variables, mapped(column.name), &Chart::Variable::name);
            checked.variable_of.emplace_back();
            if (found == chart.variables.end() || found->kind == Chart::VariableKind::Internal) continue;
            const Variable id{static_cast<std::uint32_t>(found - chart.variables.begin())};
            if (checked.column_of[id.index] != 0)
                diagnostics_.add(messages::bad_log(
                    column.where, fmt::format("a second column belongs to `{}`; remove or rename one of the columns",
                                              messages::clipped(found->name))));
            checked.column_of[id.index] = k + 1;
            if (found->type.boolean || found->kind == Chart::VariableKind::Input)
                reader_.restrict(k, found->type.low, found->type.high);
            checked.variable_of.back() = id;
        }
        const auto without_column = [&](Chart::VariableKind kind, bool without) {
            std::vector<Variable> list = variables_of_kind(chart, kind);
            std::erase_if(list, [&](Variable id) { return (checked.column_of[id.index] == 0) != without; });
            return list;
        };
        const std::vector<std::string> inputs = names_of(chart, without_column(Chart::VariableKind::Input, true));
        const std::vector<Variable> outputs = without_column(Chart::VariableKind::Output, false);
        checked.unrecorded = names_of(chart, without_column(Chart::VariableKind::Output, true));
        if (!inputs.empty())
            diagnostics_.add(messages::unrecorded_inputs(reader_.where(), chart.name, list_of(inputs)));
        if (outputs.empty()) diagnostics_.add(messages::no_recorded_output(reader_.where(), chart.name));
        else if (!checked.unrecorded.empty())
            diagnostics_.add(messages::unrecorded_outputs(chart.name, list_of(checked.unrecorded)));
        RecordingSettings settings{.jitter = report_.jitter_us,
                                   .shown_instants = options_.shown_instants,
                                   .stopped = [this] { return stopped(); }};
        add_clocks(checked, settings);
        checked.check = std::make_unique<RecordingCheck>(chart, outputs, settings);
        return checked;
    }

    /// True if the column belongs to an input or output of a chart.
    bool is_used(std::size_t column) const {
        return std::ranges::any_of(charts_, [&](const CheckedChart& one) { return one.variable_of[column].valid(); });
    }

    /// Checks the names in `--map` and `--skew`. Adds a diagnostic with the names of the columns that belong to no
    /// variable; their values are ignored.
    void check_names() {
        std::vector<std::string> columns, variables, ignored;
        Span first_ignored;
        for (std::size_t k = 0; k < reader_.columns().size(); ++k) {
            columns.push_back(reader_.columns()[k].name);
            if (is_used(k)) continue;
            ignored.push_back(columns.back());
            reader_.ignore(k);
            if (ignored.size() == 1) first_ignored = reader_.columns()[k].where;
        }
        for (const CheckedChart& checked : charts_)
            for (const Chart::Variable& variable : checked.chart->variables)
                if (variable.kind != Chart::VariableKind::Internal) variables.push_back(variable.name);
        for (const auto& [from, to] : options_.map) {
            if (std::ranges::find(columns, from) == columns.end())
                diagnostics_.add(messages::no_such_choice("column", from, columns, nearest_of(from, columns)));
            if (std::ranges::find(variables, to) == variables.end())
                diagnostics_.add(messages::no_such_choice("input or output", to, variables, nearest_of(to, variables)));
        }
        std::vector<std::string> with_clock;
        for (const RecordingClock& clock : options_.clocks)
            for (const std::string& column : clock.columns) {
                if (std::ranges::find(columns, column) == columns.end())
                    diagnostics_.add(messages::no_such_choice("column", column, columns, nearest_of(column, columns)));
                else if (std::ranges::find(ignored, column) != ignored.end())
                    diagnostics_.add(messages::bad_log(
                        {},
                        fmt::format("`--skew` names the column `{}`, but no checked chart has an input or output for "
                                    "this column; remove the column from `--skew`",
                                    messages::clipped(column))));
                if (std::ranges::find(with_clock, column) != with_clock.end())
                    diagnostics_.add(messages::bad_log(
                        {},
                        fmt::format("`--skew` names the column `{}` twice; name it once", messages::clipped(column))));
                with_clock.push_back(column);
            }
        if (!ignored.empty()) diagnostics_.add(messages::ignored_columns(first_ignored, list_of(ignored)));
    }

    void add(const LogRow& row) {
        if (report_.samples == 0) {
            report_.first_us = row.time_us;
            first_row_ = reader_.where();
        }
        if (report_.samples == 0 || row.time_us != report_.last_us) begin_sample(row);
        for (const LogValue& value : row.values) {
            properties_->set(value.column, value.value, row.time_us, value.line);
            for (CheckedChart& checked : charts_) add(value, checked);
        }
    }

    void begin_sample(const LogRow& row) {
        if (report_.samples != 0) finish_sample();
        for (CheckedChart& checked : charts_) {
            if (report_.samples != 0 && !failed()) checked.decided = !checked.check->pass(row.time_us);
            checked.sample.time = row.time_us;
            checked.sample.line = row.line;
            checked.sample.values.clear();
        }
        properties_->pass(row.time_us);
        ++report_.samples;
        report_.last_us = row.time_us;
    }

    static void add(const LogValue& value, CheckedChart& checked) {
        const Variable id = checked.variable_of[value.column];
        if (!id.valid()) return;
        std::erase_if(checked.sample.values, [&](const RecordedValue& known) { return known.variable == id; });
        checked.sample.values.push_back({id, value.value, value.line});
    }

    /// Passes the current sample to the checks of the charts. Must be called after all rows of the sample have been
    /// read.
    void finish_sample() {
        if (failed()) return;
        if (report_.samples == 1) check_first();
        if (failed()) return;
        for (CheckedChart& checked : charts_)
            if (!checked.decided) checked.decided = !checked.check->add(checked.sample);
    }

    /// Reports an error if the recording has a column for a variable, but the first sample has no value for it.
    void check_first() {
        std::vector<std::string> names;
        for (const CheckedChart& checked : charts_)
            for (std::size_t k = 0; k < checked.variable_of.size(); ++k)
                if (checked.variable_of[k].valid() &&
                    std::ranges::find(checked.sample.values, checked.variable_of[k], &RecordedValue::variable) ==
                        checked.sample.values.end())
                    names.push_back(reader_.columns()[k].name);
        if (!names.empty())
            diagnostics_.add(messages::bad_log(
                first_row_,
                fmt::format("the first sample has no value of {}; add a value for each column", list_of(names))));
    }

    bool stopped() const { return is_over(options_.limits.deadline, options_.limits.stop); }

    LogReader reader_;
    const RecordingOptions& options_;
    Diagnostics& diagnostics_;
    std::size_t errors_;  ///< number of errors in `diagnostics` before the check
    LogRow row_ = {};
    Span first_row_ = {};
    RecordingReport report_ = {};
    std::vector<CheckedChart> charts_ = {};
    std::optional<RecordedProperties> properties_ = {};
};

bool can_be_recorded(const Model& model, Id<Chart> chart, std::optional<ExecutionMode> mode, Diagnostics& diagnostics) {
    if (!equations_of(model, chart, diagnostics)) return false;
    if (execution_mode(model, chart, mode) == ExecutionMode::StabilitySearch) return true;
    diagnostics.add(messages::not_comparable(
        model.charts[chart].origin,
        fmt::format("`{}` writes outputs in every cycle, and a recording does not contain the cycles",
                    model.charts[chart].name),
        "pass `--mode stability-search`"));
    return false;
}

std::optional<RecordingClock> recording_clock(const std::string& text, Diagnostics& diagnostics) {
    const std::size_t sign = std::min(text.rfind('='), text.size());
    RecordingClock clock;
    for (std::size_t begin = 0; begin <= sign;) {
        const std::size_t end = std::min(text.find(',', begin), sign);
        clock.columns.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    const auto bound = sign == text.size() ? std::nullopt : log_time(text.substr(sign + 1));
    if (!bound || std::ranges::any_of(clock.columns, &std::string::empty)) {
        diagnostics.add(messages::bad_log(
            {}, fmt::format("invalid value `{}` of `--skew`; use COLUMN[,COLUMN...]=TIME, such as `PUMP,HORN=500ms`",
                            messages::clipped(text))));
        return {};
    }
    clock.bound_us = *bound;
    return clock;
}

RecordingMonitor::RecordingMonitor(const Model& model, std::vector<Id<Chart>> charts, const std::string& name,
                                   RecordingOptions options, Sources& sources, Diagnostics& diagnostics)
    : model_(model), charts_(std::move(charts)), options_(std::move(options)) {
    const auto next_line = [this](std::string& block) {
        block = std::move(line_);
        line_.clear();
        return !block.empty();
    };
    reader_ = std::make_unique<RecordingReader>(next_line, name, options_, sources, diagnostics);
}

RecordingMonitor::~RecordingMonitor() = default;

bool RecordingMonitor::add(const std::string& line) {
    if (reader_->failed() || (open_ && reader_->is_decided())) return false;
    line_ = line + '\n';
    if (!open_ && !reader_->open(model_, charts_)) return false;
    open_ = true;
    reader_->read_row();
    return !reader_->failed() && !reader_->is_decided();
}

std::optional<RecordingReport> RecordingMonitor::finish() {
    if (!open_ && !add("")) return {};
    return reader_->finish();
}

std::optional<RecordingReport> check_recording(const Model& model, const std::vector<Id<Chart>>& charts, LogBlocks log,
                                               const std::string& name, const RecordingOptions& options,
                                               Sources& sources, Diagnostics& diagnostics) {
    RecordingReader reader(std::move(log), name, options, sources, diagnostics);
    if (!reader.open(model, charts)) return {};
    while (reader.read_row()) {
    }
    return reader.finish();
}

}  // namespace grafverif
