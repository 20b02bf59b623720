// SPDX-License-Identifier: MIT
#include "pipeline/program/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "check/portfolio.hpp"
#include "derive/program/scan.hpp"
#include "ir/program/fault_text.hpp"
#include "ir/program/interface.hpp"
#include "pipeline/check.hpp"
#include "pipeline/models.hpp"
#include "pipeline/program/replay.hpp"
#include "pipeline/why.hpp"

namespace grafverif {

namespace {

using Kind = ProgramProperty::Kind;

std::string no_fault_reason(Outcome outcome) {
    return outcome == Outcome::Violated ? "a run-time fault is possible" : "run-time faults are not excluded";
}

class Check {
public:
    Check(const Program& program, Scan scan, const std::vector<ProgramProperty>& properties)
        : program_(program), scan_(std::move(scan)), properties_(properties) {}

    bool prepare(const std::vector<std::string>& requested, Diagnostics& diagnostics) {
        std::vector<std::string> known;
        for (const ProgramProperty& property : properties_) known.push_back(property.name);
        if (!all_known(requested, known, diagnostics)) return false;
        bool ok = true;
        for (const ProgramProperty& property : properties_) {
            if (!requested.empty() && std::ranges::find(requested, property.name) == requested.end()) continue;
            const auto condition = condition_of(property, diagnostics);
            ok = ok && condition;
            if (!condition) continue;
            goals_.push_back({property.name, property.text, pattern_of(property.kind), *condition, property.origin,
                              property.is_about_fault()});
            about_.push_back(&property);
        }
        if (ok) system_ = schedule_program(scan_, goals_);
        return ok;
    }

    Report report(const CheckOptions& options) {
        PortfolioOptions all;
        all.witnesses = options.witnesses;
        all.jobs = options.jobs;
        all.alone = 50'000'000;
        set_limits(all, options.limits);
        PortfolioResult result = check_together(system_.system, all);
        report_.model = scan_.equations.name;
        report_.settings.engine = result.alone ? "symbolic" : "auto";
        report_.settings.untimed = program_.retains ? "free inputs, cold start" : "free inputs";
        report_.settings.mode = program_.interval_ms    ? fmt::format("a scan every {} ms", *program_.interval_ms)
                                : scan_.elapsed.valid() ? "any time between scans"
                                                        : "any number of scans";
        report_.failures = std::move(result.failures);
        if (result.fault)
            report_.failures.push_back(fmt::format("the transition system of the program is invalid: {} {}",
                                                   word(result.fault->kind), result.fault->variable));
        Outcome no_fault = Outcome::Holds;
        const std::size_t first = system_.no_fault.valid() ? 1 : 0;
        if (first == 1) no_fault = fault(result.verdicts.front(), result.runs.front());
        for (std::size_t i = first; i < result.verdicts.size(); ++i)
            add(std::move(result.verdicts[i]), result.runs[i], i - first, no_fault, options.witnesses);
        return std::move(report_);
    }

private:
    static Pattern pattern_of(Kind kind) {
        switch (kind) {
        case Kind::Invariant:
        case Kind::Assertion:
        case Kind::Termination: return Pattern::Always;
        case Kind::Reachable: return Pattern::Reachable;
        case Kind::MutualExclusion:
        case Kind::Absence:
        case Kind::Reachability: break;
        }
        return Pattern::Never;
    }

    std::optional<Id<Expr>> condition_of(const ProgramProperty& property, Diagnostics& diagnostics) {
        Exprs& exprs = scan_.equations.exprs;
        std::vector<Id<Expr>> terms;
        for (const Id<Program::Node> node : property.conditions) {
            const auto term = value_after(program_, node, scan_, diagnostics);
            if (!term) return {};
            terms.push_back(*term);
        }
        if (property.kind == Kind::MutualExclusion) {
            Id<Expr> any = exprs.constant(false), two = any;
            for (const Id<Expr> term : terms) {
                two = exprs.disjunction(two, exprs.conjunction(any, term));
                any = exprs.disjunction(any, term);
            }
            return two;
        }
        // Every scan terminates, because all loops were unrolled.
        if (property.kind == Kind::Termination) return exprs.constant(true);
        if (property.kind != Kind::Absence) return terms.front();
        std::vector<Id<Expr>> events;
        if (!property.is_about_fault()) {
            for (const Scan::Event& event : scan_.overflows) events.push_back(event.condition);
            return exprs.disjunction(events);
        }
        // A scan ends at its first fault. Therefore the condition of a fault requires that no earlier fault occurs in
        // the scan.
        Id<Expr> earlier = exprs.constant(false);
        for (const Scan::Event& event : scan_.faults) {
            if (event.fault == property.fault())
                events.push_back(exprs.conjunction(event.condition, exprs.negation(earlier)));
            earlier = exprs.disjunction(earlier, event.condition);
        }
        return exprs.disjunction(events);
    }

    /// Returns the outcome of the property that no run-time fault occurs. A possible fault is reported as a model error
    /// if none of the checked properties concerns this type of fault.
    Outcome fault(const Verdict& verdict, const std::optional<SystemRun>& run) {
        if (verdict.outcome != Outcome::Violated || !run) return verdict.outcome;
        ProgramReplay replay = replay_program(program_, scan_, system_, *run, nullptr);
        if (!replay.disagreement.empty()) {
            report_.failures.push_back("a run-time fault is not confirmed: " + replay.disagreement);
            return verdict.outcome;
        }
        const bool requested = std::ranges::any_of(about_, [&](const ProgramProperty* property) {
            return property->is_about_fault() && property->fault() == replay.fault;
        });
        if (!requested) report_.error_traces.push_back({"no-value", text_of(*replay.fault), std::move(replay.trace)});
        return verdict.outcome;
    }

