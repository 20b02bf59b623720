// SPDX-License-Identifier: MIT
// The embedded symbolic engine and NuSMV or nuXmv, run for `check`. No trace is shown that does not replay on the rules.
#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <ranges>
#include <sstream>
#include <string_view>

#include "app/system/process.hpp"
#include "app/progress_line.hpp"
#include "app/traces.hpp"
#include "app/untimed.hpp"
#include "check/external/nusmv.hpp"
#include "check/symbolic/symbolic.hpp"
#include "emit/nusmv/nusmv.hpp"
#include "ir/step_names.hpp"
#include "run/project.hpp"
#include "run/replay.hpp"
#include "support/messages.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif::app {

namespace {

/// Turns verdicts and runs into a report; runs that do not replay are not told. Those of the embedded engine are failures;
/// a program whose run does not replay is not believed.
class SystemReporter {
public:
    enum class Of { EmbeddedEngine, Program };

    SystemReporter(const SystemToCheck& check, Of of, std::string engine, const Options& options,
                   const std::vector<Verdict>& verdicts)
        : check_(check),
          of_(of),
          unproven_(unproven_faults(check.system, verdicts)),
          detail_(options.verbose ? Detail::Everything : Detail::Chart),
          witnesses_(options.verbose || options.format == Format::Json || options.trace_vcd || options.trace_svg) {
        findings_.report = {check.system.name,
                            basis_of(check.system, std::move(engine), check.abstraction.words), {}, {}};
        findings_.report.basis.grain = check.abstraction.grain;
    }

    void add(Verdict verdict, std::optional<SystemRun> run) {
        const bool told = verdict.outcome != Outcome::Holds || witnesses_;
        if (run && of_ == Of::Program) {
            if (const auto found = disagreement(project(check_.system, *run), check_.charts))
                distrust(verdict, replay_failure("its trace", *found));
        } else if (run && told && !replays(*run, fmt::format("the trace of `{}`", verdict.property))) {
            run.reset();
        }
        if (!told || verdict.outcome == Outcome::Unknown) run.reset();
        if (const auto found = run ? untimely(project(check_.system, *run)) : std::nullopt)
            verdict.notes.push_back(fmt::format("no plant gives this run: {}/{} is over in it, and {}/{} is not",
                                                duration_text(found->longer_ms), step_variable_name(found->step),
                                                duration_text(found->shorter_ms), step_variable_name(found->step)));
        std::string carries = carries_words(check_, check_.system.properties[verdict.about], verdict, unproven_);
        Answer answer = answer_of(check_.system, std::move(verdict), run, detail_);
        answer.carries = std::move(carries);
        findings_.report.answers.push_back(std::move(answer));
    }

    void add(const SystemFault& fault) {
        if (!fault.run.states.empty()) replays(fault.run, "the way to the fault");
        findings_.report.breakdowns.push_back(breakdown_of(check_.system, fault, detail_));
    }

    /// What cannot be asked of the system, each in its place among the properties.
    void add_omitted(const std::vector<std::string>& asked) {
        std::vector<Answer>& answers = findings_.report.answers;
        for (const TransitionSystem::Omitted& omitted : check_.system.omitted | std::views::reverse) {
            const Property& property = omitted.property;
            if (!asked.empty() && !is_asked(property.name, asked)) continue;
            Answer answer{.text = property.text};
            answer.verdict = verdict_on({}, property);
            answer.verdict.obstacle = Obstacle::Unsupported;
            answer.verdict.reason = omitted.reason;
            answer.verdict.declared = true;
            const std::size_t place = asked.empty() ? std::min(omitted.before, answers.size()) : answers.size();
            answers.insert(answers.begin() + static_cast<std::ptrdiff_t>(place), std::move(answer));
        }
    }

    Findings findings() && { return std::move(findings_); }

private:
    bool replays(const SystemRun& run, const std::string& what) {
        const std::optional<Disagreement> found = disagreement(project(check_.system, run), check_.charts);
        if (found) findings_.failures.push_back(replay_failure(what, *found));
        return !found;
    }

    const SystemToCheck& check_;
    Of of_ = Of::EmbeddedEngine;
    std::vector<std::string> unproven_;
    Detail detail_;
    bool witnesses_;   ///< whether anybody looks at them
    Findings findings_ = {};
};

std::vector<std::size_t> asked_properties(const TransitionSystem& system, const Options& options) {
    std::vector<std::size_t> asked;
    for (const Id<Property> id : system.properties.ids()) {
        const bool all = options.properties.empty();
        if (all || is_asked(system.properties[id].name, options.properties)) asked.push_back(id.index);
    }
    return asked;
}

}  // namespace

bool is_asked(std::string_view property, const std::vector<std::string>& asked) {
    return std::ranges::any_of(asked, [&](const std::string& name) {
        return property == name || (property.starts_with(name) && property.substr(name.size()).starts_with('.'));
    });
}

Findings check_symbolically(const SystemToCheck& check, const Options& options, const Streams& streams,
                            const Interrupt& interrupt) {
    SymbolicOptions symbolic;
    for (const std::size_t index : asked_properties(check.system, options))
        symbolic.properties.push_back(check.system.properties[{static_cast<std::uint32_t>(index)}].name);
    symbolic.max_memory = options.max_memory.value_or(symbolic.max_memory);
    symbolic.deadline = options.deadline;
    symbolic.stop = &interrupt.asked();
    SymbolicResult result;
    if (options.properties.empty() || !symbolic.properties.empty()) {   // no names would ask for all
        ProgressLine line(streams.err, streams.err_is_terminal && !options.quiet);
        symbolic.progress = [&line](const SymbolicProgress& now) {
            line.show([&] {
                return fmt::format("{} steps deep, {} MiB, {:.0f} s", now.depth, now.bytes >> 20U, now.seconds);
            });
        };
        result = check_symbolic(check.system, symbolic);
    }
    SystemReporter reporter(check, SystemReporter::Of::EmbeddedEngine, "symbolic", options, result.verdicts);
    if (result.fault) reporter.add(*result.fault);
    for (std::size_t i = 0; i < result.verdicts.size(); ++i)
        reporter.add(std::move(result.verdicts[i]), std::move(result.runs[i]));
    reporter.add_omitted(options.properties);
    return std::move(reporter).findings();
}

std::optional<Findings> check_by_nusmv(const SystemToCheck& check, const std::string& program, Job& job,
                                       const Interrupt& interrupt) {
    const auto path = find_program(program);
    if (!path) {
        job.diagnostics.add(messages::missing_program(program, "--engine symbolic"));
        return {};
    }
    const SystemSpelling spelling = nusmv::spelling(check.system);
    const std::vector<std::size_t> properties = asked_properties(check.system, job.options);
    std::ostringstream model;
    nusmv::emit(check.system, model);
    const TemporaryFolder folder;
    folder.write("model.smv", std::move(model).str());
    folder.write("commands", nusmv_commands("model.smv", spelling, properties));

    const auto start = std::chrono::steady_clock::now();
    const ProgramLimits limits{.deadline = job.options.deadline, .stop = &interrupt.asked(), .folder = folder.path()};
    const ProgramResult said = run_program({path->string(), "-source", "commands"}, "", limits);
    NusmvResult result = read_nusmv(check.system, spelling, properties, said);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    SystemReporter reporter(check, SystemReporter::Of::Program, program, job.options, result.verdicts);
    for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
        result.verdicts[i].seconds = seconds;
        reporter.add(std::move(result.verdicts[i]), std::move(result.runs[i]));
    }
    reporter.add_omitted(job.options.properties);
    return std::move(reporter).findings();
}

}  // namespace grafverif::app
