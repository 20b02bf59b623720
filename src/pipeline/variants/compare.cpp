// SPDX-License-Identifier: MIT
// Compares two charts: translates both to Equations, builds the TransitionSystem of their product, and returns a
// Comparison.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>

#include "analyse/analyse.hpp"
#include "check/pdr/check.hpp"
#include "check/portfolio.hpp"
#include "compare/difference.hpp"
#include "compare/identical.hpp"
#include "derive/derive.hpp"
#include "pipeline/models.hpp"
#include "run/interpreter.hpp"
#include "run/lockstep.hpp"
#include "schedule/product.hpp"
#include "support/messages.hpp"
#include "support/messages_choice.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

// -- preconditions
// -------------------------------------------------------------------------------------------------------

std::string range_text(Type type) {
    return type.boolean ? "a Boolean" : fmt::format("an integer from {} to {}", type.low, type.high);
}

/// Returns false after reporting, as an error, each input or output that only one chart has.
bool same_plugs(const Chart& a, const Chart& b, Diagnostics& diagnostics) {
    using Kind = Chart::VariableKind;
    const std::size_t before = diagnostics.errors();
    for (const auto& [kind, word] : {std::pair(Kind::Input, "input"), std::pair(Kind::Output, "output")})
        for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)})
            for (const Chart::Variable& variable : one->variables) {
                if (variable.kind != kind) continue;
                const auto twin = std::ranges::find_if(other->variables, [&, kind = kind](const auto& each) {
                    return each.kind == kind && each.name == variable.name;
                });
                if (twin == other->variables.end())
                    diagnostics.add(messages::not_in_both(variable.origin, word, variable.name, one->name));
                else if (one == &a && twin->type != variable.type)
                    diagnostics.add(messages::other_type(variable.origin, word, variable.name,
                                                         range_text(variable.type), range_text(twin->type)));
            }
    if (diagnostics.errors() == before && plugs(a, Kind::Output).empty())
        diagnostics.add(messages::nothing_to_compare(a.origin, a.name));
    return diagnostics.errors() == before;
}

/// Returns `chart` with `steps` as its initial steps, or nothing after an error. Forcing orders to {INIT} would have
/// another meaning.
std::optional<Chart> beginning_with(Chart chart, const std::vector<Id<Chart::Step>>& steps, Diagnostics& diagnostics) {
    for (const Chart::ForcingOrder& order : chart.forcing)
        if (order.to == Chart::ForcedTo::Initial) {
            diagnostics.add(messages::no_such_beginning(
                order.origin, chart.name,
                "this order forces the initial situation, which differs from the selected one"));
            return {};
        }
    for (const Id<Chart::Step> step : chart.steps.ids())
        chart.steps[step].initial = std::ranges::find(steps, step) != steps.end();
    const std::vector<bool> begins = power_on(chart).situation;
    for (const Id<Chart::Step> step : chart.steps.ids()) {
        const bool macro = chart.steps[step].kind == Chart::StepKind::Macro;
        if (begins[step.index] == chart.steps[step].initial || (macro && begins[step.index])) continue;
        diagnostics.add(messages::no_such_beginning(
            chart.steps[step].origin, chart.name,
            fmt::format("with it `{}` is {}", step_variable(chart, step),
                        begins[step.index]
                            ? "also active, because of a forcing order or a macro-step; add it"
                            : "not active, because it is enclosed or forced; add the step that activates it")));
        return {};
    }
    return chart;
}

// -- time -------------------------------------------------------------------------------------------------------------

