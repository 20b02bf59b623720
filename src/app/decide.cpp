// SPDX-License-Identifier: MIT
#include "app/decide.hpp"

#include <algorithm>
#include <chrono>
#include <ostream>
#include <sstream>

#include "app/engines.hpp"
#include "app/stop_text.hpp"
#include "app/system/watchdog.hpp"
#include "check/shares.hpp"
#include "pipeline/models.hpp"
#include "pipeline/program/check.hpp"
#include "pipeline/remedies.hpp"
#include "pipeline/why.hpp"
#include "report/profile.hpp"
#include "report/report.hpp"
#include "report/settings_text.hpp"
#include "report/why.hpp"
#include "support/messages.hpp"
#include "support/messages_choice.hpp"
#include "support/messages_program.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif::app {

namespace {

/// Runs the timed engine that the options select. Returns nothing after an error.
std::optional<Report> timed_report(const Model& model, Id<ClosedLoop> id, CommandContext& job,
                                   const CheckOptions& options) {
    const auto network = network_of(model, id, job);
    if (!network || !all_known(options.properties, property_names(*network), job.diagnostics)) return {};
    LoopToCheck loop = loop_to_check(model, id, *network);
    loop.disabled_corrections = !job.options.disabled_corrections.empty();
    return job.options.engine == Engine::Verifyta ? check_by_verifyta(loop, options, job.diagnostics)
                                                  : check(loop, options);
}

/// Decides the properties by PDR or BMC. If a certificate is requested, it contains the witness circuits of the
/// invariants, and the runs.
Report certified_states(const SystemToCheck& system, StateSearch search, const CheckOptions& options,
                        std::optional<Certificate>& certificate) {
    if (!certificate) return check_states(system, options, search);
    pdr::SolverLimits limits{.deadline = options.limits.deadline, .stop = options.limits.stop};
    limits.memory = options.limits.memory.value_or(limits.memory);
    search.proved = [&](const auto&... invariant) { add_witness(invariant..., limits, *certificate); };
    search.shown = [&](const auto&... run) { add_run(run..., *certificate); };
    return check_states(system, options, search);
}

/// Decides the properties of a transition system with the selected engine; the default is the portfolio.
std::optional<Report> engine_report(const SystemToCheck& system, CommandContext& job, const CheckOptions& options,
                                    std::optional<Certificate>& certificate) {
    switch (job.options.engine) {
    case Engine::Embedded:
    case Engine::Auto: return check_together(system, options);
    case Engine::Pdr: return certified_states(system, {}, options, certificate);
    case Engine::Bmc: return certified_states(system, bounded_search(job.options.max_steps), options, certificate);
    case Engine::Abc: return check_by_abc(system, options, job.diagnostics);
    case Engine::Hwmcc: return check_by_command(system, job.options.engine_command, options);
    case Engine::Nusmv: return check_by_nusmv(system, "NuSMV", options, job.diagnostics);
    case Engine::Nuxmv: return check_by_nusmv(system, "nuXmv", options, job.diagnostics);
    case Engine::Symbolic:
    case Engine::Timed:
    case Engine::Verifyta: break;
    }
    return check(system, options);
}

/// Decides the properties of a transition system, and creates the certificate if it is requested.
std::optional<Report> system_report(const SystemToCheck& system, CommandContext& job, const CheckOptions& options,
                                    std::optional<Certificate>& certificate) {
    if (job.options.certificate) certificate.emplace();
    std::optional<Report> report = engine_report(system, job, options, certificate);
    if (report && certificate) certify_again(system, *report, options, *certificate);
    return report;
}

/// Adds verdicts that do not concern the transition system to the omitted verdicts of the certificate.
void note_omitted(const Report& report, CertificateSummary& summary) {
    for (const PropertyResult& answer : report.answers)
        if (const std::string& name = answer.verdict.property; !summary.contains(name))
            summary.omitted.push_back({name, "the circuit does not contain the property"});
}

std::optional<Report> untimed_report(const Model& model, Id<ClosedLoop> id, CommandContext& job,
                                     const CheckOptions& options, std::optional<Certificate>& certificate) {
    const ModelOptions how = model_options(job.options, model.loops[id]);
    const auto system = system_with_probes(model, id, how, job.diagnostics);
    if (!system || !all_known(options.properties, property_names(*system), job.diagnostics)) return {};
    return system_report(system_to_check(*system, model, id, how), job, options, certificate);
}

std::optional<Report> chart_report(const Model& model, Id<Chart> chart, CommandContext& job,
                                   const CheckOptions& options, std::optional<Certificate>& certificate) {
    const auto decide = [&](const SystemToCheck& system) { return system_report(system, job, options, certificate); };
    return check_chart(model, chart, model_options(job.options), options, job.diagnostics, decide);
}

void add_stop_cause(Report& report, bool by_user, const Options& options) {
    for (PropertyResult& answer : report.answers)
        if (answer.verdict.obstacle == UnknownReason::Stopped)
            answer.verdict.reason = with_who_stopped(std::move(answer.verdict.reason), by_user, options);
}

/// Returns the requested properties. A name such as `S.X7`, which selects the result for one step, is replaced by the
/// name of the property, `S`.
std::vector<std::string> complete_properties(std::vector<std::string> requested) {
    for (std::string& name : requested) name.resize(std::min(name.size(), name.find('.')));
    return requested;
}

/// If `requested` names single steps, removes the results for other steps. Returns false if `requested` names a step
/// that has no result.
bool keep_requested(const std::vector<std::string>& requested, Report& report, Diagnostics& diagnostics) {
    const auto has = [](const std::vector<std::string>& names, const std::string& name) {
        return std::ranges::find(names, name) != names.end();
    };
    std::vector<std::string> known;
    for (const PropertyResult& answer : report.answers) known.push_back(answer.verdict.property);
    for (const std::string& name : requested) {
        if (name.find('.') == std::string::npos || has(known, name)) continue;
        diagnostics.add(messages::no_such_choice("property", name, known, nearest_of(name, known)));
        return false;
    }
    std::erase_if(report.answers, [&](const PropertyResult& answer) {
        const std::string family = family_of(answer);
        return !requested.empty() && !family.empty() && !has(requested, family) &&
               !has(requested, answer.verdict.property);
    });
    return true;
}

/// If a limit ended the check of a loop, checks the open properties with other options (remedies).
void try_remedies(const Model& model, CommandContext& job, const ResourceLimits& bounds, CheckOptions options,
                  Deadline end, Decided& decided) {
    if (!decided.loop.valid() || bounds.interrupted() || !job.options.disabled_corrections.empty()) return;
    if (job.options.engine == Engine::Hwmcc || !needs_remedies(decided.report)) return;
    const ModelOptions how = model_options(job.options, model.loops[decided.loop]);
    const bool by_default = job.options.engine == Engine::Embedded || job.options.engine == Engine::Auto ||
                            job.options.engine == Engine::Timed;
    const LimitedCheck check{model, decided.loop, how, decided.timed, by_default, options};
    decided.trials = tried_remedies(check, decided.report, end);
    keep_memory_back();  // a check with other options may have used the reserved memory
}

/// Creates the certificate of a timed check.
void add_certificate(const Model& model, const CommandContext& job, const CheckOptions& options, Decided& decided) {
    Diagnostics reported;  // the check has already reported these diagnostics
    const auto network = grafverif::network_of(
        model, decided.loop, ComposeOptions{job.options.grain, job.options.mode, job.options.without}, reported);
    if (!network) return;
    decided.certificate = certificate_of(loop_to_check(model, decided.loop, *network), decided.report, options);
    std::vector<std::string>& failures = decided.report.failures;
    failures.insert(failures.end(), decided.certificate->failures.begin(), decided.certificate->failures.end());
}

}  // namespace

