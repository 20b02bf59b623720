// SPDX-License-Identifier: MIT
#include "pipeline/program/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ir/program/interface.hpp"
#include "run/program/interpreter.hpp"

namespace grafverif {

namespace {

using Kind = ProgramProperty::Kind;

/// True if the last scan violates `property`. For a property that requires a reachable condition: true if the condition
/// is true in the last scan.
bool shows(const ProgramProperty& property, ProgramRun& run) {
    const auto holds = [&](Id<Program::Node> node) { return run.value(node) != 0; };
    switch (property.kind) {
    case Kind::Invariant:
    case Kind::Assertion: return !holds(property.conditions.front());
    case Kind::Reachability:
    case Kind::Reachable: return holds(property.conditions.front());
    case Kind::MutualExclusion: return std::ranges::count_if(property.conditions, holds) > 1;
    case Kind::Absence:
        return property.error == ProgramProperty::Error::Overflow
                   ? !run.fault() && run.overflowed()
                   : run.fault() && run.fault()->kind == property.fault();
    case Kind::Termination: break;
    }
    return false;
}

class Replay {
public:
    Replay(const Program& program, const Scan& scan, const ProgramSystem& system, const SystemRun& run)
        : program_(program), scan_(scan), system_(system), run_(run), interpreter_(program) {
        trace_.name = scan.equations.name;
        trace_.timed = false;
        trace_.searches = false;
        ChartRun::Controller controller;
        controller.name = scan.equations.name;
        controller.mode = ExecutionMode::EveryCycle;
        for (std::size_t i = 0; i < scan.variables.size(); ++i) {
            const Id<Equations::Variable> id = scan.variables[i];
            const ProgramCell& cell = scan.layout.cells[i];
            if (!id.valid() || cell.step || (!cell.output && !symbol(i).valid())) continue;
            const auto role = cell.input    ? ChartRun::Role::Input
                              : cell.output ? ChartRun::Role::Output
                                            : ChartRun::Role::Internal;
            const auto signal = trace_.signals.add({role, cell.name, scan.equations.variables[id].type});
            (cell.input    ? controller.inputs
             : cell.output ? controller.outputs
                           : controller.internals)
                .push_back(signal);
            shown_.push_back(i);
        }
        steps_ = step_cells(scan.layout);
        for (const std::size_t cell : steps_)
            controller.steps.push_back(trace_.steps.add({step_name(scan.layout.cells[cell].name)}));
        shorten_names(trace_.steps);
        trace_.controllers.add(std::move(controller));
    }

    ProgramReplay replay(const ProgramProperty* property) {
        event(0);
        for (std::size_t k = 0; k < run_.states.size() && !interpreter_.fault(); ++k) {
            const std::string difference = compare(k);
            if (!difference.empty()) return {difference, {}, {}};
            scan(k);
            event(k + 1);
        }
        add_rows();
        const bool about_fault = property != nullptr && property->is_about_fault();
        const bool expected = property == nullptr
                                  ? interpreter_.fault().has_value()
                                  : (about_fault || !interpreter_.fault()) && shows(*property, interpreter_);
        if (!expected) return {"the last scan of the replay does not confirm the verdict", {}, {}};
        return {{}, std::move(trace_), interpreter_.fault() ? std::optional(interpreter_.fault()->kind) : std::nullopt};
    }

private:
    Id<TransitionSystem::Symbol> symbol(std::size_t cell) const {
        const Id<Equations::Variable> id = scan_.variables[cell];
        return id.valid() ? system_.symbols[id.index] : Id<TransitionSystem::Symbol>{};
    }