/// Returns all durations of both charts, increasing.
std::vector<std::int64_t> durations(const Equations& a, const Equations& b) {
    std::vector<std::int64_t> found;
    for (const Equations* chart : {&a, &b})
        for (const Equations::Timer& timer : chart->timers)
            for (const std::int64_t time : {timer.rise_ms, timer.fall_ms})
                if (time > 0) found.push_back(time);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::int64_t common_divisor(const std::vector<std::int64_t>& times) {
    return std::accumulate(times.begin(), times.end(), std::int64_t{0},
                           [](std::int64_t one, std::int64_t other) { return std::gcd(one, other); });
}

/// Returns the time unit, which divides all durations; 0 if no condition depends on time. If this is possible with
/// whole milliseconds, the number of scans is sufficient to separate the starts of all timers. No timer counts beyond
/// 30000.
std::int64_t unit_of(const Equations& a, const Equations& b) {
    const std::vector<std::int64_t> times = durations(a, b);
    if (times.empty()) return 0;
    const std::int64_t whole = common_divisor(times);
    const auto wanted = static_cast<std::int64_t>(std::max(a.timers.size(), b.timers.size())) + 1;
    std::int64_t best = 1;
    for (std::int64_t parts = 1; parts <= std::min<std::int64_t>(whole, 1000) && best < wanted; ++parts)
        if (whole % parts == 0 && times.back() / (whole / parts) <= greatest_integer) best = parts;
    return whole / best;
}

/// True if both charts become stable for all inputs, so that the comparison need not check this.
bool surely_stable(const Chart& chart, const Equations& equations, const Limits& limits) {
    AnalyseOptions options;
    options.instability_only = true;
    set_limits(options, limits);
    const Analysis found = analyse(chart, equations, options);
    return found.findings.empty() && found.obstacle.empty() && found.failures.empty();
}

// -- comparison
// ----------------------------------------------------------------------------------------------------------

class ChartComparison {
public:
    ChartComparison(const Chart& a, const Chart& b, const Equations& of_a, const Equations& of_b,
                    const CompareOptions& options, Comparison& result)
        : charts_{&a, &b}, equations_{&of_a, &of_b}, options_(options), result_(result) {}

    /// Returns the result for two charts with the same equations: equal, provided that the constraints permit some
    /// inputs.
    void answer_identical() {
        const ProductMachine both = schedule_both(*equations_[0], *equations_[1], {result_.mode, unit(), {}});
        PdrOptions engine;
        engine.method = PdrOptions::Method::Bmc;
        engine.max_steps = 0;
        engine.properties = {"possible"};
        set_limits(engine, options_.limits);
        const Answered possible = answered(both, check_pdr(both.system, engine));
        result_.outcome = possible.outcome;
        result_.reason = possible.reason;
    }

    void answer() {
        const bool searches = result_.mode == ExecutionMode::StabilitySearch;
        Answered same = ask({"same", "possible"}, {});
        if (same.outcome == Comparison::Outcome::Equal && searches && !both_stable())
            same = ask({"a_follows", "b_follows"}, {});
        result_.outcome = same.outcome;
        result_.reason = same.reason;
        if (same.outcome != Comparison::Outcome::Different) return;
        take(std::move(same.scans));
        if (options_.shortest && result_.outcome == Comparison::Outcome::Different) shorten();
    }

private:
    struct Answered {
        Comparison::Outcome outcome = Comparison::Outcome::Unknown;
        std::string reason = {};
        std::vector<Comparison::Scan> scans = {};
    };

    std::int64_t unit() const { return std::max<std::int64_t>(result_.resolution_ms, 1); }

    /// True if both charts become stable, for stability search; computed once.
    bool both_stable() {
        if (!stable_)
            stable_ = surely_stable(*charts_[0], *equations_[0], options_.limits) &&
                      surely_stable(*charts_[1], *equations_[1], options_.limits);
        return *stable_;
    }

    Answered ask(const std::vector<std::string>& properties, std::optional<std::int64_t> fewer_scans) {
        const ProductMachine both = schedule_both(*equations_[0], *equations_[1], {result_.mode, unit(), fewer_scans});
        PortfolioOptions engines;
        engines.properties = properties;
        engines.witnesses = false;
        engines.equal_latches = true;
        set_limits(engines, options_.limits);
        if (options_.limits.progress)
            engines.progress = [this](const PortfolioProgress& now) {
                options_.limits.progress({[&now] {
                    return fmt::format("{} evolutions deep, {} MiB", now.symbolic.depth, now.symbolic.bytes >> 20U);
                }});
            };
        PdrResult found = check_together(both.system, engines);
        std::ranges::move(found.failures, std::back_inserter(result_.failures));
        return answered(both, found);
    }

    static Answered contradiction() {
        return {Comparison::Outcome::Unknown, "no inputs satisfy the constraints of both charts", {}};
    }

    /// `possible` represents the constraints. If they permit no inputs, the result would be vacuous.
    Answered answered(const ProductMachine& both, const PdrResult& found) const {
        if (found.fault && found.fault->kind == SystemFault::Kind::NoInitialState) return contradiction();
        if (found.fault)
            return {Comparison::Outcome::Unknown, "internal error: the model of both charts has a model error", {}};
        Answered answer{Comparison::Outcome::Equal, {}, {}};
        for (std::size_t k = 0; k < found.verdicts.size(); ++k) {
            const Verdict& verdict = found.verdicts[k];
            const bool queries_inputs = verdict.property == "possible";
            if (verdict.outcome == Outcome::Unknown) {
                if (answer.outcome == Comparison::Outcome::Equal)
                    answer = {Comparison::Outcome::Unknown, verdict.reason, {}};
            } else if (queries_inputs && verdict.outcome == Outcome::Violated) {
                return contradiction();
            } else if (!queries_inputs && verdict.outcome == Outcome::Violated && found.runs[k]) {
                answer = {Comparison::Outcome::Different, {}, scans_of(both, *found.runs[k])};
            }
        }
        return answer;
    }

    /// Returns the scans. A scan begins at power-on, and whenever both charts have waited.
    std::vector<Comparison::Scan> scans_of(const ProductMachine& both, const SystemRun& run) const {
        std::vector<Comparison::Scan> scans;
        for (std::size_t k = 0; k < run.states.size(); ++k) {
            if (k > 0 && run.states[k - 1][both.waits.index] == 0) continue;
            Comparison::Scan scan;
            if (k > 0 && both.passed.valid()) scan.wait_ms = run.states[k - 1][both.passed.index] * unit();
            for (const auto input : both.inputs) scan.inputs.push_back(run.states[k][input.index]);
            scans.push_back(std::move(scan));
        }
        return scans;
    }

    /// Stores the results of the interpreter for these scans, up to the first difference.
    void take(std::vector<Comparison::Scan> scans) {
        const Lockstep rules(*charts_[0], *charts_[1], result_.mode);
        const std::optional<std::size_t> last = rules.difference(scans);
        if (!last) {
            result_.outcome = Comparison::Outcome::Unknown;
            result_.reason = "internal error: the rules of IEC 60848 do not confirm the difference";
            result_.failures.emplace_back(result_.reason);
            return;
        }
        scans.resize(*last + 1);
        std::vector<std::int64_t> times = durations(*equations_[0], *equations_[1]);
        times.insert(times.begin(), unit());
        result_.scans = rules.simplified(std::move(scans), times);
        result_.answers = rules.answers(result_.scans);
    }

    /// If a chart may not become stable, searches for an earlier difference in stability.
    void shorten() {
        if (result_.mode == ExecutionMode::StabilitySearch && !both_stable()) return;
        while (result_.scans.size() > 1) {
            const Answered shorter = ask({"same"}, static_cast<std::int64_t>(result_.scans.size()));
            if (shorter.outcome == Comparison::Outcome::Unknown) return;
            if (shorter.outcome == Comparison::Outcome::Equal) break;
            take(shorter.scans);
            if (result_.outcome != Comparison::Outcome::Different) return;
        }
        result_.shortest = true;
    }

    const std::array<const Chart*, 2> charts_;
    const std::array<const Equations*, 2> equations_;
    const CompareOptions& options_;
    Comparison& result_;
    std::optional<bool> stable_ = {};
};

std::string steps_text(const Chart& chart, const std::vector<Id<Chart::Step>>& steps) {
    std::string text;
    for (const Id<Chart::Step> step : steps) text += (text.empty() ? "" : ", ") + name_of(chart, step).text();
    return text;
}

}  // namespace

