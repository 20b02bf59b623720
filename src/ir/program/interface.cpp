// SPDX-License-Identifier: MIT
#include "ir/program/interface.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

namespace grafverif {

std::vector<std::size_t> variable_cells(const ProgramLayout& layout) {
    std::vector<std::size_t> cells;
    for (std::size_t i = layout.cells.size(); i-- > 0;)
        if (!layout.cells[i].constant && !layout.cells[i].temporary) cells.push_back(i);
    return cells;
}

std::vector<std::size_t> step_cells(const ProgramLayout& layout) {
    std::vector<std::size_t> cells;
    for (std::size_t i = 0; i < layout.cells.size(); ++i)
        if (layout.cells[i].step) cells.push_back(i);
    return cells;
}

StepName step_name(const std::string& cell) {
    const std::string path = cell.substr(0, cell.rfind('.'));
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos) return {"", path};
    return {path.substr(0, dot), path.substr(dot + 1)};
}

std::vector<Span> declarations_in(const Program& program, std::string_view path) {
    const auto capital = [](unsigned char letter) { return std::toupper(letter); };
    std::vector<Span> found;
    std::vector<Id<Program::Unit>> scopes = {program.main, program.globals};
    while (!path.empty()) {
        const std::string_view part = path.substr(0, path.find('.'));
        const std::string_view name = part.substr(0, part.find('['));
        path.remove_prefix(std::min(path.size(), part.size() + 1));
        const Program::Variable* variable = nullptr;
        for (const Id<Program::Unit> scope : scopes)
            for (const Program::Variable& each : program.units[scope].variables)
                if (variable == nullptr && std::ranges::equal(each.name, name, {}, capital, capital)) variable = &each;
        if (variable == nullptr) break;
        found.push_back(variable->origin);
        Id<Program::Type> type = variable->type;
        while (program.types[type].kind == Program::Type::Kind::Array) type = program.types[type].element;
        if (program.types[type].kind != Program::Type::Kind::Block) break;
        scopes = {program.types[type].unit};
    }
    return found;
}

Chart interface_of(ProgramReference program, std::string name, Span origin) {
    Chart chart;
    chart.name = std::move(name);
    chart.origin = origin;
    const ProgramLayout layout = layout_of(*program);
    const std::vector<std::string> names = unique_names(layout);
    for (const std::size_t i : variable_cells(layout)) {
        const ProgramCell& cell = layout.cells[i];
        const auto kind = cell.input    ? Chart::VariableKind::Input
                          : cell.output ? Chart::VariableKind::Output
                                        : Chart::VariableKind::Internal;
        chart.variables.add({names[i], kind, type_of_cell(*program, layout, i), cell.initial, cell.origin});
    }
    chart.partial_charts.add({.origin = origin});
    for (const std::size_t i : step_cells(layout)) {
        const ProgramCell& cell = layout.cells[i];
        const StepName step = step_name(names[i]);
        Id<Chart::PartialChart> partial;
        for (const Id<Chart::PartialChart> id : chart.partial_charts.ids())
            if (chart.partial_charts[id].name == step.partial) partial = id;
        if (!partial.valid()) {
            const std::vector<Span> owners = declarations_in(*program, step.partial);
            partial = chart.partial_charts.add(
                {.name = step.partial, .origin = owners.empty() ? cell.origin : owners.back()});
        }
        chart.steps.add({.name = step.step, .initial = cell.initial != 0, .chart = partial, .origin = cell.origin});
    }
    chart.program = std::move(program);
    return chart;
}

std::vector<SequenceTest> sequence_tests(const Program& program, const ProgramLayout& layout) {
    std::vector<SequenceTest> tests;
    for (const ProgramInstance& instance : layout.instances)
        for (const Program::Sequence& sequence : program.units[instance.unit].sequences)
            for (const Program::Sequence::Transition& transition : sequence.transitions)
                tests.push_back({transition.test, instance.unit, instance.frame});
    return tests;
}

Chart drawn_chart(const Chart& interface) {
    Chart chart = interface;
    const Program& program = *interface.program;
    const ProgramLayout layout = layout_of(program);
    std::map<std::size_t, Id<Chart::Step>> steps;  // maps the memory cell of a step to the step
    for (const std::size_t cell : step_cells(layout))
        steps.emplace(cell, Id<Chart::Step>{static_cast<std::uint32_t>(steps.size())});
    std::map<std::string, Id<Chart::Variable>> labels;
    const Id<Expr> always = chart.exprs.constant(true);
    for (const ProgramInstance& instance : layout.instances)
        for (const Program::Sequence& sequence : program.units[instance.unit].sequences) {
            const auto steps_of = [&](const std::vector<std::uint32_t>& cells) {
                std::vector<Id<Chart::Step>> found;
                for (const std::uint32_t cell : cells) found.push_back(steps.at(instance.frame + cell));
                return found;
            };
            for (const Id<Chart::Step> step : steps_of(sequence.initial)) chart.steps[step].initial = true;
            for (const Program::Sequence::Transition& from : sequence.transitions) {
                Chart::Transition made{.name = from.name, .from = steps_of(from.from), .to = steps_of(from.to)};
                if (made.name.empty()) made.name = "T" + std::to_string(chart.transitions.size() + 1);
                made.condition = always;
                made.chart = chart.steps[made.from.front()].chart;
                made.origin = program.nodes[program.statements[from.test].value].origin;
                chart.transitions.add(std::move(made));
            }
            for (const Program::Sequence::Action& from : sequence.actions) {
                const auto [known, fresh] = labels.try_emplace(from.label);
                if (fresh) known->second = chart.variables.add({from.label, Chart::VariableKind::Output});
                chart.continuous.add({steps.at(instance.frame + from.step), known->second, always});
            }
        }
    return chart;
}

}  // namespace grafverif
