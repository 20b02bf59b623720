// SPDX-License-Identifier: MIT
#include "lsp/background_checker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <sstream>
#include <system_error>
#include <utility>

#include "lsp/trace_locations.hpp"
#include "pipeline/check.hpp"
#include "pipeline/models.hpp"
#include "report/terminal.hpp"
#include "support/messages.hpp"
#include "support/printable.hpp"

namespace grafverif::lsp {

namespace {

constexpr auto progress_interval = std::chrono::milliseconds(250);

/// True if `origin` is in the main file of a root, which is its first source. Results about an included file belong to
/// the root of that file.
bool is_of(const Root&, Span origin) { return origin.source.valid() && origin.source.index == 0; }

std::string outcome_text(const Verdict& verdict) {
    std::string words(word(verdict.outcome));
    if (verdict.vacuous) words += ", vacuously";
    if (verdict.outcome != Outcome::Unknown && verdict.expected_violated)
        words += as_expected(verdict) ? ", as expected" : ", unexpectedly";
    return words;
}

/// Returns the text that `check` prints for this property alone.
std::string reported_by_check(const Report& report, const PropertyResult& answer) {
    Report one = report;
    one.answers = {answer};
    std::ostringstream text;
    print_report(one, {.verbose = true}, text);
    return printable_lines(std::move(text).str());
}

}  // namespace

BackgroundChecker::BackgroundChecker(Callbacks callbacks, std::optional<std::chrono::milliseconds> response_timeout)
    : callbacks_(std::move(callbacks)), response_timeout_(response_timeout), thread_([this] { work(); }) {}

BackgroundChecker::~BackgroundChecker() {
    {
        const std::lock_guard hold(mutex_);
        over_ = true;
        stop_ = true;
    }
    wake_.notify_all();
    thread_.join();
}

void BackgroundChecker::submit(Task task) {
    const std::lock_guard hold(mutex_);
    if (task.what == Task::What::Models) tasks_.push_front(std::move(task));
    else tasks_.push_back(std::move(task));
    wake_.notify_all();
}

void BackgroundChecker::keep(const std::function<bool(const Root&)>& current) {
    const std::lock_guard hold(mutex_);
    std::erase_if(tasks_, [&](const Task& task) { return !current(*task.root); });
    if (at_hand_ != nullptr && !current(*at_hand_)) stop_ = true;
}

void BackgroundChecker::give_up() {
    keep([](const Root&) { return false; });
}

void BackgroundChecker::work() {
    for (;;) {
        Task task;
        {
            std::unique_lock hold(mutex_);
            at_hand_ = nullptr;
            wake_.wait(hold, [this] { return over_ || !tasks_.empty(); });
            if (over_) return;
            task = std::move(tasks_.front());
            tasks_.pop_front();
            at_hand_ = task.root;
            stop_ = false;
        }
        try {
            if (task.what == Task::What::Models) make_models(task);
            else prove(task);
            const std::lock_guard hold(mutex_);
            const auto proves = [](const Task& other) { return other.what == Task::What::Proofs; };
            if (std::ranges::none_of(tasks_, proves)) callbacks_.progress("");
        } catch (const std::bad_alloc&) {  // the failure cannot be reported, because a report requires memory
        } catch (const std::system_error&) {
        }
    }
}

/// Calls `work` to determine the results of the diagnostic source `source` (such as `models`), and reports the results.
/// Exceptions of types std::bad_alloc and std::system_error are reported as diagnostics.
template <class Work>
void BackgroundChecker::run_and_report(const Task& task, const std::string& source, const Work& work) {
    Found outcome{task.root, source, {}, {}};
    Diagnostics refused;
    try {
        work(outcome);
    } catch (const std::bad_alloc&) {
        refused.add(messages::out_of_memory({}));
    } catch (const std::system_error& failure) {
        refused.add(messages::io_error(failure.what()));
    }
    if (refused.has_errors()) outcome = {task.root, source, lsp_diagnostics(refused, *task.root->places), {}};
    if (!stop_) callbacks_.found(std::move(outcome));
}

/// Derives the models of the task's root, and reports the errors that the derivation finds.
void BackgroundChecker::make_models(const Task& task) {
    run_and_report(task, "models", [&](Found& outcome) {
        outcome.diagnostics = lsp_diagnostics(refused_models(task), *task.root->places);
    });
}

Diagnostics BackgroundChecker::refused_models(const Task& task) const {
    const Model& model = *task.root->reading.model;
    Diagnostics diagnostics;
    for (const Id<ClosedLoop> loop : model.loops.ids()) {
        if (stop_) break;
        network_of(model, loop, ModelOptions{}, diagnostics);
    }
    for (const Id<Chart> chart : model.charts.ids()) {
        if (stop_) break;
        const bool controls = std::ranges::any_of(model.loops, [&](const ClosedLoop& loop) {
            return std::ranges::any_of(loop.controllers, [&](const auto& each) { return each.chart == chart; });
        });
        if (!controls && !model.charts[chart].program && !is_repeated(model.charts[chart]))
            equations_of(model, chart, diagnostics);
    }
    return diagnostics;
}

Limits BackgroundChecker::limits(const std::string& what) {
    Limits limits;
    limits.stop = &stop_;
    const auto begin = std::chrono::steady_clock::now();
    if (response_timeout_) limits.deadline = begin + *response_timeout_;
    limits.progress = [this, what, last = begin](const Progress& now) mutable {
        if (std::chrono::steady_clock::now() - last < progress_interval) return;
        last = std::chrono::steady_clock::now();
        callbacks_.progress(what + ": " + printable(now.words()));
    };
    return limits;
}

void BackgroundChecker::prove(const Task& task) {
    const Root& root = *task.root;
    const Model& model = *root.reading.model;
    const auto wanted = [&](const std::string& name, Span origin) {
        return task.only.empty() ? is_of(root, origin) : task.only == name;
    };
    const auto each = [&](const std::string& name, Span origin, const char* kind, const auto& find_out) {
        if (stop_ || !wanted(name, origin)) return;
        callbacks_.progress(name);
        run_and_report(task, kind + name, find_out);
    };
    for (const Id<ClosedLoop> loop : model.loops.ids())
        each(model.loops[loop].name, model.loops[loop].origin, "loop ",
             [&](Found& outcome) { prove_loop(root, loop, outcome); });
    for (const Id<Chart> chart : model.charts.ids())
        if (!model.charts[chart].program && !is_repeated(model.charts[chart]))
            each(model.charts[chart].name, model.charts[chart].origin, "chart ",
                 [&](Found& outcome) { look_into(root, chart, outcome); });
}

void BackgroundChecker::prove_loop(const Root& root, Id<ClosedLoop> loop, Found& outcome) {
    const Model& model = *root.reading.model;
    CheckOptions options;
    options.limits = limits(model.loops[loop].name);
    Diagnostics refused;
    const auto report = check(model, loop, ModelOptions{}, options, refused);
    if (!report) return;  // the task that derives the models reports the reason
    const TraceLocations trace_locations(model, loop, *root.places);
    for (const PropertyResult& answer : report->answers) {
        const Verdict& verdict = answer.verdict;
        outcome.verdicts["loop " + model.loops[loop].name + "/q " + verdict.property] = {
            outcome_text(verdict), reported_by_check(*report, answer)};
        if (as_expected(verdict) || (verdict.outcome == Outcome::Unknown && !verdict.declared)) continue;
        const bool open = verdict.outcome == Outcome::Unknown;
        LspDiagnostic diagnostic{
            root.places->of(verdict.origin.source.valid() ? verdict.origin : model.loops[loop].origin),
            open ? Severity::Warning : Severity::Error,
            open ? "unknown" : std::string(word(verdict.outcome)),
            "",
            {},
            {}};
        diagnostic.message =
            fmt::format("`{}` {}{}", verdict.property,
                        open                                   ? "is undecided: " + printable(verdict.reason)
                        : verdict.outcome == Outcome::Violated ? "is violated"
                                                               : "holds, but is expected to be violated",
                        answer.text.empty() ? "" : ": " + printable(answer.text));
        if (answer.trace && !open) diagnostic.related = trace_locations.of(*answer.trace);
        outcome.diagnostics.push_back(std::move(diagnostic));
    }
    for (const ModelErrorTrace& breakdown : report->error_traces)
        outcome.diagnostics.push_back({root.places->of(model.loops[loop].origin),
                                       Severity::Error,
                                       breakdown.code,
                                       printable(breakdown.message),
                                       trace_locations.of(breakdown.trace),
                                       {}});
}

void BackgroundChecker::look_into(const Root& root, Id<Chart> chart, Found& outcome) {
    const Model& model = *root.reading.model;
    Diagnostics refused;
    const auto analysis = analysis_of(model, chart, {}, limits(model.charts[chart].name), refused);
    if (!analysis) return;
    const TraceLocations trace_locations(model, chart, *root.places);
    for (const Finding& finding : analysis->findings) {
        if (!is_open(finding)) continue;
        LspDiagnostic diagnostic{root.places->of(finding.origin),
                                 finding.level == Finding::Level::Error ? Severity::Error : Severity::Warning,
                                 finding.code,
                                 printable(finding.message),
                                 {},
                                 {}};
        for (const Finding::Related& related : finding.related)
            if (related.where.source.valid())
                diagnostic.related.push_back({root.places->of(related.where), printable(related.message)});
        if (finding.evidence)
            for (Related& each : trace_locations.of(*finding.evidence)) diagnostic.related.push_back(std::move(each));
        outcome.diagnostics.push_back(std::move(diagnostic));
    }
}

}  // namespace grafverif::lsp