    void add(Verdict verdict, const std::optional<SystemRun>& run, std::size_t index, Outcome no_fault,
             bool witnesses) {
        const ProgramProperty& property = *about_[index];
        PropertyResult answer;
        answer.text = property.text;
        const bool universal_holds = (verdict.pattern == Pattern::Reachable) == (verdict.outcome == Outcome::Violated);
        if (verdict.outcome != Outcome::Unknown && universal_holds && no_fault != Outcome::Holds) {
            set_unknown(verdict, no_fault == Outcome::Violated ? UnknownReason::Faulty : UnknownReason::Stopped,
                        no_fault_reason(no_fault));
        } else if (run && verdict.outcome != Outcome::Unknown && (verdict.outcome == Outcome::Violated || witnesses)) {
            ProgramReplay replay = replay_program(program_, scan_, system_, *run, &property);
            if (replay.disagreement.empty()) answer.trace = std::move(replay.trace);
            else {
                report_.failures.push_back(
                    fmt::format("the trace of `{}` is not confirmed: {}", property.name, replay.disagreement));
                set_unknown(verdict, UnknownReason::Failed, "the trace is not confirmed");
            }
        }
        answer.verdict = std::move(verdict);
        report_.answers.push_back(std::move(answer));
    }

    const Program& program_;
    Scan scan_;
    const std::vector<ProgramProperty>& properties_;
    std::vector<ScanProperty> goals_ = {};
    std::vector<const ProgramProperty*> about_ = {};  ///< the property of each goal
    ProgramSystem system_ = {};
    Report report_ = {};
};

}  // namespace

namespace {

/// Returns a model whose only chart represents the program.
Model model_of(const Program& program) {
    const Program::Unit& main = program.units[program.main];
    Model model;
    model.charts.add(interface_of({std::make_shared<const Program>(program)}, main.name, main.origin));
    return model;
}

/// Repeats the check of the properties that hold according to `report`, each time without one element of the program.
ProofExplanation why_it_holds(const Program& program, const std::vector<ProgramProperty>& properties,
                              const Report& report, const CheckOptions& options) {
    ProofExplanation why;
    CheckOptions variant = options;
    variant.witnesses = false;
    variant.properties.clear();
    for (const PropertyResult& answer : report.answers)
        if (answer.verdict.outcome == Outcome::Holds) {
            why.grounds.push_back({.property = answer.verdict.property});
            variant.properties.push_back(answer.verdict.property);
        }
    const auto over = [&] { return is_over(options.limits.deadline, options.limits.stop); };
    const std::vector<ProgramElement> elements =
        why.grounds.empty() ? std::vector<ProgramElement>{} : elements_of(program);
    for (std::size_t k = 0; k < elements.size(); ++k) {
        ProofExplanation::ModelElement element = model_element(elements[k]);
        element.open = variant.properties;
        Program changed = program;
        drop_element(changed, elements[k]);
        Diagnostics diagnostics;  // ignored: for example, a loop without the element has no constant bound
        auto scan = over() ? std::nullopt : scan_of(changed, diagnostics);
        std::optional<Check> check;
        if (scan) check.emplace(changed, std::move(*scan), properties);
        if (check && check->prepare(variant.properties, diagnostics)) {
            // The remaining time is divided into equal shares for the remaining elements; one check may use at most
            // eight shares.
            variant.limits.deadline = share_of(options.limits.deadline, (elements.size() - k) / 8 + 1);
            ++why.searches;
            for (const PropertyResult& answer : check->report(variant).answers) {
                const Verdict& verdict = answer.verdict;
                const bool fails = verdict.outcome == Outcome::Violated || verdict.obstacle == UnknownReason::Faulty;
                if (fails) element.needed_by.push_back(verdict.property);
                if (fails || verdict.outcome == Outcome::Holds) std::erase(element.open, verdict.property);
            }
        }
        if (!element.open.empty() && over())
            why.ended = is_over(options.limits.deadline) ? "time limit reached" : "stopped";
        why.things.push_back(std::move(element));
    }
    order_elements(why);
    return why;
}

}  // namespace

std::optional<Model> read_program_model(Id<Source> source, Id<Source> property_source, Sources& sources,
                                        Diagnostics& diagnostics) {
    auto text = read_program(source, sources, diagnostics);
    if (!text) return {};
    const auto properties = read_properties(property_source, sources, *text, diagnostics);
    if (!properties || !scan_of(text->program(), diagnostics)) return {};
    return model_of(text->program());
}

std::optional<CheckedProgram> check_program(Id<Source> source, Id<Source> property_source, Sources& sources,
                                            const CheckOptions& options, Diagnostics& diagnostics, bool explains) {
    auto text = read_program(source, sources, diagnostics);
    if (!text) return {};
    const auto properties = read_properties(property_source, sources, *text, diagnostics);
    auto scan = scan_of(text->program(), diagnostics);
    if (!properties || !scan) return {};
    Check check(text->program(), std::move(*scan), *properties);
    if (!check.prepare(options.properties, diagnostics)) return {};
    CheckOptions first = options;
    if (explains) first.limits.deadline = share_of(options.limits.deadline, 2);
    CheckedProgram checked{model_of(text->program()), check.report(first), {}};
    if (explains) checked.why = why_it_holds(text->program(), *properties, checked.report, options);
    return checked;
}

}  // namespace grafverif
