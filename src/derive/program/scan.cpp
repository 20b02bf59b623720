// SPDX-License-Identifier: MIT
#include "derive/program/scan.hpp"

#include <algorithm>
#include <utility>

#include "derive/program/execution.hpp"
#include "ir/literal.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"

namespace grafverif {

namespace {

using Role = Equations::Role;

/// Maximum depth of terms. The depth is limited, because some engines traverse terms recursively.
constexpr std::uint32_t deepest_term = 5000;

class ScanDerivation {
public:
    ScanDerivation(const Program& program, Diagnostics& diagnostics) : program_(program), diagnostics_(diagnostics) {}

    std::optional<Scan> scan(bool records) {
        scan_.layout = layout_of(program_);
        scan_.equations.name = program_.units[program_.main].name;
        scan_.equations.origin = program_.units[program_.main].origin;
        SymbolicExecution execution(program_, scan_.layout, exprs(), diagnostics_);
        add_variables(execution.memory());
        advance_timers(execution.memory());
        if (records) execution.record(scan_.executions);
        execution.run_main();
        if (execution.failed()) return {};
        scan_.after.assign(execution.memory().begin(),
                           execution.memory().begin() + static_cast<std::ptrdiff_t>(scan_.layout.cells.size()));
        scan_.faults = std::move(execution.faults);
        scan_.overflows = std::move(execution.overflows);
        if (is_too_deep()) {
            diagnostics_.add(messages::program_too_large(
                scan_.equations.origin, "operations per scan that depend on each other", deepest_term));
            return {};
        }
        store();
        return std::move(scan_);
    }

private:
    Exprs& exprs() { return scan_.equations.exprs; }

    void add_variables(std::vector<Id<Expr>>& memory) {
        const std::vector<ProgramCell>& cells = scan_.layout.cells;
        scan_.variables.resize(cells.size());
        const std::vector<std::string> names = unique_names(scan_.layout);
        for (std::size_t i = cells.size(); i-- > 0;) {
            const ProgramCell& cell = cells[i];
            const Type type = type_of_cell(program_, scan_.layout, i);
            memory[i] = literal(exprs(), type, cell.initial);
            if (cell.constant || cell.temporary) continue;
            const Role role = cell.input ? Role::Input : cell.output ? Role::Output : Role::Internal;
            scan_.variables[i] = scan_.equations.variables.add({names[i], role, type, cell.initial, cell.origin});
            memory[i] = exprs().leaf(Op::Variable, scan_.variables[i].index);
        }
    }

    void advance_timers(std::vector<Id<Expr>>& memory) {
        if (scan_.layout.longest == 0) return;  // no timer of the program measures an elapsed time
        Id<Expr> step;
        if (program_.interval_ms) {
            step = exprs().integer(*program_.interval_ms);
        } else {
            std::string name = "elapsed_ms";
            const auto names = unique_names(scan_.layout);
            while (std::ranges::find(names, name) != names.end()) name = "GLOBAL." + name;
            scan_.elapsed = scan_.equations.variables.add(
                {std::move(name), Equations::Role::Input,
                 integer_type(0, std::max<std::int64_t>(scan_.layout.longest, 1)), 0, scan_.equations.origin});
            step = exprs().leaf(Op::Variable, scan_.elapsed.index);
        }
        for (const ProgramTimer& timer : scan_.layout.timers) {
            const Id<Expr> longest = exprs().integer(timer.longest);
            const Id<Expr> later = exprs().apply(Op::Plus, memory[timer.elapsed], step);
            const Id<Expr> capped = exprs().conditional(exprs().apply(Op::Less, later, longest), later, longest);
            memory[timer.elapsed] = exprs().conditional(memory[timer.running], capped, memory[timer.elapsed]);
        }
    }

    bool is_too_deep() {
        std::vector<std::uint32_t> depths(exprs().size());
        for (std::uint32_t index = 0; index < depths.size(); ++index) {
            for (const Id<Expr> operand : exprs().operands(Id<Expr>{index}))
                depths[index] = std::max(depths[index], depths[operand.index] + 1);
            if (depths[index] > deepest_term) return true;
        }
        return false;
    }

    void store() {
        std::vector<Id<Expr>> unchanged;
        for (std::size_t i = 0; i < scan_.variables.size(); ++i) {
            const Id<Equations::Variable> id = scan_.variables[i];
            if (!id.valid() || scan_.layout.cells[i].input) continue;
            Equations::Stored stored;
            stored.variable = id;
            stored.next = scan_.after[i];
            stored.first = exprs().leaf(Op::Variable, id.index);
            stored.race = stored.first_race = exprs().constant(false);
            unchanged.push_back(exprs().apply(Op::Equal, stored.next, stored.first));
            scan_.equations.stored.push_back(std::move(stored));
        }
        scan_.equations.stable = exprs().conjunction(unchanged);
    }

    const Program& program_;
    Diagnostics& diagnostics_;
    Scan scan_ = {};
};

}  // namespace

std::optional<Scan> scan_of(const Program& program, Diagnostics& diagnostics, bool records) {
    return ScanDerivation(program, diagnostics).scan(records);
}

std::optional<Id<Expr>> value_after(const Program& program, Id<Program::Node> node, Scan& scan,
                                    Diagnostics& diagnostics) {
    SymbolicExecution execution(program, scan.layout, scan.equations.exprs, diagnostics);
    std::ranges::copy(scan.after, execution.memory().begin());
    const Id<Expr> value = execution.value(node, scan.layout.main);
    if (execution.failed()) return {};
    if (!execution.faults.empty()) {
        diagnostics.add(messages::division_by_zero(execution.faults.front().origin));
        return {};
    }
    return value;
}

}  // namespace grafverif
