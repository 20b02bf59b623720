// SPDX-License-Identifier: MIT
// `supervise`: synthesizes conditions on a chart that enforce the properties of its loop.
#include "pipeline/variants/supervise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <utility>

#include "app/commands.hpp"
#include "app/stop_text.hpp"
#include "app/system/watchdog.hpp"
#include "report/json_trace.hpp"
#include "report/terminal.hpp"
#include "support/json_text.hpp"
#include "support/printable.hpp"

namespace grafverif::app {

namespace {

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += fmt::format("{}{}", text.empty() ? "" : ", ", name);
    return text;
}

std::string marked_text(const Supervised& found) {
    return found.marked.empty() ? "the initial situation" : found.marked;
}

std::string_view word(Supervisor::Outcome outcome) {
    switch (outcome) {
    case Supervisor::Outcome::Found: return "found";
    case Supervisor::Outcome::None: return "none";
    case Supervisor::Outcome::Unknown: break;
    }
    return "unknown";
}

std::string_view word(Supervisor::Permissiveness claim) {
    switch (claim) {
    case Supervisor::Permissiveness::Least: return "least restrictive";
    case Supervisor::Permissiveness::Several: return "one of several";
    case Supervisor::Permissiveness::Cautious: break;
    }
    return "cautious";
}

std::string permissiveness_text(const Supervised& found) {
    switch (found.claim) {
    case Supervisor::Permissiveness::Least:
        return "They are least restrictive: every move that they forbid must be forbidden in that state.";
    case Supervisor::Permissiveness::Several:
        return fmt::format(
            "They are maximal but not unique: other valid conditions allow {} more often and something else less "
            "often.",
            listed(found.traded));
    case Supervisor::Permissiveness::Cautious: break;
    }
    if (found.hidden.empty())
        return "They are not least restrictive: the inputs and steps of the chart do not distinguish enough states.";
    return fmt::format("They are not least restrictive: with more sensors, conditions could allow {} more often.",
                       listed(found.hidden));
}

std::string timelock_text(Outcome timelock) {
    switch (timelock) {
    case Outcome::Holds: return "With them, time never stops in the timed loop (grain atomic).\n";
    case Outcome::Violated:
        return "Time can stop in the timed loop (grain atomic), with or without them; run `grafverif check` for a "
               "trace.\n";
    case Outcome::Unknown: break;
    }
    return "It is unknown whether time can stop in the timed loop; run `grafverif check`.\n";
}

std::string subject_text(const ChartCondition& condition, bool several) {
    const std::string what = condition.step.empty() ? "transition " + condition.subject
                                                    : fmt::format("output {} in {}", condition.subject, condition.step);
    return several ? fmt::format("{}: {}", condition.chart, what) : what;
}

void print_conditions(const Supervised& found, std::ostream& out) {
    if (found.conditions.empty()) {
        out << "\n"
               "The properties to enforce hold without conditions.\n";
        return;
    }
    bool several = false;
    std::size_t width = 0;
    for (const ChartCondition& condition : found.conditions)
        several = several || condition.chart != found.conditions.front().chart;
    for (const ChartCondition& condition : found.conditions)
        width = std::max(width, columns_of(subject_text(condition, several)));
    out << "\nAdded to the conditions of the chart:\n";
    for (const ChartCondition& condition : found.conditions)
        out << fmt::format("  {}  && {}\n", padded(subject_text(condition, several), width),
                           condition.sum ? "(" + condition.term + ")" : condition.term);
    out << permissiveness_text(found) << '\n';
}

void print(const Supervised& found, std::ostream& out) {
    out << fmt::format(
        "{}: untimed, plant automata interleaved, grain atomic\n"
        "to enforce: {}\n"
        "to keep reachable: {}\n",
        found.loop, listed(found.kept), marked_text(found));
    for (const std::string reason : {"not a property of all states", "expected violated"}) {
        std::vector<std::string> names;
        for (const Supervised::Ignored& ignored : found.ignored)
            if (ignored.reason == reason) names.push_back(ignored.property);
        if (!names.empty()) out << fmt::format("ignored, {}: {}\n", reason, listed(names));
    }
    switch (found.outcome) {
    case Supervisor::Outcome::Found:
        print_conditions(found, out);
        out << "Verified after reading back: everything by the symbolic engine, the properties also by a second "
               "engine.\n"
            << timelock_text(found.timelock);
        break;
    case Supervisor::Outcome::None:
        out << (found.blocked
                    ? "\n"
                      "No such conditions exist: for all conditions on the chart, the plant can reach a state from "
                      "which no marked state\n"
                      "is reachable without violating a property.\n"
                    : "\n"
                      "No such conditions exist: for all conditions on the chart, the plant can violate a property.\n");
        if (found.run) {
            out << "A trace of the unmodified chart that no conditions can prevent:\n"
                   "\n";
            print_trace(*found.run, out);
        }
        break;
    case Supervisor::Outcome::Unknown: out << fmt::format("\nunknown: {}\n", found.reason);
    }
}

nlohmann::ordered_json json_of(const Supervised& found, const Sources& sources) {
    nlohmann::ordered_json conditions = nlohmann::ordered_json::array();
    for (const ChartCondition& condition : found.conditions)
        conditions.push_back({{"chart", condition.chart},
                              {condition.step.empty() ? "transition" : "output", condition.subject},
                              {"step", text_or_null(condition.step)},
                              {"condition", condition.term},
                              {"place", text_or_null(file_and_line(sources, condition.origin))}});
    nlohmann::ordered_json ignored = nlohmann::ordered_json::array();
    for (const auto& [property, reason] : found.ignored)
        ignored.push_back({{"property", property}, {"reason", reason}});
    nlohmann::ordered_json json = {{"model", found.loop},
                                   {"kept", found.kept},
                                   {"ignored", std::move(ignored)},
                                   {"marked", text_or_null(found.marked)},
                                   {"outcome", std::string(word(found.outcome))},
                                   {"reason", text_or_null(found.reason)}};
    const bool made = found.outcome == Supervisor::Outcome::Found;
    json["claim"] = made ? nlohmann::ordered_json(std::string(word(found.claim))) : nlohmann::ordered_json(nullptr);
    json["hidden"] = found.hidden;
    json["traded"] = found.traded;
    json["conditions"] = std::move(conditions);
    json["no_timelock"] =
        made ? nlohmann::ordered_json(std::string(grafverif::word(found.timelock))) : nlohmann::ordered_json(nullptr);
    json["blocked"] = found.blocked;
    json["trace"] = found.run ? trace_json(*found.run) : nlohmann::ordered_json(nullptr);
    return json;
}

/// Writes the text with the conditions. Returns false after an error.
bool write_chart(const Supervised& found, CommandContext& job, const Streams& streams) {
    if (!job.options.output || found.outcome != Supervisor::Outcome::Found) return true;
    if (found.file) return deliver(found.text, job, streams), true;
    streams.err
        << "grafverif: error: the conditions belong to charts in several files, but `-o` writes one file; omit `-o`\n";
    return false;
}

}  // namespace

