// SPDX-License-Identifier: MIT
#include "ir/program/program.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace grafverif {

namespace {

/// Name of the unit of the steps of Sequential Function Charts. The name is a keyword, so that no other unit has this
/// name. The first cell of the unit is true while the step is active.
constexpr std::string_view step_unit = "STEP";

struct Walk {
    const Program& program;
    ProgramLayout layout = {};

    /// The properties of a variable, which also apply to all its cells.
    struct Owner {
        bool input = false, output = false, temporary = false, constant = false;
    };

    void frame(Id<Program::Unit> id, const std::string& prefix, const Owner& owner) {
        for (const Program::Variable& variable : program.units[id].variables) {
            const bool temporary = variable.section == Program::Variable::Section::Temporary;
            value(variable, variable.type, prefix + variable.name,
                  {owner.input || variable.input, owner.output || variable.output, owner.temporary || temporary,
                   owner.constant || variable.constant});
        }
    }

    void value(const Program::Variable& variable, Id<Program::Type> of, const std::string& name, const Owner& owner) {
        const Program::Type& type = program.types[of];
        if (type.kind == Program::Type::Kind::Array) {
            for (std::int64_t index = type.low; index <= type.high; ++index)
                value(variable, type.element, name + "[" + std::to_string(index) + "]", owner);
            return;
        }
        if (type.kind == Program::Type::Kind::Unsupported) return;
        if (type.kind != Program::Type::Kind::Block) {
            layout.cells.push_back({name, of, variable.initial, owner.input, owner.output, owner.temporary,
                                    owner.constant, false, variable.origin});
            return;
        }
        const auto begin = static_cast<std::uint32_t>(layout.cells.size());
        const Program::Unit& block = program.units[type.unit];
        if (block.kind == Program::Unit::Kind::FunctionBlock) layout.instances.push_back({name, type.unit, begin});
        frame(type.unit, name + ".", block.kind == Program::Unit::Kind::Structure ? owner : Owner{});
        if (block.name == step_unit) {
            layout.cells[begin].step = true;
            layout.cells[begin].origin = variable.origin;
        }
        if (!block.elapsed) return;
        layout.timers.push_back({begin + *block.running, begin + *block.elapsed, variable.longest});
        layout.longest = std::max(layout.longest, variable.longest);
    }
};

void initialise(const Program& program, Id<Program::Type> of, std::int64_t initial, std::vector<std::int64_t>& cells) {
    const Program::Type& type = program.types[of];
    if (type.kind == Program::Type::Kind::Unsupported) return;
    if (type.kind == Program::Type::Kind::Array) {
        for (std::int64_t index = type.low; index <= type.high; ++index)
            initialise(program, type.element, initial, cells);
    } else if (type.kind == Program::Type::Kind::Block) {
        for (const Program::Variable& variable : program.units[type.unit].variables)
            initialise(program, variable.type, variable.initial, cells);
    } else {
        cells.push_back(initial);
    }
}

}  // namespace

ProgramLayout layout_of(const Program& program) {
    Walk traversal{program};
    traversal.frame(program.globals, "", {});
    traversal.layout.main = static_cast<std::uint32_t>(traversal.layout.cells.size());
    traversal.layout.instances.push_back({"", program.main, traversal.layout.main});
    if (program.main != program.globals) traversal.frame(program.main, "", {});
    return std::move(traversal.layout);
}

std::vector<std::string> unique_names(const ProgramLayout& layout) {
    std::unordered_set<std::string> known;
    std::vector<std::string> names(layout.cells.size());
    // The cells are visited in reverse order, so that the names of the program's variables remain unchanged.
    for (std::size_t i = names.size(); i-- > 0;) {
        names[i] = layout.cells[i].name;
        while (!known.insert(names[i]).second) names[i] = "GLOBAL." + names[i];
    }
    return names;
}

Type type_of_cell(const Program& program, const ProgramLayout& layout, std::size_t cell) {
    const Program::Type& from = program.types[layout.cells[cell].type];
    if (from.kind == Program::Type::Kind::Boolean) return {};
    Type type = integer_type(from.low, from.high);
    // The timers are sorted by address.
    const auto timer = std::ranges::lower_bound(layout.timers, cell, {}, &ProgramTimer::elapsed);
    if (timer != layout.timers.end() && timer->elapsed == cell) type.high = timer->longest;
    return type;
}

std::uint32_t size_of(const Program& program, Id<Program::Type> type) {
    const Program::Type& of = program.types[type];
    if (of.kind == Program::Type::Kind::Unsupported) return 0;
    if (of.kind == Program::Type::Kind::Block) return program.units[of.unit].size;
    if (of.kind != Program::Type::Kind::Array) return 1;
    return static_cast<std::uint32_t>(of.high - of.low + 1) * size_of(program, of.element);
}

std::vector<std::int64_t> initial_cells(const Program& program, const Program::Variable& variable) {
    std::vector<std::int64_t> cells;
    initialise(program, variable.type, variable.initial, cells);
    return cells;
}

std::vector<std::int64_t> initial_frame(const Program& program, Id<Program::Unit> unit) {
    std::vector<std::int64_t> cells;
    for (const Program::Variable& variable : program.units[unit].variables)
        initialise(program, variable.type, variable.initial, cells);
    return cells;
}

std::int64_t wrapped(const Program::Type& type, std::int64_t value) {
    if (value >= type.low && value <= type.high) return value;
    const std::int64_t count = type.high - type.low + 1;  // at most 2^32, because types have at most 32 bits
    const std::int64_t rest = (value - type.low) % count;
    return type.low + (rest < 0 ? rest + count : rest);
}

}  // namespace grafverif
