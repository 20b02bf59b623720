// SPDX-License-Identifier: MIT
#include "pipeline/program/prove.hpp"

#include <fmt/format.h>

#include <sstream>
#include <utility>

#include "emit/controller/names.hpp"
#include "emit/structured_text/dialects.hpp"
#include "pipeline/variants/compare.hpp"
#include "pipeline/variants/compare_sides.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

/// True if the comparison found a scan in which the program stops and the chart does not.
bool only_program_stops(const Comparison& comparison) {
    return comparison.outcome == Comparison::Outcome::Different && comparison.answers[0].back().stop.empty() &&
           !comparison.answers[1].back().stop.empty();
}

/// Returns a duration of the program that is not a multiple of `resolution_ms`, or an empty result if all durations are
/// multiples. If all scans occur at multiples of the resolution, the comparison does not distinguish such a duration
/// from the next larger multiple.
std::optional<std::int64_t> hidden_duration(Id<Source> program, std::int64_t resolution_ms, Sources& sources) {
    Diagnostics repeated;  // ignored, because `compare` has already reported these diagnostics
    const auto side = side_of_program(program, sources, repeated);
    if (!side) return {};
    for (const ProgramTimer& timer : side->scan->layout.timers)
        if (timer.longest % resolution_ms != 0) return timer.longest;
    return {};
}

}  // namespace

std::optional<Comparison> compare_with_text(const Model& model, Id<Chart> chart, const Equations& equations,
                                            const std::string& text, const ProofOptions& options, Sources& sources,
                                            Diagnostics& diagnostics) {
    const controller::Names names =
        controller::names_of(equations, Target::StructuredText, structured_text::row_of(options.dialect).reserved);
    ProgramCompareOptions of_program;
    of_program.stop = {names.fault};
    for (const Id<Equations::Variable> id : equations.variables.ids()) {
        const Equations::Variable& variable = equations.variables[id];
        const bool shared = variable.role == Equations::Role::Input || variable.role == Equations::Role::Output;
        if (shared && variable.name != names.variables[id.index])
            of_program.map.emplace_back(variable.name, names.variables[id.index]);
    }
    CompareOptions how;
    how.mode = options.mode;
    how.resolution_ms = options.resolution_ms;
    how.limits = options.limits;
    const Id<Source> source = sources.add({names.block + " (generated)", text});
    auto found = compare({&model, chart, {}}, {nullptr, {}, source}, how, of_program, sources, diagnostics);
    if (!found || found->outcome != Comparison::Outcome::Equal || options.resolution_ms.value_or(0) == 0) return found;
    if (const auto duration = hidden_duration(source, *options.resolution_ms, sources)) {
        found->outcome = Comparison::Outcome::Unknown;
        found->reason = fmt::format("the duration {} of the program is not a multiple of the resolution {}",
                                    duration_text(*duration), duration_text(*options.resolution_ms));
    }
    return found;
}

std::optional<ProvedText> proved_structured_text(const Model& model, Id<Chart> chart, const ProofOptions& options,
                                                 Sources& sources, Diagnostics& diagnostics) {
    const auto equations = equations_of(model, chart, diagnostics);
    if (!equations || !structured_text::expressible(*equations, diagnostics)) return {};
    const bool searches = options.mode == ExecutionMode::StabilitySearch && !options.max_evolutions;
    for (ProvedText made{{}, searches ? 8 : options.max_evolutions.value_or(1), {}};; made.max_evolutions *= 2) {
        std::ostringstream out;
        structured_text::emit(*equations, {options.mode, made.max_evolutions, options.form, options.dialect}, out);
        made.text = std::move(out).str();
        auto found = compare_with_text(model, chart, *equations, made.text, options, sources, diagnostics);
        if (!found) return {};
        made.comparison = std::move(*found);
        const bool more = searches && made.max_evolutions < most_proved_evolutions;
        if (!more || !only_program_stops(made.comparison)) return made;
    }
}

}  // namespace grafverif
