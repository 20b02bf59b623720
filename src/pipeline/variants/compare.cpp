// SPDX-License-Identifier: MIT
// Compares two sides, each of which is a chart or a program: translates both to Equations, checks the TransitionSystem
// of their product, and returns a Comparison.
#include "pipeline/variants/compare.hpp"

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

// -- preconditions ----------------------------------------------------------------------------------------------------

/// Returns `chart` with `steps` as its initial steps. Reports an error and returns nullopt if the chart contains a
/// forcing order to {INIT}, whose meaning would change, or if the situation at power-on would differ from `steps`.
std::optional<Chart> beginning_with(Chart chart, const std::vector<Id<Chart::Step>>& steps, Diagnostics& diagnostics) {
    for (const Chart::ForcingOrder& order : chart.forcing)
        if (order.to == Chart::ForcedTo::Initial) {
            diagnostics.add(messages::no_such_beginning(order.origin, chart.name,
                                                        "this forcing order forces the initial situation of the chart, "
                                                        "which differs from the selected situation"));
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
            fmt::format(
                "in this situation, `{}` is {}", step_variable(chart, step),
                begins[step.index]
                    ? "also active, because of a forcing order or a macro-step; add this step"
                    : "not active: add its enclosing step, or remove this step if a forcing order deactivates it")));
        return {};
    }
    return chart;
}

// -- time -------------------------------------------------------------------------------------------------------------

