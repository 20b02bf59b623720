// SPDX-License-Identifier: MIT
#include "pipeline/variants/compare_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "derive/program/scan.hpp"
#include "ir/program/fault_text.hpp"
#include "read/formats.hpp"
#include "read/xml.hpp"
#include "schedule/program/scan_module.hpp"
#include "support/messages_choice.hpp"

namespace grafverif {

namespace {

using Plug = CompareSide::Plug;

/// True if values of the type cannot be compared, because the type or the type of one of its elements is not supported.
bool is_unsupported(const Program& program, Id<Program::Type> id) {
    const Program::Type& type = program.types[id];
    if (type.kind == Program::Type::Kind::Array) return is_unsupported(program, type.element);
    if (type.kind == Program::Type::Kind::Block)
        return program.units[type.unit].kind == Program::Unit::Kind::Structure &&
               std::ranges::any_of(program.units[type.unit].variables,
                                   [&](const Program::Variable& one) { return is_unsupported(program, one.type); });
    return type.kind == Program::Type::Kind::Unsupported;
}

/// Adds to `side` the outputs whose types are not supported: those of a program unit and of the instances in this unit.
/// `prefix` is the qualified name of the instance of the unit.
void add_unsupported_outputs(CompareSide& side, Id<Program::Unit> unit, const std::string& prefix) {
    const Program& program = side.program();
    for (const Program::Variable& variable : program.units[unit].variables) {
        if (variable.output && is_unsupported(program, variable.type))
            side.unsupported.push_back({prefix + variable.name, {}, nullptr, 0, {}, variable.origin});
        Id<Program::Type> type = variable.type;
        while (program.types[type].kind == Program::Type::Kind::Array) type = program.types[type].element;
        if (program.types[type].kind == Program::Type::Kind::Block)
            add_unsupported_outputs(side, program.types[type].unit, prefix + variable.name + ".");
    }
}

}  // namespace

bool contains_program(Id<Source> source, Sources& sources) {
    const FileFormat format = format_of(sources[source].text);
    if (format != FileFormat::Xml) return format == FileFormat::StructuredText;
    Diagnostics ignored;
    const auto xml = Xml::read(source, sources, ignored);
    return xml && is(xml->root(), "project");
}

CompareSide side_of_chart(Chart chart, Equations equations) {
    CompareSide side;
    side.name = chart.name;
    side.origin = chart.origin;
    for (const auto& [kind, role, member] :
         {std::tuple(Chart::VariableKind::Input, Equations::Role::Input, &CompareSide::inputs),
          std::tuple(Chart::VariableKind::Output, Equations::Role::Output, &CompareSide::outputs)})
        for (const Chart::Variable& variable : chart.variables) {
            if (variable.kind != kind) continue;
            Plug plug{variable.name, variable.type, nullptr, (side.*member).size(), {}, variable.origin};
            for (const Id<Equations::Variable> id : equations.variables.ids())
                if (equations.variables[id].role == role && equations.variables[id].name == variable.name)
                    plug.variable = id;
            (side.*member).push_back(std::move(plug));
        }
    side.chart = std::move(chart);
    side.chart_equations = std::move(equations);
    return side;
}

std::optional<CompareSide> side_of_program(Id<Source> source, Sources& sources, Diagnostics& diagnostics) {
    CompareSide side;
    side.text = read_program(source, sources, diagnostics);
    if (!side.text) return {};
    side.scan = scan_of(side.program(), diagnostics);
    if (!side.scan) return {};
    side.name = side.scan->equations.name;
    side.origin = side.scan->equations.origin;
    bool rejected = false;
    for (std::size_t i = 0; i < side.scan->layout.cells.size(); ++i) {
        const ProgramCell& cell = side.scan->layout.cells[i];
        const Id<Equations::Variable> id = side.scan->variables[i];
        if (cell.output && !id.valid()) {
            diagnostics.add(messages::not_comparable(
                cell.origin, fmt::format("the output `{}` is a constant, which is not compared", cell.name),
                "remove CONSTANT"));
            rejected = true;
        }
        if (!id.valid() || (!cell.input && !cell.output)) continue;
        const Equations::Variable& variable = side.scan->equations.variables[id];
        (cell.input ? side.inputs : side.outputs)
            .push_back({variable.name, variable.type, &side.program().types[cell.type], i, id, cell.origin});
    }
    if (rejected) return {};
    for (const Id<Program::Unit> unit : {side.program().globals, side.program().main})
        add_unsupported_outputs(side, unit, "");
    return side;
}

LockstepSide lockstep_side(const CompareSide& side, bool settles, const Sources* sources) {
    LockstepSide found;
    std::vector<std::pair<std::size_t, std::size_t>> order;  // index in this side, index among the common inputs
    for (std::size_t i = 0; i < side.inputs.size(); ++i) order.emplace_back(side.inputs[i].own, i);
    std::ranges::sort(order);
    for (const auto& [own, common] : order) found.inputs.push_back(common);
    for (const Plug& output : side.outputs) found.outputs.push_back(output.own);
    if (!side.is_program()) {
        found.chart = &*side.chart;
        return found;
    }
    found.program = &side.program();
    found.stop = side.stop_cell;
    if (settles) {
        found.settled.emplace();
        const std::vector<bool> observed = schedule::variables_observed(*side.scan, side.stop);
        for (std::size_t i = 0; i < side.scan->variables.size(); ++i)
            if (side.scan->variables[i].valid() && observed[side.scan->variables[i].index] &&
                !side.scan->layout.cells[i].input)
                found.settled->push_back(i);
    }
    found.fault_text = [sources](const ProgramRun::Fault& fault) {
        const std::string where = sources != nullptr ? file_and_line(*sources, fault.where) : "";
        return text_of(fault.kind) + (where.empty() ? "" : fmt::format(" ({})", where)) + " [no-value]";
    };
    return found;
}

}  // namespace grafverif
