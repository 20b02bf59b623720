// SPDX-License-Identifier: MIT
// Derives an Analysis, a LocationAutomaton, a MealyMachine and a TestSequence from the Equations of a chart.
#include <fmt/format.h>

#include "analyse/analyse.hpp"
#include "conform/automaton.hpp"
#include "conform/mealy.hpp"
#include "conform/test_sequence.hpp"
#include "pipeline/check.hpp"
#include "pipeline/models.hpp"

namespace grafverif {

Analysis analysis_of(const Chart& chart, const Equations& equations, AnalyseOptions options, const Limits& limits) {
    set_limits(options, limits);
    if (limits.progress)
        options.progress = [&limits](const AnalyseProgress& now) {
            limits.progress({[&now] {
                return fmt::format("part {} of {}, {} instants; {} of {} checks decided, {} findings", now.part,
                                   now.parts, now.instant, now.questions - now.open, now.questions, now.findings);
            }});
        };
    return analyse(chart, equations, options);
}

std::optional<Analysis> analysis_of(const Model& model, Id<Chart> chart, std::optional<ExecutionMode> mode,
                                    const Limits& limits, Diagnostics& diagnostics) {
    const auto equations = equations_of(model, chart, diagnostics);
    if (!equations) return {};
    AnalyseOptions options;
    options.mode = execution_mode(model, chart, mode);
    return analysis_of(model.charts[chart], *equations, options, limits);
}

std::optional<LocationAutomaton> automaton_of(const Model& model, Id<Chart> chart, const ConformOptions& how,
                                              Diagnostics& diagnostics) {
    const auto equations = equations_of(model, chart, diagnostics);
    if (!equations) return {};
    AutomatonOptions options;
    options.mode = execution_mode(model, chart, how.mode);
    options.partial = how.partial;
    options.max_locations = how.limits.states.value_or(options.max_locations);
    set_limits(options, how.limits);
    if (how.limits.progress)
        options.progress = [&how](const ConformProgress& now) {
            how.limits.progress({[&now] {
                return fmt::format("{} locations, {} open, {} evolutions", now.locations, now.locations - now.done,
                                   now.evolutions);
            }});
        };
    return location_automaton(*equations, options, diagnostics);
}

namespace {

/// Returns the Mealy machine of the automaton. The machine is minimized if `how` requests this.
std::optional<MealyMachine> mealy_of(const LocationAutomaton& automaton, Span chart, const ConformOptions& how,
                                     Diagnostics& diagnostics) {
    MealyOptions options;
    options.max_states = how.limits.states.value_or(options.max_states);
    set_limits(options, how.limits);
    auto machine = mealy_machine(automaton, options, diagnostics);
    return machine && how.minimise ? minimised(*machine, options, chart, diagnostics) : std::move(machine);
}

std::optional<TestSequence> test_of(const MealyMachine& machine, Span chart, const ConformOptions& how,
                                    Diagnostics& diagnostics) {
    TestOptions options;
    options.cover = how.cover;
    options.one_cycle_each = how.one_cycle_each;
    return test_sequence(machine, options, chart, diagnostics);
}

}  // namespace

std::optional<MealyMachine> mealy_of(const Model& model, Id<Chart> chart, const ConformOptions& options,
                                     Diagnostics& diagnostics) {
    const auto automaton = automaton_of(model, chart, options, diagnostics);
    return automaton ? mealy_of(*automaton, model.charts[chart].origin, options, diagnostics) : std::nullopt;
}

std::optional<TestSequence> test_of(const Model& model, Id<Chart> chart, const ConformOptions& options,
                                    Diagnostics& diagnostics) {
    const auto machine = mealy_of(model, chart, options, diagnostics);
    return machine ? test_of(*machine, model.charts[chart].origin, options, diagnostics) : std::nullopt;
}

}  // namespace grafverif