ExitCode supervise(CommandContext& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto loop = model ? chosen_loop(*model, job) : std::nullopt;
    if (!loop) return ExitCode::Input;
    const ResourceLimits bounds(job.options, streams);
    const Options& options = job.options;
    const SuperviseRequest ask{
        .properties = options.properties,
        .marked = options.marked,
        .transitions = options.held != Held::Outputs,
        .outputs = options.held != Held::Transitions,
        .mode = options.mode,
        .read = {.include_folders = options.include_folders, .lossy = options.lossy, .constants = options.constants},
        .limits = bounds.limits()};
    auto found = supervised(*model, *loop, *job.sources.ids().begin(), job.sources, ask, job.diagnostics);
    if (!found) return ExitCode::Input;
    found->reason = with_remedy(with_who_stopped(std::move(found->reason), bounds.interrupted(), options), options);
    for (const std::string& failure : found->failures)
        streams.err << "grafverif: internal error: " << printable(failure) << '\n';
    if (!found->failures.empty()) return ExitCode::Failure;
    work_is_done();
    if (!write_chart(*found, job, streams)) return ExitCode::Input;
    if (job.options.format == Format::Json) streams.out << json_text(json_of(*found, job.sources)) << '\n';
    else print(*found, streams.out);
    if (found->outcome == Supervisor::Outcome::Unknown) return ExitCode::Unknown;
    return found->outcome == Supervisor::Outcome::None ? ExitCode::Verdict : ExitCode::Done;
}

CliCommand supervise_usage() {
    return {
        "supervise",
        "FILE",
        1,
        1,
        "synthesize conditions on a chart that enforce its properties",
        "Computes conditions on the transitions and outputs of the charts of a closed loop in FILE, over their inputs "
        "and steps.\n"
        "Under these conditions, the properties of states (always, never, exactly one of) hold for all behaviour of "
        "the plant,\n"
        "and a marked situation remains reachable. The model is untimed with plant automata, interleaved, grain "
        "atomic. -o\n"
        "writes the file with these conditions, after two engines have proved it. If no such conditions exist, a trace "
        "shows\n"
        "behaviour that no controller can prevent. docs/how-to/supervise.md states the guarantees.",
        {"grafverif supervise station.grafcet", "grafverif supervise station.grafcet --property P15 -o safe.grafcet",
         "grafverif supervise station.grafcet --marked 'X0 && V_IN' --format json"},
        {OptionGroup::Output, OptionGroup::Loop, OptionGroup::Constants, OptionGroup::Mode, OptionGroup::Supervision,
         OptionGroup::Format}};
}

}  // namespace grafverif::app
