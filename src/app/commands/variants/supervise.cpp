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
        return "The conditions are least restrictive: they forbid a move only in states in which it must be forbidden.";
    case Supervisor::Permissiveness::Several:
        return fmt::format(
            "The conditions are maximal but not unique: other valid conditions allow {} more often and other moves "
            "less "
            "often.",
            listed(found.traded));
    case Supervisor::Permissiveness::Cautious: break;
    }
    if (found.hidden.empty())
        return "The conditions are not least restrictive: the inputs and steps of the chart do not distinguish all "
               "states in which a move must be disabled from the other states.";
    return fmt::format(
        "The conditions are not least restrictive: with more sensors, conditions could allow {} more often.",
        listed(found.hidden));
}

/// True if the conditions are valid, but disable a transition or an output of a chart completely.
bool is_disabling(const Supervised& found) {
    return found.outcome == Supervisor::Outcome::Found &&
           !(found.disabled_transitions.empty() && found.disabled_outputs.empty());
}

void print_disabled(const Supervised& found, std::ostream& out) {
    out << (found.claim == Supervisor::Permissiveness::Least
                ? "\n"
                  "No useful conditions exist: all conditions that enforce the properties disable parts of the chart.\n"
                : "\n"
                  "No useful conditions were found: the conditions that enforce the properties disable parts of the "
                  "chart.\n");
    const auto line = [&](std::string_view what, const std::vector<std::string>& names) {
        if (!names.empty()) out << fmt::format("  {}: {}\n", what, listed(names));
    };
    line("never cleared", found.disabled_transitions);
    line("never set", found.disabled_outputs);
    line("never active", found.never_active_steps);
    if (found.claim != Supervisor::Permissiveness::Least) out << permissiveness_text(found) << '\n';
}

/// Prints the verdicts in the timed loop without conditions, and the remedy if a property depends on durations.
void print_timed(const Supervised& found, std::ostream& out) {
    const auto with = [&](Outcome outcome) {
        std::vector<std::string> names;
        for (const Supervised::Timed& each : found.timed)
            if (each.outcome == outcome) names.push_back(each.property);
        return names;
    };
    const std::vector<std::string> holds = with(Outcome::Holds);
    if (holds.empty() && found.outcome == Supervisor::Outcome::Found && !is_disabling(found)) return;
    const bool one = holds.size() == 1;
    if (!holds.empty()) {
        out << fmt::format(
            "In the timed loop (grain atomic), {} {} without conditions: {} {} on durations, which the "
            "untimed model omits.\n",
            listed(holds), one ? "holds" : "hold", one ? "it" : "they", one ? "depends" : "depend");
        std::string rest;
        for (const std::string& name : found.kept)
            if (std::ranges::find(holds, name) == holds.end()) rest += " --property " + name;
        if (!rest.empty())
            out << fmt::format("To synthesize conditions for the other properties, use `{}`.\n", rest.substr(1));
    }
    if (const auto names = with(Outcome::Violated); !names.empty())
        out << fmt::format("In the timed loop (grain atomic), {} {} violated without conditions.\n", listed(names),
                           names.size() == 1 ? "is" : "are");
    if (const auto names = with(Outcome::Unknown); !names.empty())
        out << fmt::format("It is unknown whether {} in the timed loop without conditions; run `grafverif check`.\n",
                           listed(names) + (names.size() == 1 ? " holds" : " hold"));
}

std::string timelock_text(Outcome timelock) {
    switch (timelock) {
    case Outcome::Holds: return "With the conditions, time cannot stop in the timed loop (grain atomic).\n";
    case Outcome::Violated:
        return "Time can stop in the timed loop (grain atomic), with or without the conditions; run `grafverif check` "
               "for a trace.\n";
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
                           condition.sum               ? "(" + condition.term + ")"
                           : condition.term == "false" ? "false, so this action never sets the output"
                                                       : condition.term);
    if (!found.never_active_steps.empty())
        out << fmt::format(
            "These steps can be active without the conditions, but are never active with the conditions: {}.\n",
            listed(found.never_active_steps));
    out << permissiveness_text(found) << '\n';
}

