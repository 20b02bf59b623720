// SPDX-License-Identifier: MIT
// Checks systems with the embedded symbolic engine, and creates reports on untimed models.
#include <fmt/format.h>

#include <algorithm>
#include <ranges>
#include <utility>

#include "check/decomposition/interleaved.hpp"
#include "check/symbolic/symbolic.hpp"
#include "pipeline/check.hpp"
#include "pipeline/explain.hpp"
#include "pipeline/models.hpp"
#include "report/report.hpp"
#include "run/project.hpp"
#include "support/messages.hpp"
#include "support/messages_choice.hpp"
#include "syntax/print/dialect.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif {

namespace {

Detail detail(const CheckOptions& options) { return options.every_move ? Detail::Everything : Detail::Chart; }

}  // namespace

std::string replay_failure(std::string_view what, const Disagreement& disagreement) {
    return fmt::format("{} fails the replay under the rules of IEC 60848: {}: {} (move {})", what, disagreement.where,
                       disagreement.what, disagreement.move);
}

namespace {

/// True if `requested` selects the property. The name `S` also selects `S.X7`.
bool is_requested(std::string_view property, const std::vector<std::string>& requested) {
    return std::ranges::any_of(requested, [&](const std::string& name) {
        return property == name || (property.starts_with(name) && property.substr(name.size()).starts_with('.'));
    });
}

}  // namespace

bool all_known(const std::vector<std::string>& names, const std::vector<std::string>& known, Diagnostics& diagnostics) {
    for (const std::string& name : names) {
        if (std::ranges::any_of(known, [&](const std::string& each) { return is_requested(each, {name}); })) continue;
        diagnostics.add(messages::no_such_choice("property", name, known, nearest_of(name, known)));
        return false;
    }
    return true;
}

std::vector<std::string> property_names(const Network& network) {
    std::vector<std::string> names;
    for (const Property& property : network.properties) names.push_back(property.name);
    if (std::ranges::find(network.properties, Pattern::NoTimelock, &Property::pattern) == network.properties.end())
        names.emplace_back("no_timelock");  // every check decides this property
    return names;
}

std::vector<std::string> property_names(const TransitionSystem& system) {
    std::vector<std::string> names;
    for (const Property& property : system.properties)
        if (!is_probe(property)) names.push_back(property.name);
    for (const TransitionSystem::Omitted& omitted : system.omitted) names.push_back(omitted.property.name);
    return names;
}

std::vector<std::size_t> selected_properties(const TransitionSystem& system, const std::vector<std::string>& names) {
    std::vector<std::size_t> requested;
    for (const Id<Property> id : system.properties.ids())
        if (names.empty() || is_requested(system.properties[id].name, names)) requested.push_back(id.index);
    return requested;
}

std::vector<std::string> requested_names(const TransitionSystem& system, const std::vector<std::string>& names) {
    std::vector<std::string> requested;
    for (const std::size_t index : selected_properties(system, names))
        requested.push_back(system.properties[{static_cast<std::uint32_t>(index)}].name);
    return requested;
}

SystemReporter::SystemReporter(const SystemToCheck& check, Of of, std::string engine, const CheckOptions& options,
                               const std::vector<Verdict>& verdicts)
    : check_(check), of_(of), options_(options), unproven_(unproven_faults(check.system, verdicts)) {
    report_ = {check.system.name, settings_of(check.system, std::move(engine), check.abstraction.words)};
    report_.settings.grain = check.abstraction.grain;
}

void SystemReporter::add(Verdict verdict, std::optional<SystemRun> run) {
    if (is_probe(check_.system.properties[verdict.about])) return;
    const bool shows_trace = verdict.outcome != Outcome::Holds || options_.witnesses;
    if (run && of_ == Of::Program) {
        if (const auto found = disagreement(project(check_.system, *run), check_.charts))
            distrust(verdict, replay_failure("the trace", *found));
    } else if (run && shows_trace && !replays(*run, fmt::format("the trace of `{}`", verdict.property))) {
        run.reset();
    }
    if (!shows_trace || verdict.outcome == Outcome::Unknown) run.reset();
    if (const auto found = run ? untimely(project(check_.system, *run)) : std::nullopt)
        verdict.notes.push_back(
            fmt::format("no plant permits this run: {}/{} has expired in the run, but {}/{} has not",
                        duration_text(found->longer_ms), found->step.variable(), duration_text(found->shorter_ms),
                        found->step.variable()));
    std::string preservation = preservation_text(check_, check_.system.properties[verdict.about], verdict, unproven_);
    PropertyResult answer = result_of(check_.system, std::move(verdict), run, detail(options_));
    answer.preservation = std::move(preservation);
    if (run && answer.verdict.outcome == Outcome::Violated) explain(check_, *run, options_.limits, answer);
    report_.answers.push_back(std::move(answer));
}

void SystemReporter::add(const SystemFault& fault) {
    if (!fault.run.states.empty()) replays(fault.run, "the trace to the model error");
    report_.error_traces.push_back(error_trace_of(check_.system, fault, detail(options_)));
}

void SystemReporter::add_omitted() {
    const std::vector<std::string>& requested = options_.properties;
    std::vector<PropertyResult>& answers = report_.answers;
    for (const TransitionSystem::Omitted& omitted : check_.system.omitted | std::views::reverse) {
        const Property& property = omitted.property;
        if (is_probe(property)) continue;
        if (!requested.empty() && !is_requested(property.name, requested)) continue;
        PropertyResult answer{.text = property.text};
        answer.verdict = verdict_on({}, property);
        set_unknown(answer.verdict, UnknownReason::Unsupported, omitted.reason);
        answer.verdict.declared = true;
        const std::size_t place = requested.empty() ? std::min(omitted.before, answers.size()) : answers.size();
        answers.insert(answers.begin() + static_cast<std::ptrdiff_t>(place), std::move(answer));
    }
}

