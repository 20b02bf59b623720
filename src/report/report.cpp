// SPDX-License-Identifier: MIT
#include "report/report.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "report/profile.hpp"
#include "run/project.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

template <class Controllers>
std::string mode_text(const Controllers& controllers) {
    bool searches = false, cycles = false;
    for (const auto& controller : controllers)
        (controller.words.mode == ExecutionMode::EveryCycle ? cycles : searches) = true;
    std::string mode = searches ? "stability-search" : "";
    if (cycles) mode += searches ? ", every-cycle" : "every-cycle";
    return mode;
}

/// Returns text such as `task cycle 10ms` or `task cycles: press 10ms, door 5ms..10ms, lamp zero`. The result is empty
/// if no controller has a task cycle.
template <class Controllers>
std::string cycle_text(const Controllers& controllers) {
    std::vector<std::string> each;
    bool zero = true;
    for (const auto& controller : controllers) {
        const std::optional<TaskCycle>& cycle = controller.words.cycle;
        zero = zero && !cycle;
        std::string time = cycle ? duration_text(cycle->least_ms) : "zero";
        if (cycle && cycle->least_ms != cycle->most_ms) time += ".." + duration_text(cycle->most_ms);
        each.push_back(controllers.size() > 1 ? controller.words.name + " " + time : time);
    }
    if (zero) return {};
    return fmt::format("task cycle{} {}", each.size() > 1 ? "s:" : "", fmt::join(each, ", "));
}

}  // namespace

CheckSettings settings_of(const Network& network, std::string engine) {
    return {.engine = std::move(engine),
            .mode = mode_text(network.controllers),
            .grain = network.grain == Grain::Atomic ? "atomic" : "phased",
            .time_unit_ms = network.time_unit_ms,
            .cycle = cycle_text(network.controllers),
            .constants = network.constants};
}

CheckSettings settings_of(const TransitionSystem& system, std::string engine, std::string untimed) {
    const bool timed = system.ticks.valid();
    const std::string cycle = cycle_text(system.controllers);
    return {.engine = std::move(engine),
            .mode = mode_text(system.controllers),
            .time_unit_ms = 0,
            .cycle = timed || cycle.empty() ? cycle : cycle + " not modelled: a scan may begin at any time",
            .untimed = std::move(untimed),
            .constants = system.constants};
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

std::string_view certificate_word(const CertificateSummary& certificate, const std::string& property) {
    const auto found = std::ranges::find(certificate.certified, property, &CertificateSummary::Certified::property);
    return found == certificate.certified.end() ? "none" : word(found->kind);
}

std::string certificate_text(const CertificateSummary& certificate, const std::string& property) {
    if (const std::string_view kind = certificate_word(certificate, property); kind != "none")
        return std::string(kind) + " in " + certificate.folder;
    for (const CertificateSummary::Omitted& one : certificate.omitted)
        if (one.property == property) return "none: " + one.reason;
    return "none";
}

bool has_result(const Report& report, const Property& property) {
    return std::ranges::any_of(report.answers, [&](const PropertyResult& answer) {
        const std::string& name = answer.verdict.property;
        return name == property.name || name.starts_with(property.name + '.');
    });
}

}  // namespace grafverif