    /// Compares the values of the memory cells before scan `k` with the values in state `k` of the run. Returns a
    /// description of the first difference, or an empty string if all values are equal.
    std::string compare(std::size_t k) {
        for (std::size_t i = 0; i < scan_.layout.cells.size(); ++i) {
            if (scan_.layout.cells[i].input || !symbol(i).valid()) continue;
            const std::int64_t expected = run_.states[k][symbol(i).index];
            if (interpreter_.cells()[i] != expected)
                return fmt::format("before scan {}: `{}` is {}, not {}", k + 1, scan_.layout.cells[i].name,
                                   interpreter_.cells()[i], expected);
        }
        return {};
    }

    void scan(std::size_t k) {
        std::vector<std::int64_t> inputs;
        for (std::size_t i = 0; i < scan_.layout.cells.size(); ++i)
            if (scan_.layout.cells[i].input)
                inputs.push_back(symbol(i).valid() ? run_.states[k][symbol(i).index] : scan_.layout.cells[i].initial);
        std::int64_t elapsed = program_.interval_ms.value_or(0);
        if (scan_.elapsed.valid() && system_.symbols[scan_.elapsed.index].valid())
            elapsed = run_.states[k][system_.symbols[scan_.elapsed.index].index];
        interpreter_.scan(inputs, elapsed);
        elapsed_ = elapsed;
    }

    void event(std::size_t number) {
        ChartRun::Event moment;
        ChartRun::Act act{.controller = {0}, .begins = true, .starts = number == 0};
        if (number > 0) {
            act.samples = act.evolves = true;
            act.elapsed_ms = elapsed_;
            act.writes = ChartRun::Act::Writes::Yes;
        }
        moment.move = number;
        moment.after.time_ms = static_cast<std::int64_t>(number);
        for (std::uint32_t i = 0; i < shown_.size(); ++i) {
            const std::int64_t value = interpreter_.cells()[shown_[i]];
            moment.after.values.push_back(value);
            if (scan_.layout.cells[shown_[i]].input) act.inputs.push_back(value);
            if (!trace_.moments.empty() && trace_.moments.back().after.values[i] != value)
                moment.changed.push_back({i});
        }
        for (std::uint32_t k = 0; k < steps_.size(); ++k)
            if (interpreter_.cells()[steps_[k]] != 0) moment.after.situation.push_back({k});
        moment.acts.push_back(std::move(act));
        trace_.moments.push_back(std::move(moment));
    }

    /// Adds a row for the state before the first scan, for the last scan, and for each scan that changes a step, a
    /// Boolean variable, an input or an output. Other scans have no row, because a run may have thousands of scans that
    /// only change internal counters.
    void add_rows() {
        for (std::size_t i = 0; i < trace_.moments.size(); ++i) {
            const bool changes_steps =
                i != 0 && trace_.moments[i].after.situation != trace_.moments[i - 1].after.situation;
            const bool visible =
                changes_steps || std::ranges::any_of(trace_.moments[i].changed, [&](Id<ChartRun::Signal> id) {
                    return trace_.signals[id].type.boolean || trace_.signals[id].role != ChartRun::Role::Internal;
                });
            if (i != 0 && !visible && i + 1 != trace_.moments.size()) continue;
            ChartRun::Row row{.kind = ChartRun::Kind::Controller};
            row.what = i == 0 ? "before the first scan" : "";
            row.component = i == 0 ? "" : "scan";
            row.moment = i;
            trace_.rows.push_back(std::move(row));
        }
    }

    const Program& program_;
    const Scan& scan_;
    const ProgramSystem& system_;
    const SystemRun& run_;
    ProgramRun interpreter_;
    std::vector<std::size_t> shown_ = {};  ///< for each signal, the index of its memory cell
    std::vector<std::size_t> steps_ = {};  ///< for each step, the index of its memory cell
    std::int64_t elapsed_ = 0;             ///< time before the last scan, in milliseconds
    ChartRun trace_ = {};
};

}  // namespace

ProgramReplay replay_program(const Program& program, const Scan& scan, const ProgramSystem& system,
                             const SystemRun& run, const ProgramProperty* property) {
    return Replay(program, scan, system, run).replay(property);
}

}  // namespace grafverif