/// Returns all durations of both sides in ms, in increasing order and without duplicates.
std::vector<std::int64_t> durations(const std::array<CompareSide, 2>& sides) {
    std::vector<std::int64_t> found;
    for (const CompareSide& side : sides)
        for (const Equations::Timer& timer : side.equations().timers)
            for (const std::int64_t time : {timer.rise_ms, timer.fall_ms})
                if (time > 0) found.push_back(time);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

constexpr std::int64_t most_program_units = 1'000'000'000;  ///< if a side is a program: maximum duration, in time units

std::int64_t common_divisor(const std::vector<std::int64_t>& times) {
    return std::accumulate(times.begin(), times.end(), std::int64_t{0},
                           [](std::int64_t one, std::int64_t other) { return std::gcd(one, other); });
}

/// Returns a time unit that divides all durations, in ms; 0 if no condition depends on time. The unit is so small that
/// each timer can start in a different scan, unless such a unit is below 1 ms or a timer would count beyond 32767.
std::int64_t unit_of(const std::array<CompareSide, 2>& sides) {
    const std::vector<std::int64_t> times = durations(sides);
    if (times.empty()) return 0;
    const std::int64_t whole = common_divisor(times);
    const auto wanted =
        static_cast<std::int64_t>(std::max(sides[0].equations().timers.size(), sides[1].equations().timers.size())) + 1;
    std::int64_t best = 1;
    for (std::int64_t parts = 1; parts <= std::min<std::int64_t>(whole, 1000) && best < wanted; ++parts)
        if (whole % parts == 0 && times.back() / (whole / parts) <= greatest_integer) best = parts;
    return whole / best;
}

/// Determines the times between scans. If an exact comparison is impossible with these options, reports an error and
/// returns false.
bool set_times(const std::array<CompareSide, 2>& sides, const CompareOptions& options, Comparison& result,
               Diagnostics& diagnostics) {
    const std::vector<std::int64_t> times = durations(sides);
    bool timed_program = false;
    std::array<std::optional<std::int64_t>, 2> intervals;
    for (const std::size_t k : {0U, 1U}) {
        if (!sides[k].is_program()) continue;
        timed_program = timed_program || sides[k].scan->layout.longest > 0;
        intervals[k] = sides[k].program().interval_ms;
    }
    if (times.empty() && !timed_program) return true;  // no condition depends on time
    if (intervals[0] && intervals[1] && *intervals[0] != *intervals[1]) {
        diagnostics.add(
            messages::not_comparable(sides[0].origin,
                                     fmt::format("the task of {} is executed every {} ms, and that of {} every {} ms",
                                                 sides[0].label, *intervals[0], sides[1].label, *intervals[1]),
                                     "give both tasks the same INTERVAL"));
        return false;
    }
    result.interval_ms = intervals[0] ? intervals[0] : intervals[1];
    if (result.interval_ms && (options.resolution_ms || result.settles)) {
        const CompareSide& owner = sides[intervals[0] ? 0 : 1];
        diagnostics.add(messages::not_comparable(
            owner.origin,
            fmt::format("`{}` cannot be used, because the task of {} is executed every {} ms",
                        result.settles ? "--compare settled" : "--resolution", owner.label, *result.interval_ms),
            "remove the option, or remove INTERVAL from the task"));
        return false;
    }
    if (result.interval_ms) result.resolution_ms = std::gcd(*result.interval_ms, common_divisor(times));
    else if (options.resolution_ms) {
        if (*options.resolution_ms == 0 && times.empty()) {
            diagnostics.add(messages::not_comparable({}, "`--resolution 0ms` is not a time between two scans",
                                                     "use at least `1ms`"));
            return false;
        }
        for (const std::int64_t time : times)
            if (*options.resolution_ms == 0 || time % *options.resolution_ms != 0) {
                diagnostics.add(messages::coarse_resolution(duration_text(*options.resolution_ms), duration_text(time),
                                                            duration_text(common_divisor(times))));
                return false;
            }
        result.resolution_ms = *options.resolution_ms;
    } else result.resolution_ms = timed_program ? 1 : unit_of(sides);
    return true;
}

/// Returns the reason for the result Unknown if both sides stop in the last scan, at least one of them because of a
/// run-time fault.
std::string fault_reason(const Comparison::ScanOutputs& a, const Comparison::ScanOutputs& b) {
    const std::string_view who = a.run_time_fault && b.run_time_fault ? "" : a.run_time_fault ? ", a" : ", b";
    return fmt::format("in the last scan, a and b both stop{} because of a run-time fault, which is a model error",
                       who);
}

/// True if the side is known to complete every scan for all inputs, without a check by PDR.
bool surely_stable(const CompareSide& side, bool settles, const Limits& limits) {
    if (side.is_program()) return !settles;
    AnalyseOptions options;
    options.instability_only = true;
    set_limits(options, limits);
    const Analysis found = analyse(*side.chart, side.equations(), options);
    return found.findings.empty() && found.obstacle.empty() && found.failures.empty();
}

// -- comparison -------------------------------------------------------------------------------------------------------

class SideComparison {
public:
    SideComparison(const std::array<CompareSide, 2>& sides, const CompareOptions& options, const Sources* sources,
                   Comparison& result)
        : sides_(sides), options_(options), sources_(sources), result_(result) {}

    /// True if both sides have the same equations except for names, and no statement of a program can cause a run-time
    /// fault.
    bool are_identical() const {
        if (sides_[0].is_program() != sides_[1].is_program() || result_.settles) return false;
        if (!identical_up_to_names(sides_[0].equations(), sides_[1].equations())) return false;
        if (!sides_[0].is_program()) return true;
        return sides_[0].scan->faults.empty() && sides_[1].scan->faults.empty() && sides_[0].stop == sides_[1].stop &&
               sides_[0].scan->elapsed == sides_[1].scan->elapsed;
    }

    /// Stores the result for two sides with the same equations: Equal if some inputs satisfy the constraints.
    void answer_identical() {
        const ProductMachine& both = unrestricted();
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
        Answered same = check_properties({"same", "possible"}, {});
        if (same.outcome == Comparison::Outcome::Equal && searches && !both_stable())
            same = check_properties({"a_follows", "b_follows"}, {});
        if (same.outcome == Comparison::Outcome::Equal && result_.settles) same = ask_settling();
        if (same.outcome == Comparison::Outcome::Equal && (sides_[0].stop.valid() || sides_[1].stop.valid()))
            same = ask_stopping();
        result_.outcome = same.outcome;
        result_.reason = same.reason;
        if (same.outcome == Comparison::Outcome::Equal) report_faults();
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

    ProductMachine product(std::optional<std::int64_t> fewer_scans) const {
        ProductOptions made{result_.mode, unit(), fewer_scans, result_.interval_ms, result_.settles, {}};
        for (const Comparison::Variable& output : result_.outputs) made.outputs.push_back(output.name);
        return schedule_both(sides_[0].product(), sides_[1].product(), made);
    }

    /// Returns the product of both sides, without a limit on the number of scans. The first call builds the product.
    const ProductMachine& unrestricted() {
        if (!product_) product_ = product({});
        return *product_;
    }

    /// True if both sides are known to complete every scan under stability search. The first call computes the value.
    bool both_stable() {
        if (!stable_)
            stable_ = surely_stable(sides_[0], result_.settles, options_.limits) &&
                      surely_stable(sides_[1], result_.settles, options_.limits);
        return *stable_;
    }

    /// Returns Equal under two conditions: with constant inputs, the outputs of at least one side become constant
    /// (settle); and if one side stops, the outputs of the other side settle. Otherwise, the outputs cannot be
    /// compared.
    Answered ask_settling() {
        Answered one = check_properties({"one_follows"}, {});
        if (one.outcome == Comparison::Outcome::Different)
            return {Comparison::Outcome::Unknown,
                    "there are constant inputs for which the outputs of neither program settle, so the outputs cannot "
                    "be compared",
                    {}};
        if (one.outcome != Comparison::Outcome::Equal) return one;
        one = check_properties({"a_settles_after_stop", "b_settles_after_stop"}, {});
        if (one.outcome == Comparison::Outcome::Different)
            return {Comparison::Outcome::Unknown,
                    "there are constant inputs for which one side stops and the outputs of the other side do not "
                    "settle, so the outputs cannot be compared",
                    {}};
        return one;
    }

    /// Returns Equal if a scan without a stop is possible. Returns Unknown if both sides stop in the first scan for all
    /// inputs, because then no outputs are compared. A possible cause: `--stop-output` names an output that is not zero
    /// in normal operation.
    Answered ask_stopping() {
        Answered one = check_properties({"continues"}, {});
        if (one.outcome != Comparison::Outcome::Different) return one;
        return {Comparison::Outcome::Unknown,
                "a and b both stop in the first scan for all inputs, so no outputs are compared; `--stop-output` must "
                "name an output that is zero in normal operation",
                {}};
    }

    /// Reports a possible run-time fault as a model error, because equality is then not proved. Requires that the sides
    /// were found equal, so that both stop in the same scan. A fault after both sides have stopped has no effect.
    void report_faults() {
        if (std::ranges::none_of(
                sides_, [](const CompareSide& side) { return side.is_program() && !side.scan->faults.empty(); }))
            return;
        const Answered found = check_properties({"run_time_fault"}, {});
        if (found.outcome == Comparison::Outcome::Equal) return;
        result_.outcome = Comparison::Outcome::Unknown;
        result_.reason = found.reason;
        if (found.outcome != Comparison::Outcome::Different) return;
        const Lockstep rules = lockstep();
        std::array<std::vector<Comparison::ScanOutputs>, 2> answers = rules.answers(found.scans);
        const bool confirmed = !found.scans.empty() && !answers[0].back().stop.empty() &&
                               !answers[1].back().stop.empty() && !rules.difference(found.scans) &&
                               (answers[0].back().run_time_fault || answers[1].back().run_time_fault);
        if (!confirmed) {
            result_.reason = "internal error: the interpreter does not confirm the run-time fault";
            result_.failures.emplace_back(result_.reason);
            return;
        }
        result_.faulty = true;
        result_.reason = fault_reason(answers[0].back(), answers[1].back());
        result_.scans = found.scans;
        result_.scans.resize(answers[0].size());
        result_.answers = std::move(answers);
    }

    Lockstep lockstep() const {
        return {
            {lockstep_side(sides_[0], result_.settles, sources_), lockstep_side(sides_[1], result_.settles, sources_)},
            result_.mode,
            result_.inputs};
    }

    Answered check_properties(const std::vector<std::string>& properties, std::optional<std::int64_t> fewer_scans) {
        std::optional<ProductMachine> shorter;
        if (fewer_scans) shorter = product(fewer_scans);
        const ProductMachine& both = shorter ? *shorter : unrestricted();
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
        if (found.verdicts.size() != properties.size() && !found.fault)
            return {Comparison::Outcome::Unknown, "internal error: an engine has no verdict on a property", {}};
        return answered(both, found);
    }

    static Answered contradiction() {
        return {Comparison::Outcome::Unknown, "no inputs satisfy the constraints of both charts", {}};
    }

    /// Returns the result that the verdicts of PDR imply. The property `possible` states that some inputs satisfy the
    /// constraints; if it is violated, the sides are equal only vacuously.
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
            } else if (verdict.property == "continues" && verdict.outcome == Outcome::Violated) {
                answer = {Comparison::Outcome::Different, {}, {}};
            } else if (!queries_inputs && verdict.outcome == Outcome::Violated) {
                if (!found.runs[k]) return {Comparison::Outcome::Unknown, "no trace shows the difference", {}};
                answer = {Comparison::Outcome::Different, {}, scans_of(both, *found.runs[k])};
            }
        }
        return answer;
    }

    /// Returns the scans of a run of the product. The first scan begins at power-on. Each further scan begins after a
    /// step of the run in which both sides wait.
    std::vector<Comparison::Scan> scans_of(const ProductMachine& both, const SystemRun& run) const {
        std::vector<Comparison::Scan> scans;
        for (std::size_t k = 0; k < run.states.size(); ++k) {
            if (k > 0 && run.states[k - 1][both.waits.index] == 0) continue;
            Comparison::Scan scan;
            if (k > 0 && both.passed.valid()) scan.wait_ms = run.states[k - 1][both.passed.index] * unit();
            if (result_.interval_ms) scan.wait_ms = *result_.interval_ms;
            for (const auto input : both.inputs) scan.inputs.push_back(run.states[k][input.index]);
            scans.push_back(std::move(scan));
        }
        return scans;
    }

    /// Stores the scans up to the first difference between the sides, and the outputs that the interpreters compute for
    /// these scans.
    void take(std::vector<Comparison::Scan> scans) {
        const Lockstep rules = lockstep();
        const std::optional<std::size_t> last = rules.difference(scans);
        if (!last) {
            result_.outcome = Comparison::Outcome::Unknown;
            result_.reason = sides_[0].is_program() || sides_[1].is_program()
                                 ? "internal error: the replay by the interpreters does not show the difference"
                                 : "internal error: the replay according to IEC 60848 does not show the difference";
            result_.failures.emplace_back(result_.reason);
            return;
        }
        scans.resize(*last + 1);
        std::vector<std::int64_t> times = durations(sides_);
        times.insert(times.begin(), unit());
        if (result_.interval_ms) times.clear();
        result_.scans = rules.simplified(std::move(scans), times);
        result_.answers = rules.answers(result_.scans);
    }

    /// Searches for a shortest sequence of scans that distinguishes the sides. Under stability search, does not search
    /// if a chart possibly does not become stable: the property `same` does not detect a scan in which only one chart
    /// becomes stable.
    void shorten() {
        if (result_.mode == ExecutionMode::StabilitySearch && !both_stable()) return;
        while (result_.scans.size() > 1) {
            const Answered shorter = check_properties({"same"}, static_cast<std::int64_t>(result_.scans.size()));
            if (shorter.outcome == Comparison::Outcome::Unknown) return;
            if (shorter.outcome == Comparison::Outcome::Equal) break;
            take(shorter.scans);
            if (result_.outcome != Comparison::Outcome::Different) return;
        }
        result_.shortest = true;
    }

    const std::array<CompareSide, 2>& sides_;
    const CompareOptions& options_;
    const Sources* sources_;
    Comparison& result_;
    std::optional<bool> stable_ = {};
    std::optional<ProductMachine> product_ = {};
};

