// SPDX-License-Identifier: MIT
#include "pipeline/variants/mutate.hpp"

#include <algorithm>
#include <utility>

#include "pipeline/check.hpp"
#include "pipeline/models.hpp"
#include "pipeline/staged_search.hpp"
#include "pipeline/variants/read_again.hpp"
#include "run/replay_test.hpp"
#include "syntax/language/format.hpp"
#include "syntax/language/parse.hpp"

namespace grafverif {

namespace {

CheckOptions quiet_check(const std::vector<std::string>& properties, const Limits& limits) {
    return {.properties = properties, .witnesses = false, .limits = limits, .jobs = 1};
}

/// Returns the verdicts on the properties of a closed loop. The report does not contain the causes of violations.
std::optional<Report> quiet_report(const Model& model, Id<ClosedLoop> loop, std::optional<ExecutionMode> mode,
                                   const std::vector<std::string>& properties, const Limits& limits,
                                   Diagnostics& diagnostics) {
    const auto network = network_of(model, loop, ModelOptions{.mode = mode}, diagnostics);
    if (!network) return {};
    // Selects only existing properties, because the mutation may remove an implicit property of the model.
    const std::vector<std::string> known = property_names(*network);
    std::vector<std::string> requested;
    for (const std::string& name : properties)
        if (const std::string whole = name.substr(0, name.find('.'));
            std::ranges::find(known, whole) != known.end() && std::ranges::find(requested, whole) == requested.end())
            requested.push_back(whole);
    if (requested.empty() && !properties.empty()) return Report{};
    return check_without_causes(loop_to_check(model, loop, *network), quiet_check(requested, limits));
}

/// Returns the diagnostic code of the first error.
std::string first_code(const Diagnostics& diagnostics) {
    for (const Diagnostic& each : diagnostics.all())
        if (each.severity == Severity::Error) return each.code;
    return "error";
}

/// True if `text` has no syntax errors and is already in the form that `format` writes.
bool reads_back(const std::string& text) {
    Sources sources;
    Diagnostics diagnostics;
    const tree::File file = parse_file(sources.add({"", text}), sources, diagnostics);
    return !file.broken && formatted(file) == text;
}

}  // namespace

MutantChecker::MutantChecker(const Model& model, Id<Chart> chart, Id<Source> main, const Sources& sources,
                             const ReadOptions& read, std::optional<ExecutionMode> mode)
    : model_(model), chart_(chart), main_(main), sources_(sources), read_(read), mode_(mode) {}

std::optional<Model> MutantChecker::model_of(const Mutant& mutant, Diagnostics& diagnostics) const {
    const std::string& file = sources_[model_.charts[chart_].origin.source].name;
    Sources read;
    return read_again(main_, {{file, mutant.text}}, sources_, read, read_, diagnostics);
}

std::string MutantChecker::shown(const OriginalVerdicts& requested, const std::string& property) const {
    return requested_.size() < 2 ? property : model_.loops[requested.loop].name + "." + property;
}

bool MutantChecker::is_changed(Id<Chart> id) const {
    const auto& own = model_.charts[chart_].steps;
    if (id == chart_ || own.empty()) return id == chart_;
    const Span first = own.begin()->origin;
    return first.source.valid() && std::ranges::any_of(model_.charts[id].steps, [&](const Chart::Step& step) {
               return step.origin.source == first.source && step.origin.begin == first.begin;
           });
}

bool MutantChecker::prepare(const Limits& limits) {
    Limits of_original = limits;
    of_original.deadline = share_of(limits.deadline, 4);
    bool stopped = false;
    for (const Id<ClosedLoop> loop : model_.loops.ids()) {
        const auto& controllers = model_.loops[loop].controllers;
        if (std::ranges::none_of(controllers, [&](const auto& each) { return is_changed(each.chart); })) continue;
        Diagnostics diagnostics;
        const auto report = quiet_report(model_, loop, mode_, {}, of_original, diagnostics);
        if (!report) continue;
        OriginalVerdicts requested{.loop = loop, .whole = report->error_traces.empty()};
        for (const PropertyResult& answer : report->answers) {
            if (answer.verdict.outcome == Outcome::Unknown) requested.undecided.push_back(answer.verdict.property);
            stopped = stopped || answer.verdict.obstacle == UnknownReason::Stopped;
            if (!as_expected(answer.verdict)) continue;
            requested.properties.push_back(answer.verdict.property);
            if (answer.verdict.vacuous) requested.vacuous.push_back(answer.verdict.property);
        }
        requested_.push_back(std::move(requested));
    }
    for (const OriginalVerdicts& requested : requested_) {
        for (const std::string& property : requested.properties) properties_.push_back(shown(requested, property));
        for (const std::string& property : requested.vacuous) vacuous_.push_back(shown(requested, property));
        for (const std::string& property : requested.undecided) undecided_.push_back(shown(requested, property));
    }
    if (stopped && properties_.empty()) return false;
    Diagnostics diagnostics;
    test_ = test_of(model_, chart_, {.mode = mode_, .limits = limits}, diagnostics);
    if (!test_) no_test_ = first_code(diagnostics);
    return true;
}

std::optional<std::size_t> MutantChecker::test_steps() const {
    return test_ ? std::optional(step_count(*test_)) : std::nullopt;
}

void MutantChecker::check_model(const Model& mutated, const OriginalVerdicts& requested, const Limits& limits,
                                MutantResult& mutant_result) const {
    const auto loop = find_loop(mutated, model_.loops[requested.loop].name);
    Diagnostics diagnostics;
    const auto report =
        loop ? quiet_report(mutated, *loop, mode_, requested.properties, limits, diagnostics) : std::nullopt;
    if (!report) {
        mutant_result.reason = first_code(diagnostics);
        return;
    }
    if (requested.whole && !report->error_traces.empty())
        mutant_result.noticed_by.push_back(shown(requested, report->error_traces.front().code));
    for (const PropertyResult& answer : report->answers) {
        if (std::ranges::find(requested.properties, answer.verdict.property) == requested.properties.end()) continue;
        const std::string name = shown(requested, answer.verdict.property);
        if (answer.verdict.outcome == Outcome::Unknown) mutant_result.undecided.push_back(name);
        else if (!as_expected(answer.verdict)) mutant_result.noticed_by.push_back(name);
        else if (answer.verdict.vacuous && std::ranges::find(vacuous_, name) == vacuous_.end())
            mutant_result.vacuous.push_back(name);
    }
    mutant_result.failures.insert(mutant_result.failures.end(), report->failures.begin(), report->failures.end());
}

MutantResult MutantChecker::result_of(const Mutant& mutant, const Limits& limits) const {
    MutantResult mutant_result;
    if (!reads_back(mutant.text))
        mutant_result.failures.push_back("a mutant has non-canonical text: " + mutant.kind + ", " + mutant.subject);
    Diagnostics diagnostics;
    const std::optional<Model> mutated = model_of(mutant, diagnostics);
    const auto chart = mutated ? find_chart(*mutated, model_.charts[chart_].name) : std::nullopt;
    if (!chart || !equations_of(*mutated, *chart, diagnostics))
        return mutant_result.kind = MutantResult::Kind::Refused, mutant_result.reason = first_code(diagnostics),
               mutant_result;
    const auto compared =
        compare(model_, chart_, *mutated, *chart,
                {.mode = execution_mode(model_, chart_, mode_), .shortest = false, .limits = limits}, diagnostics);
    if (!compared)
        return mutant_result.kind = MutantResult::Kind::Refused, mutant_result.reason = first_code(diagnostics),
               mutant_result;
    mutant_result.failures = compared->failures;
    mutant_result.scans = compared->scans.size();
    if (compared->outcome == Comparison::Outcome::Equal)
        return mutant_result.kind = MutantResult::Kind::Equivalent, mutant_result;
    for (const OriginalVerdicts& requested : requested_) check_model(*mutated, requested, limits, mutant_result);
    if (test_) mutant_result.caught = disagreement(mutated->charts[*chart], *test_).has_value();
    const bool differs = compared->outcome == Comparison::Outcome::Different;
    if (!mutant_result.noticed_by.empty()) mutant_result.kind = MutantResult::Kind::Noticed;
    else if (differs && mutant_result.undecided.empty() && mutant_result.reason.empty())
        mutant_result.kind = MutantResult::Kind::Unnoticed;
    else if (mutant_result.reason.empty())
        mutant_result.reason = differs ? "the verdict on a property is unknown"
                                       : "the equivalence of the mutant is unknown (" + compared->reason + ")";
    return mutant_result;
}

}  // namespace grafverif