Report SystemReporter::report() && {
    if (of_ == Of::EmbeddedEngine) explain_dead_steps(check_, options_.limits, report_);
    return std::move(report_);
}

bool SystemReporter::replays(const SystemRun& run, const std::string& what) {
    const std::optional<Disagreement> found = disagreement(project(check_.system, run), check_.charts);
    if (found) report_.failures.push_back(replay_failure(what, *found));
    return !found;
}

Report check(const SystemToCheck& check, const CheckOptions& options) {
    SymbolicOptions symbolic;
    symbolic.witnesses = options.witnesses;
    symbolic.properties = requested_names(check.system, options.properties);
    set_limits(symbolic, options.limits);
    if (options.limits.progress)
        symbolic.progress = [&options](const SymbolicProgress& now) {
            options.limits.progress({[&now] { return words_of(now); }});
        };
    SymbolicResult result;
    if (options.properties.empty() || !symbolic.properties.empty())  // an empty list selects all properties
        result =
            options.whole ? check_symbolic(check.system, symbolic) : check_symbolic_by_parts(check.system, symbolic);
    SystemReporter reporter(check, SystemReporter::Of::EmbeddedEngine, "symbolic", options, result.verdicts);
    reporter.add_all(std::move(result));
    return std::move(reporter).report();
}

void query_steps(TransitionSystem& system) {
    for (const TransitionSystem::Controller& controller : system.controllers)
        for (const auto& step : controller.words.steps) {
            Property property{.name = "reachable." + step.name.variable(), .pattern = Pattern::Reachable};
            property.operands = {system.exprs.leaf(Op::Variable, step.variable.index)};
            system.properties.add(std::move(property));
        }
}

namespace {

/// Name of an implicit property of a chart under stability search: the situation becomes stable for all inputs. The
/// exploration of `analyse` that searches for `total-instability` decides this property.
constexpr const char* stabilises = "stabilises";

void add_stabilises(const Chart& chart, const Equations& equations, const Limits& limits, Report& report) {
    AnalyseOptions requested;
    requested.instability_only = true;
    set_limits(requested, limits);
    Analysis analysis = analyse(chart, equations, requested);
    report.failures.insert(report.failures.end(), analysis.failures.begin(), analysis.failures.end());
    PropertyResult answer{.text = "the situation becomes stable for all inputs"};
    Verdict& verdict = answer.verdict;
    verdict = {.property = stabilises, .declared = false, .seconds = analysis.seconds, .origin = chart.origin};
    const auto unstable = std::ranges::find(analysis.findings, "total-instability", &Finding::code);
    if (unstable != analysis.findings.end()) {
        verdict.outcome = Outcome::Violated;
        verdict.expected_violated = unstable->accepted.has_value();
        verdict.notes = {unstable->message};
        if (unstable->accepted) verdict.notes.push_back("accepted: " + *unstable->accepted);
        answer.trace = std::move(unstable->evidence);
        explain(chart, ExecutionMode::StabilitySearch, limits, answer);
    } else if (analysis.obstacle.empty()) {
        verdict.outcome = Outcome::Holds;
    } else {
        const bool stopped = analysis.obstacle.starts_with("stopped");
        set_unknown(verdict, stopped ? UnknownReason::Stopped : UnknownReason::Memory, analysis.obstacle);
    }
    if (const std::string& engine = report.settings.engine; engine != "symbolic")
        verdict.notes.push_back(fmt::format("decided by the exploration of `analyse`, not by {}", engine));
    report.answers.push_back(std::move(answer));
}

}  // namespace

std::optional<Report> check_untimed(const Model& model, Id<ClosedLoop> id, const ModelOptions& how,
                                    const CheckOptions& options, Diagnostics& diagnostics) {
    const auto system = system_with_probes(model, id, how, diagnostics);
    if (!system || !all_known(options.properties, property_names(*system), diagnostics)) return {};
    return check_together(system_to_check(*system, model, id, how), options);
}

std::optional<Report> check_untimed(const Model& model, Id<Chart> chart, const ModelOptions& how,
                                    const CheckOptions& options, Diagnostics& diagnostics) {
    const auto embedded = [&](const SystemToCheck& system) { return std::optional(check_together(system, options)); };
    return check_chart(model, chart, how, options, diagnostics, embedded);
}

std::optional<Report> check_chart(const Model& model, Id<Chart> chart, const ModelOptions& how,
                                  const CheckOptions& options, Diagnostics& diagnostics,
                                  const std::function<std::optional<Report>(const SystemToCheck& check)>& decide) {
    const auto equations = equations_of(model, chart, diagnostics);
    if (!equations) return {};
    TransitionSystem system = transition_system_of(model, chart, *equations, how.mode);
    query_steps(system);
    const bool stability = system.controllers.front().words.mode == ExecutionMode::StabilitySearch;
    std::vector<std::string> known = property_names(system);
    if (stability) known.emplace_back(stabilises);
    if (!all_known(options.properties, known, diagnostics)) return {};
    std::optional<Report> report = decide({system, {&model.charts[chart]}, abstraction_of(how, nullptr)});
    if (report && stability && (options.properties.empty() || is_requested(stabilises, options.properties)))
        add_stabilises(model.charts[chart], *equations, options.limits, *report);
    return report;
}

}  // namespace grafverif