void print(const Supervised& found, std::ostream& out) {
    out << fmt::format(
        "{}: untimed, plant automata interleaved, grain atomic\n"
        "to enforce: {}\n"
        "to keep reachable: {}\n",
        found.loop, listed(found.kept), marked_text(found));
    for (const std::string reason :
         {"with a duration, which the untimed model omits", "not a property of all states", "expected violated"}) {
        std::vector<std::string> names;
        for (const Supervised::Ignored& ignored : found.ignored)
            if (ignored.reason == reason) names.push_back(ignored.property);
        if (!names.empty()) out << fmt::format("ignored, {}: {}\n", reason, listed(names));
    }
    switch (found.outcome) {
    case Supervisor::Outcome::Found:
        if (is_disabling(found)) {
            print_disabled(found, out);
            break;
        }
        print_conditions(found, out);
        out << "The resulting text was read again and verified: all results by the symbolic engine, and the properties "
               "also by a second engine.\n"
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
    print_timed(found, out);
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
                                   {"outcome", is_disabling(found) ? "disabling" : std::string(word(found.outcome))},
                                   {"reason", text_or_null(found.reason)}};
    const bool made = found.outcome == Supervisor::Outcome::Found;
    json["claim"] = made ? nlohmann::ordered_json(std::string(word(found.claim))) : nlohmann::ordered_json(nullptr);
    json["hidden"] = found.hidden;
    json["traded"] = found.traded;
    json["conditions"] = std::move(conditions);
    json["no_timelock"] =
        made ? nlohmann::ordered_json(std::string(grafverif::word(found.timelock))) : nlohmann::ordered_json(nullptr);
    nlohmann::ordered_json timed = nlohmann::ordered_json::array();
    for (const auto& [property, outcome] : found.timed)
        timed.push_back({{"property", property}, {"verdict", std::string(grafverif::word(outcome))}});
    json["disabled_transitions"] = found.disabled_transitions;
    json["disabled_outputs"] = found.disabled_outputs;
    json["lost_steps"] = found.never_active_steps;
    json["timed"] = std::move(timed);
    json["blocked"] = found.blocked;
    json["trace"] = found.run ? trace_json(*found.run) : nlohmann::ordered_json(nullptr);
    return json;
}

/// Writes the text of the model with the synthesized conditions. Returns false after an error.
bool write_chart(const Supervised& found, CommandContext& job, const Streams& streams) {
    if (!job.options.output || found.outcome != Supervisor::Outcome::Found || is_disabling(found)) return true;
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
    const SuperviseRequest request{.properties = options.properties,
                                   .marked = options.marked,
                                   .transitions = options.held != Held::Outputs,
                                   .outputs = options.held != Held::Transitions,
                                   .mode = options.mode,
                                   .read = read_options(options),
                                   .limits = bounds.limits()};
    auto found = supervised(*model, *loop, *job.sources.ids().begin(), job.sources, request, job.diagnostics);
    if (!found) return ExitCode::Input;
    found->reason = with_remedy(with_who_stopped(std::move(found->reason), bounds.interrupted(), options), options);
    print_failures(found->failures, streams);
    if (!found->failures.empty()) return ExitCode::Failure;
    work_is_done();
    if (!write_chart(*found, job, streams)) return ExitCode::Input;
    if (job.options.format == Format::Json) streams.out << json_text(json_of(*found, job.sources)) << '\n';
    else print(*found, streams.out);
    if (found->outcome == Supervisor::Outcome::Unknown) return ExitCode::Unknown;
    return found->outcome == Supervisor::Outcome::None || is_disabling(*found) ? ExitCode::Verdict : ExitCode::Done;
}

CliCommand supervise_usage() {
    return {
        "supervise",
        "FILE",
        1,
        1,
        "synthesize conditions on a chart that enforce its properties",
        "Computes conditions over the inputs and steps of the charts of a closed loop in FILE, and adds them to the\n"
        "transitions and outputs of these charts. Under these conditions, the properties of states (always, never,\n"
        "exactly one of) hold for all behaviour of the plant, and a marked situation remains reachable. The\n"
        "conditions are computed on the untimed model in which one plant automaton moves at a time (interleaved) and\n"
        "a PLC cycle is one indivisible step (grain atomic). -o writes the file with the conditions, after two\n"
        "engines have proved its properties. If no such conditions exist, a trace shows behaviour that no controller\n"
        "can prevent. Conditions that disable a transition or an output completely are not written. Exit code 1: no\n"
        "such conditions exist, or the computed conditions disable a transition or an output completely.\n"
        "docs/how-to/supervise.md states the guarantees.",
        {"grafverif supervise station.grafcet", "grafverif supervise station.grafcet --property P15 -o safe.grafcet",
         "grafverif supervise station.grafcet --marked 'X0 && V_IN' --format json"},
        {OptionGroup::Output, OptionGroup::Loop, OptionGroup::Constants, OptionGroup::Mode, OptionGroup::Supervision,
         OptionGroup::Format}};
}

}  // namespace grafverif::app