std::string steps_text(const Chart& chart, const std::vector<Id<Chart::Step>>& steps) {
    std::string text;
    for (const Id<Chart::Step> step : steps) text += (text.empty() ? "" : ", ") + name_of(chart, step).text();
    return text;
}

/// Returns the side for a chart; empty after an error. If `from` is not empty, its steps are the initial situation.
std::optional<CompareSide> chart_side(const Chart& original, const std::vector<Id<Chart::Step>>& from,
                                      std::string& from_text, Diagnostics& diagnostics) {
    std::optional<Chart> chart = original;
    if (!from.empty()) {
        from_text = steps_text(original, from);
        chart = beginning_with(std::move(*chart), from, diagnostics);
        if (!chart) return {};
    }
    auto equations = derive(*chart, diagnostics);
    if (!equations) return {};
    return side_of_chart(std::move(*chart), std::move(*equations));
}

/// Compares two sides. The result is empty after an error.
std::optional<Comparison> compared(std::array<CompareSide, 2> sides, const CompareOptions& options,
                                   const ProgramCompareOptions& of_programs, Comparison result, const Sources* sources,
                                   Diagnostics& diagnostics) {
    if (!match_sides(sides, of_programs, result, diagnostics)) return {};
    for (const std::size_t k : {0U, 1U}) {
        result.charts[k] = sides[k].name;
        result.programs[k] = sides[k].is_program();
        result.constrained = result.constrained || (sides[k].chart && !sides[k].chart->constraints.empty());
    }
    result.settles = of_programs.settles && (result.programs[0] || result.programs[1]);
    if (result.settles) result.mode = ExecutionMode::StabilitySearch;
    if (!set_times(sides, options, result, diagnostics)) return {};
    SideComparison question(sides, options, sources, result);
    const std::vector<std::int64_t> times = durations(sides);
    const std::int64_t most = result.programs[0] || result.programs[1] ? most_program_units : greatest_integer;
    if (!times.empty() && times.back() / result.resolution_ms > most)
        result.reason = "a duration has too many time units; use a coarser `--resolution`, or round the durations";
    else if (question.are_identical()) question.answer_identical();
    else question.answer();
    const bool exact_time = result.resolution_ms == 1 && !result.interval_ms && !options.resolution_ms;
    if (result.outcome == Comparison::Outcome::Unknown && exact_time && result.failures.empty() && !result.faulty)
        result.reason += "; a coarser `--resolution` makes the search smaller";
    return result;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::optional<Comparison> compare(const CompareOperand& a, const CompareOperand& b, const CompareOptions& options,
                                  const ProgramCompareOptions& of_programs, Sources& sources,
                                  Diagnostics& diagnostics) {
    const auto start = std::chrono::steady_clock::now();
    Comparison result;
    const std::array<const CompareOperand*, 2> operands = {&a, &b};
    std::array<std::optional<CompareSide>, 2> sides;
    bool with_charts = false;
    for (const std::size_t k : {0U, 1U}) {
        const CompareOperand& operand = *operands[k];
        if (operand.program.valid()) sides[k] = side_of_program(operand.program, sources, diagnostics);
        else sides[k] = chart_side(operand.model->charts[operand.chart], options.from[k], result.from[k], diagnostics);
        if (!sides[k]) return {};
        if (operand.program.valid() || with_charts) continue;
        with_charts = true;
        result.mode = execution_mode(*operand.model, operand.chart, options.mode);
    }
    if (!with_charts) result.mode = ExecutionMode::EveryCycle;  // a scan executes each program once
    else if (!a.program.valid() && !b.program.valid())
        result.changes = difference(a.model->charts[a.chart], b.model->charts[b.chart]);
    auto found = compared({std::move(*sides[0]), std::move(*sides[1])}, options, of_programs, std::move(result),
                          &sources, diagnostics);
    if (found) found->seconds = seconds_since(start);
    return found;
}

std::optional<Comparison> compare(const Model& a, Id<Chart> of_a, const Model& b, Id<Chart> of_b,
                                  const CompareOptions& options, Diagnostics& diagnostics) {
    Sources none;
    return compare({&a, of_a, {}}, {&b, of_b, {}}, options, {}, none, diagnostics);
}

}  // namespace grafverif
