// SPDX-License-Identifier: MIT
#include "report/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/profile.hpp"
#include "run/project.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

namespace {

std::string mode_text(bool searches, bool cycles) {
    std::string mode = searches ? "stability-search" : "";
    if (cycles) mode += searches ? ", every-cycle" : "every-cycle";
    return mode;
}

}  // namespace

CheckSettings settings_of(const Network& network, std::string engine) {
    bool searches = false, cycles = false;
    for (const Network::Controller& controller : network.controllers)
        (controller.words.mode == ExecutionMode::EveryCycle ? cycles : searches) = true;
    const std::string mode = mode_text(searches, cycles);
    return {std::move(engine),    mode, network.grain == Grain::Atomic ? "atomic" : "phased",
            network.time_unit_ms, {},   network.constants};
}

CheckSettings settings_of(const TransitionSystem& system, std::string engine, std::string untimed) {
    bool searches = false, cycles = false;
    for (const TransitionSystem::Controller& controller : system.controllers)
        (controller.words.mode == ExecutionMode::EveryCycle ? cycles : searches) = true;
    return {std::move(engine), mode_text(searches, cycles), {}, 0, std::move(untimed), system.constants};
}

namespace {

std::string message_of(const SystemFault& fault) {
    switch (fault.kind) {
    case SystemFault::Kind::NoInitialState: return "there is no initial state: the constraints contradict each other";
    case SystemFault::Kind::DeadEnd: return "the model reaches a state without a successor";
    case SystemFault::Kind::OutOfRange:
        return fmt::format("`{}` gets an undefined value or a value outside its range", fault.variable);
    }
    unreachable();
}

}  // namespace

ModelErrorTrace error_trace_of(const TransitionSystem& system, const SystemFault& fault, Detail detail) {
    const bool shown = !fault.run.states.empty();
    return {std::string(word(fault.kind)), message_of(fault),
            shown ? with_rows(project(system, fault.run), detail) : ChartRun{}};
}

PropertyResult result_of(const TransitionSystem& system, Verdict verdict, const std::optional<SystemRun>& run,
                         Detail detail) {
    PropertyResult answer;
    if (verdict.about.valid()) answer.text = system.properties[verdict.about].text;
    if (run) answer.trace = with_rows(project(system, *run), detail);
    answer.verdict = std::move(verdict);
    return answer;
}

PropertyResult result_of(const Network& network, Verdict verdict, Detail detail) {
    PropertyResult answer;
    if (verdict.about.valid()) answer.text = network.properties[verdict.about].text;
    if (verdict.run) answer.trace = with_rows(project(network, *verdict.run), detail);
    verdict.run.reset();
    answer.verdict = std::move(verdict);
    return answer;
}

ModelErrorTrace error_trace_of(const Network& network, const ModelError& error, Detail detail) {
    return {std::string(word(error.kind)), text_of(network, error), with_rows(project(network, error.run), detail)};
}

void name_places(Report& report, const Sources& sources) {
    for (PropertyResult& answer : report.answers)
        if (sources.contains(answer.verdict.origin.source))
            answer.place = file_and_line(sources, answer.verdict.origin);
    if (report.profile) name_places(*report.profile, sources);
}

Tally tally(const Report& report) {
    Tally tally;
    for (const PropertyResult& answer : report.answers) {
        const Verdict& verdict = answer.verdict;
        if (verdict.outcome == Outcome::Holds) ++tally.holds;
        if (verdict.outcome == Outcome::Violated) ++tally.violated;
        if (verdict.outcome == Outcome::Unknown) ++(verdict.declared ? tally.unknown : tally.undeclared_unknown);
        if (verdict.outcome != Outcome::Unknown && !as_expected(verdict)) ++tally.unexpected;
    }
    return tally;
}

bool has_result(const Report& report, const Property& property) {
    return std::ranges::any_of(report.answers, [&](const PropertyResult& answer) {
        const std::string& name = answer.verdict.property;
        return name == property.name || name.starts_with(property.name + '.');
    });
}

}  // namespace grafverif