std::optional<Decided> decide(const Model& model, CommandContext& job, ResourceLimits& bounds, bool witnesses,
                              const Streams& streams) {
    CheckOptions options{complete_properties(job.options.properties), witnesses, job.options.verbose, bounds.limits(),
                         job.options.stats};
    options.whole = job.options.whole;
    options.jobs = job.options.jobs;
    if (!job.options.quiet)
        options.many = [&](StateProfile profile) {
            std::ostringstream text;
            name_places(profile, job.sources);
            print_profile(profile, text);
            bounds.print(std::move(text).str());
        };
    const bool timed = job.options.engine == Engine::Timed || job.options.engine == Engine::Verifyta;
    const bool of_chart = is_of_a_chart(model, job.options) && !timed;
    const Deadline deadline = options.limits.deadline;
    const auto begin = std::chrono::steady_clock::now();
    const auto reserved = trial_time(of_chart ? Deadline{} : deadline);
    if (deadline) options.limits.deadline = *deadline - reserved;
    // With --why or --certificate, half of the time limit is reserved for finding the elements on which the proofs
    // depend, or for the certificate.
    CheckOptions of_check = options;
    if (job.options.why || job.options.certificate) of_check.limits.deadline = share_of(options.limits.deadline, 2);
    Decided decided;
    std::optional<Report> found;
    if (of_chart) {
        const auto chart = chosen_chart(model, job);
        if (!chart) return {};
        if (!job.options.quiet)
            streams.err << "note: `" << model.charts[*chart].name
                        << "` is not part of a closed loop: the reachability of its steps is checked in the untimed "
                           "model, with free inputs"
                        << (job.options.stats ? "; --stats applies only to timed checks" : "")
                        << (job.options.why ? "; --why applies only to closed loops" : "") << '\n';
        decided.chart = *chart;
        found = chart_report(model, *chart, job, options, decided.certificate);
    } else if (const auto loop = chosen_loop(model, job)) {
        decided.loop = *loop;
        decided.timed = !job.options.check_untimed;
        found = decided.timed ? timed_report(model, *loop, job, of_check)
                              : untimed_report(model, *loop, job, of_check, decided.certificate);
    }
    if (!found) return {};
    if (!keep_requested(job.options.properties, *found, job.diagnostics)) return {};
    decided.report = std::move(*found);
    if (decided.certificate) {
        std::vector<std::string>& failures = decided.report.failures;
        failures.insert(failures.end(), decided.certificate->failures.begin(), decided.certificate->failures.end());
        note_omitted(decided.report, decided.certificate->summary);
    }
    const auto used = std::chrono::steady_clock::now() - begin;
    try_remedies(model, job, bounds, options, end_of_trials(deadline, reserved, used), decided);
    options.limits.deadline = deadline;
    if (job.options.why && decided.timed)
        decided.why = why_it_holds(model, decided.loop, model_options(job.options), options, decided.report);
    if (decided.why) name_places(*decided.why, job.sources);
    if (job.options.certificate && decided.timed) add_certificate(model, job, options, decided);
    if (decided.certificate) decided.certificate->summary.folder = *job.options.certificate;
    name_places(decided.report, job.sources);
    add_stop_cause(decided.report, bounds.interrupted(), job.options);
    return decided;
}

std::optional<std::pair<Model, Decided>> decide_program(CommandContext& job, ResourceLimits& bounds, bool witnesses) {
    const Options& requested = job.options;
    const auto program = read_source(requested.operands[0], job);
    const auto properties = program ? read_source(*requested.property_file, job) : std::nullopt;
    if (!properties) return {};
    CheckOptions options{requested.properties, witnesses, requested.verbose, bounds.limits()};
    options.jobs = requested.jobs;
    auto checked = check_program(*program, *properties, job.sources, options, job.diagnostics, requested.why);
    if (!checked) return {};
    Decided decided;
    decided.report = std::move(checked->report);
    decided.why = std::move(checked->why);
    if (decided.why) name_places(*decided.why, job.sources);
    decided.chart = {0};
    name_places(decided.report, job.sources);
    return std::pair(std::move(checked->model), std::move(decided));
}

ExitCode exit_code(const Report& report, bool stopped) {
    const Tally count = tally(report);
    if (!report.failures.empty()) return ExitCode::Failure;
    if (count.unexpected != 0 || !report.error_traces.empty()) return ExitCode::Verdict;
    return count.unknown != 0 || stopped ? ExitCode::Unknown : ExitCode::Done;
}

}  // namespace grafverif::app
