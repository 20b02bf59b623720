// SPDX-License-Identifier: MIT
#include "ir/program/program.hpp"

#include <algorithm>

namespace grafverif {

namespace {

struct Walk {
    const Program& program;
    ProgramLayout layout = {};

    void frame(Id<Program::Unit> id, const std::string& prefix) {
        const Program::Unit& unit = program.units[id];
        for (const Program::Variable& variable : unit.variables) {
            const Program::Type& type = program.types[variable.type];
            if (type.kind != Program::Type::Kind::Block) {
                layout.cells.push_back({prefix + variable.name, variable.type, variable.initial, variable.input,
                                        variable.output, variable.section == Program::Variable::Section::Temporary,
                                        variable.constant, variable.origin});
                continue;
            }
            const auto begin = static_cast<std::uint32_t>(layout.cells.size());
            frame(type.unit, prefix + variable.name + ".");
            const Program::Unit& block = program.units[type.unit];
            if (!block.elapsed) continue;
            layout.timers.push_back({begin + *block.running, begin + *block.elapsed, variable.longest});
            layout.longest = std::max(layout.longest, variable.longest);
        }
    }
};

void initialise(const Program& program, Id<Program::Unit> unit, std::vector<std::int64_t>& cells) {
    for (const Program::Variable& variable : program.units[unit].variables) {
        const Program::Type& type = program.types[variable.type];
        if (type.kind == Program::Type::Kind::Block) initialise(program, type.unit, cells);
        else cells.push_back(variable.initial);
    }
}

}  // namespace

ProgramLayout layout_of(const Program& program) {
    Walk walk{program};
    walk.frame(program.globals, "");
    walk.layout.main = static_cast<std::uint32_t>(walk.layout.cells.size());
    walk.frame(program.main, "");
    return std::move(walk.layout);
}

std::vector<std::int64_t> initial_frame(const Program& program, Id<Program::Unit> unit) {
    std::vector<std::int64_t> cells;
    initialise(program, unit, cells);
    return cells;
}

std::int64_t wrapped(const Program::Type& type, std::int64_t value) {
    if (value >= type.low && value <= type.high) return value;
    const std::int64_t count = type.high - type.low + 1;  // at most 2^32 values
    const std::int64_t rest = (value - type.low) % count;
    return type.low + (rest < 0 ? rest + count : rest);
}

std::string value_text(const Program::Type& type, std::int64_t value) {
    switch (type.kind) {
    case Program::Type::Kind::Boolean: return value != 0 ? "TRUE" : "FALSE";
    case Program::Type::Kind::Time: return "T#" + std::to_string(value) + "ms";
    case Program::Type::Kind::Enumeration:
        if (value >= 0 && static_cast<std::size_t>(value) < type.values.size())
            return type.values[static_cast<std::size_t>(value)];
        break;
    case Program::Type::Kind::Integer:
    case Program::Type::Kind::Bits:
    case Program::Type::Kind::Block: break;
    }
    return std::to_string(value);
}

}  // namespace grafverif
