// SPDX-License-Identifier: MIT
#include "ir/program/interface.hpp"

#include <algorithm>
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
        if (!partial.valid()) partial = chart.partial_charts.add({.name = step.partial, .origin = cell.origin});
        chart.steps.add({.name = step.step, .initial = cell.initial != 0, .chart = partial, .origin = cell.origin});
    }
    chart.program = std::move(program);
    return chart;
}

}  // namespace grafverif
