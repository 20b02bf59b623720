// SPDX-License-Identifier: MIT
#include "pipeline/program/initial_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace grafverif {

namespace {

using StatementKind = Program::Statement::Kind;
using UnitKind = Program::Unit::Kind;

Finding finding(const char* code, const Program::Variable& variable, std::string message, Span origin) {
    Finding made;
    made.code = code;
    made.level = Finding::Level::Warning;
    made.subject = variable.name;
    made.message = std::move(message);
    made.origin = origin;
    return made;
}

/// True for an elementary type and for arrays of an elementary type. A structure is excluded, because each of its
/// members has its own initial value.
bool is_elementary(const Program& program, Id<Program::Type> id) {
    const Program::Type& type = program.types[id];
    if (type.kind == Program::Type::Kind::Array) return is_elementary(program, type.element);
    return type.kind != Program::Type::Kind::Block && type.kind != Program::Type::Kind::Unsupported;
}

// -- variables that no statement assigns ------------------------------------------------------------------------------

/// Determines the memory cells that the statements of all instances assign and read.
class Accesses {
public:
    Accesses(const Program& program, const ProgramLayout& layout)
        : program_(program), read(layout.cells.size()), assigned(layout.cells.size()) {
        for (const ProgramInstance& instance : layout.instances)
            for (const Id<Program::Unit> id : program.units.ids())
                if (id == instance.unit || program.units[id].owner == instance.unit) {
                    frame_ = instance.frame;
                    visit(program.units[id].body);
                }
        in_function_ = true;
        for (const Program::Unit& unit : program.units)
            if (unit.kind == UnitKind::Function) visit(unit.body);
    }

private:
    void visit(const Program::Body& body) {
        for (const Id<Program::Statement> id : body) {
            const Program::Statement& statement = program_.statements[id];
            for (const Id<Program::Node> node : {statement.value, statement.last})
                if (node.valid()) visit(node);
            if (statement.kind == StatementKind::Assign || statement.kind == StatementKind::For) {
                visit_indices(statement.place);
                mark(statement.place, assigned);
            }
            for (const Program::Arm& arm : statement.arms) {
                if (arm.condition.valid()) visit(arm.condition);
                visit(arm.body);
            }
        }
    }

    void visit(Id<Program::Node> id) {
        const Program::Node& node = program_.nodes[id];
        if (node.op == Program::Op::Read) {
            visit_indices(node.place);
            mark(node.place, read);
        }
        for (const Id<Program::Node> operand : node.operands) visit(operand);
    }

    void visit_indices(const Program::Place& place) {
        for (const Program::Index& index : place.indices) visit(index.value);
    }

    /// Marks all cells that `place` can denote (several if an array index is not constant). Local variables of
    /// functions are ignored, because they have no cells in the layout.
    void mark(const Program::Place& place, std::vector<bool>& marks) {
        if (in_function_ && !place.global) return;
        std::vector<std::size_t> cells = {(place.global ? 0 : frame_) + place.offset};
        for (const Program::Index& index : place.indices) {
            std::vector<std::size_t> all;
            for (const std::size_t cell : cells)
                for (std::int64_t k = 0; k <= index.high - index.low; ++k)
                    all.push_back(cell + static_cast<std::size_t>(k) * index.stride);
            cells = std::move(all);
        }
        for (const std::size_t cell : cells)
            if (cell < marks.size()) marks[cell] = true;
    }

