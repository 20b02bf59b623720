// SPDX-License-Identifier: MIT
#include "derive/program/controller.hpp"

#include <algorithm>
#include <utility>

#include "derive/program/scan.hpp"
#include "ir/interval.hpp"
#include "ir/program/interface.hpp"
#include "support/messages_program.hpp"

namespace grafverif {

namespace {

using Role = Equations::Role;

class ControllerEquations {
public:
    explicit ControllerEquations(Scan scan) : scan_(std::move(scan)) {}

    /// True if the value of every operation fits into 64 bits. In this case, a term can be evaluated under any
    /// condition, because its evaluation cannot overflow.
    bool is_total() const {
        const auto type_of = [&](const Expr& leaf) {
            return equations().variables[{static_cast<std::uint32_t>(leaf.value)}].type;
        };
        return std::ranges::none_of(intervals(equations().exprs, type_of), is_clipped);
    }

    /// Returns the equations of the controller. `first` contains the terms of the scan at power-on.
    Equations build(const Scan& first, const ProgramController& controller) && {
        TermCopier copy(first.equations.exprs, exprs(),
                        [this](const Expr& leaf) { return exprs().leaf(Op::Variable, variable_of(leaf)); });
        for (std::size_t k = 0; k < equations().stored.size(); ++k)
            equations().stored[k].first = copy(first.equations.stored[k].next);
        for (const Scan::Event& fault : scan_.faults) equations().conflicts.push_back({fault.condition, fault.origin});
        for (const Scan::Event& fault : first.faults)
            equations().conflicts.push_back({exprs().constant(false), fault.origin, copy(fault.condition)});
        // Without a cycle time, the controller executes scans until `stable` is true. The number of these scans depends
        // on all variables, so that no equation can be removed.
        if (controller.cycle && !controller.reads_stable) omit_unread(controller.observed);
        separate_steps();
        hide(controller.observed);
        equations().name = controller.name;
        equations().is_program = true;
        return std::move(scan_.equations);
    }

private:
    const Equations& equations() const { return scan_.equations; }
    Equations& equations() { return scan_.equations; }
    Exprs& exprs() { return equations().exprs; }
    static std::uint32_t variable_of(const Expr& leaf) { return static_cast<std::uint32_t>(leaf.value); }

    /// Removes the equations of variables on which no observed value depends. A scan is stable if the remaining
    /// variables are unchanged.
    void omit_unread(const std::vector<Id<Equations::Variable>>& observed) {
        std::vector<Id<Expr>> roots;
        const auto add = [&](Id<Equations::Variable> id) { roots.push_back(exprs().leaf(Op::Variable, id.index)); };
        for (const Id<Equations::Variable> id : observed) add(id);
        for (const std::size_t cell : step_cells(scan_.layout)) add(scan_.variables[cell]);
        for (const Id<Equations::Variable> id : equations().variables.ids())
            if (equations().variables[id].role == Role::Output) add(id);
        for (const Equations::Conflict& fault : equations().conflicts) {
            roots.push_back(fault.condition);
            if (fault.first.valid()) roots.push_back(fault.first);
        }
        const std::vector<bool> read = variables_read(scan_, roots);
        std::erase_if(equations().stored,
                      [&](const Equations::Stored& stored) { return !read[stored.variable.index]; });
        std::vector<Id<Expr>> unchanged;
        for (const Equations::Stored& stored : equations().stored)
            unchanged.push_back(
                exprs().apply(Op::Equal, stored.next, exprs().leaf(Op::Variable, stored.variable.index)));
        equations().stable = exprs().conjunction(unchanged);
        for (const Id<Equations::Variable> id : equations().variables.ids()) {
            Equations::Variable& variable = equations().variables[id];
            if (variable.role == Role::Internal && !read[id.index] && !variable.type.boolean)
                variable.type.low = variable.type.high = variable.initial;
        }
    }

    /// Hides unobserved variables of timers and charts from traces: variables of timers, because elapsed times change
    /// in every scan, and variables of charts, because their names are generated.
    void hide(const std::vector<Id<Equations::Variable>>& observed) {
        std::vector<std::size_t> cells;
        for (const ProgramTimer& timer : scan_.layout.timers) cells.insert(cells.end(), {timer.running, timer.elapsed});
        for (std::size_t i = 0; i < scan_.layout.cells.size(); ++i)
            if (is_generated_name(scan_.layout.cells[i].name)) cells.push_back(i);
        for (const std::size_t cell : cells) {
            const Id<Equations::Variable> id = scan_.variables[cell];
            const bool has_equation =
                std::ranges::find(equations().stored, id, &Equations::Stored::variable) != equations().stored.end();
            if (has_equation && std::ranges::find(observed, id) == observed.end())
                equations().variables[id].role = Role::Previous;
        }
    }

    /// Converts the stored variables of steps to step activities, so that traces show the situation.
    void separate_steps() {
        for (const std::size_t cell : step_cells(scan_.layout)) {
            const Id<Equations::Variable> id = scan_.variables[cell];
            const auto stored = std::ranges::find(equations().stored, id, &Equations::Stored::variable);
            Equations::Variable& variable = equations().variables[id];
            variable.role = Role::Step;
            const Id<Expr> active = exprs().leaf(Op::Variable, id.index);
            Equations::StepActivity step;
            step.variable = id;
            step.next = stored->next;
            step.activated = exprs().conjunction(stored->next, exprs().negation(active));
            step.deactivated = exprs().conjunction(active, exprs().negation(stored->next));
            step.step = step_name(variable.name);
            step.origin = variable.origin;
            step.first = stored->first;
            equations().steps.push_back(std::move(step));
            equations().stored.erase(stored);
        }
    }

    Scan scan_;
};

}  // namespace

std::optional<Equations> controller_equations(const Program& program, const ProgramController& controller,
                                              Diagnostics& diagnostics) {
    const std::optional<TaskCycle>& cycle = controller.cycle;
    Program timed = program;
    timed.interval_ms = {};
    if (cycle && cycle->least_ms == cycle->most_ms) timed.interval_ms = cycle->least_ms;
    auto scan = scan_of(timed, diagnostics);
    if (!scan) return {};
    if (scan->elapsed.valid()) {
        diagnostics.add(messages::program_without_cycle(controller.origin, controller.name));
        return {};
    }
    timed.interval_ms = 0;
    const auto first = scan_of(timed, diagnostics);
    if (!first) return {};
    ControllerEquations equations(std::move(*scan));
    if (!equations.is_total()) {
        diagnostics.add(messages::program_beyond_64_bits(controller.origin, controller.name));
        return {};
    }
    return std::move(equations).build(*first, controller);
}

}  // namespace grafverif