std::optional<Comparison> compare(const Model& a, Id<Chart> of_a, const Model& b, Id<Chart> of_b,
                                  const CompareOptions& options, Diagnostics& diagnostics) {
    const auto start = std::chrono::steady_clock::now();
    std::array<Chart, 2> charts{a.charts[of_a], b.charts[of_b]};
    if (!same_plugs(charts[0], charts[1], diagnostics)) return {};
    Comparison result;
    std::array<std::optional<Equations>, 2> equations;
    for (const std::size_t k : {0U, 1U}) {
        result.charts[k] = charts[k].name;
        if (!options.from[k].empty()) {
            result.from[k] = steps_text(charts[k], options.from[k]);
            auto begun = beginning_with(charts[k], options.from[k], diagnostics);
            if (!begun) return {};
            charts[k] = std::move(*begun);
        }
        equations[k] = derive(charts[k], diagnostics);
        if (!equations[k]) return {};
        result.constrained = result.constrained || !charts[k].constraints.empty();
    }
    result.changes = difference(a.charts[of_a], b.charts[of_b]);
    result.mode = execution_mode(a, of_a, options.mode);
    result.inputs = plugs(charts[0], Chart::VariableKind::Input);
    result.outputs = plugs(charts[0], Chart::VariableKind::Output);
    result.resolution_ms = unit_of(*equations[0], *equations[1]);
    if (options.resolution_ms && result.resolution_ms > 0) {
        const std::vector<std::int64_t> times = durations(*equations[0], *equations[1]);
        for (const std::int64_t time : times)
            if (*options.resolution_ms == 0 || time % *options.resolution_ms != 0) {
                diagnostics.add(messages::coarse_resolution(duration_text(*options.resolution_ms), duration_text(time),
                                                            duration_text(common_divisor(times))));
                return {};
            }
        result.resolution_ms = *options.resolution_ms;
    }
    ChartComparison question(charts[0], charts[1], *equations[0], *equations[1], options, result);
    if (!durations(*equations[0], *equations[1]).empty() &&
        durations(*equations[0], *equations[1]).back() / result.resolution_ms > greatest_integer)
        result.reason = "a duration has too many time units; use a coarser `--resolution`";
    else if (identical_up_to_names(*equations[0], *equations[1])) question.answer_identical();
    else question.answer();
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace grafverif