    const Program& program_;
    std::size_t frame_ = 0;
    bool in_function_ = false;

public:
    std::vector<bool> read, assigned;  ///< for each cell: true if it is read, is assigned
};

/// True if `variable-never-assigned` can apply to the variable: it is declared in the program text, and statements are
/// expected to assign it.
bool is_assignable(const Program& program, const Program::Variable& variable, Id<Source> source) {
    const bool section =
        variable.section == Program::Variable::Section::Local || variable.section == Program::Variable::Section::Output;
    return section && !variable.constant && !variable.input && !variable.initialized &&
           variable.origin.source == source && !is_generated_name(variable.name) && variable.name != "_" &&
           is_elementary(program, variable.type);
}

void add_unassigned(const Program& program, const ProgramLayout& layout, std::vector<Finding>& findings) {
    const Accesses accesses(program, layout);
    const Id<Source> source = program.units[program.main].origin.source;
    const auto any = [](const std::vector<bool>& marks, std::size_t begin, std::size_t size) {
        return std::any_of(marks.begin() + static_cast<std::ptrdiff_t>(begin),
                           marks.begin() + static_cast<std::ptrdiff_t>(begin + size),
                           [](bool marked) { return marked; });
    };
    for (const Id<Program::Unit> id : program.units.ids()) {
        std::vector<std::size_t> frames;
        for (const ProgramInstance& instance : layout.instances)
            if (instance.unit == id) frames.push_back(instance.frame);
        if (id == program.globals && program.globals != program.main) frames.push_back(0);
        if (frames.empty()) continue;
        for (const Program::Variable& variable : program.units[id].variables) {
            if (!is_assignable(program, variable, source)) continue;
            const std::size_t size = size_of(program, variable.type);
            const auto in_some_frame = [&](const std::vector<bool>& marks) {
                return std::ranges::any_of(
                    frames, [&](std::size_t frame) { return any(marks, frame + variable.offset, size); });
            };
            if (in_some_frame(accesses.assigned) || !(variable.output || in_some_frame(accesses.read))) continue;
            findings.push_back(
                finding("variable-never-assigned", variable,
                        fmt::format("no statement assigns `{}`, so it always has its default value", variable.name),
                        variable.origin));
        }
    }
}

// -- variables that exist during one call -----------------------------------------------------------------------------

/// Finds variables in the body of a unit that a statement reads although, on all paths to it, no earlier statement
/// assigns them.
class CallFlow {
public:
    CallFlow(const Program& program, const Program::Unit& unit, std::vector<Finding>& findings)
        : program_(program), findings_(findings) {
        for (const Program::Variable& variable : unit.variables) {
            using Section = Program::Variable::Section;
            const bool local = unit.kind == UnitKind::Function && variable.section == Section::Local;
            const bool watched = variable.section == Section::Temporary || local;
            if (watched && !variable.initialized && !variable.constant && size_of(program, variable.type) == 1 &&
                !is_generated_name(variable.name))
                watched_.push_back(&variable);
        }
        if (!watched_.empty()) visit(unit.body);
    }

private:
    using Cells = std::set<std::uint32_t>;

    void visit(const Program::Body& body) {
        for (const Id<Program::Statement> id : body) visit(program_.statements[id]);
    }

    void visit(const Program::Statement& statement) {
        const bool repeats = statement.kind == StatementKind::Repeat;
        if (statement.value.valid() && !repeats) visit(statement.value);
        if (statement.last.valid()) visit(statement.last);
        for (const Program::Index& index : statement.place.indices) visit(index.value);
        if ((statement.kind == StatementKind::Assign || statement.kind == StatementKind::For) &&
            !statement.place.global)
            assigned_.insert(statement.place.offset);
        // An earlier iteration of a loop may assign a variable that a later iteration reads.
        if (repeats || statement.kind == StatementKind::For || statement.kind == StatementKind::While)
            for (const Program::Arm& arm : statement.arms) add_assigned(arm.body);
        const Cells before = assigned_;
        Cells after = assigned_;
        for (const Program::Arm& arm : statement.arms) {
            assigned_ = before;
            if (arm.condition.valid()) visit(arm.condition);
            visit(arm.body);
            after.insert(assigned_.begin(), assigned_.end());
        }
        assigned_ = std::move(after);
        if (repeats) visit(statement.value);
    }

    void add_assigned(const Program::Body& body) {
        for (const Id<Program::Statement> id : body) {
            const Program::Statement& statement = program_.statements[id];
            if (!statement.place.global) assigned_.insert(statement.place.offset);
            for (const Program::Arm& arm : statement.arms) add_assigned(arm.body);
        }
    }

    void visit(Id<Program::Node> id) {
        const Program::Node& node = program_.nodes[id];
        for (const Program::Index& index : node.place.indices) visit(index.value);
        for (const Id<Program::Node> operand : node.operands) visit(operand);
        if (node.op != Program::Op::Read || node.place.global || assigned_.contains(node.place.offset)) return;
        const auto read = std::ranges::find(watched_, node.place.offset, &Program::Variable::offset);
        if (read == watched_.end()) return;
        findings_.push_back(
            finding("read-before-assignment", **read,
                    fmt::format("`{}` is read before a statement assigns it in the same call, so it has "
                                "its default value",
                                (*read)->name),
                    node.origin));
        watched_.erase(read);
    }

    const Program& program_;
    std::vector<Finding>& findings_;
    std::vector<const Program::Variable*> watched_ = {};
    Cells assigned_ = {};  ///< offsets of cells that a statement before the current position may have assigned
};

}  // namespace

std::vector<Finding> findings_about_initial_values(const Program& program, const ProgramLayout& layout) {
    std::vector<Finding> findings;
    add_unassigned(program, layout, findings);
    for (const Program::Unit& unit : program.units)
        if (unit.origin.source == program.units[program.main].origin.source) CallFlow(program, unit, findings);
    return findings;
}

}  // namespace grafverif
