// SPDX-License-Identifier: MIT
#include "run/program/controller_replay.hpp"

#include <algorithm>
#include <cassert>
#include <map>

#include "ir/program/interface.hpp"

namespace grafverif {

ProgramControllerReplay::ProgramControllerReplay(const ChartRun& run, const ChartRun::Controller& controller,
                                                 const Program& program)
    : run_(&run), controller_(&controller), interpreter_(program), scans_(run, controller) {
    const std::vector<std::string> names = unique_names(interpreter_.layout());
    const std::string prefix = run.controllers.size() > 1 ? controller.name + "." : "";
    // The run omits variables on which no property or output depends.
    std::map<std::string, Id<ChartRun::Signal>> internals;
    for (const Id<ChartRun::Signal> signal : controller.internals) internals[run.signals[signal].name] = signal;
    for (const std::size_t i : variable_cells(interpreter_.layout())) {
        const ProgramCell& cell = interpreter_.layout().cells[i];
        if (cell.input) cells_.inputs.push_back(i);
        else if (cell.output) cells_.outputs.push_back(i);
        else if (const auto known = internals.find(prefix + names[i]); known != internals.end() && !cell.step) {
            cells_.internals.push_back(i);
            internals_.push_back(known->second);
        }
    }
    // If the numbers were different, the replay would ignore a variable of the run.
    assert(internals_.size() == controller.internals.size());
    cells_.steps = step_cells(interpreter_.layout());
}

std::optional<ProgramFault> ProgramControllerReplay::fault() const {
    return interpreter_.fault() ? std::optional(interpreter_.fault()->kind) : std::nullopt;
}

std::string ProgramControllerReplay::pass(std::int64_t milliseconds) { return over_ ? "" : scans_.pass(milliseconds); }

std::string ProgramControllerReplay::does(const ChartRun::Act& act, const ChartRun::State& before,
                                          const ChartRun::State& after) {
    if (over_) return {};
    if (std::string fault = scans_.act(act, before); !fault.empty()) return fault;
    if (act.starts || act.samples) inputs_ = act.inputs;
    std::optional<bool> stable;
    if (act.starts || act.evolves) {
        const std::vector<std::int64_t> earlier = kept(), unseen = hidden();
        if (std::string fault = scan(act, after); !fault.empty() || over_) return fault;
        // The run does not contain the internal variables of timers and SFC charts that a program cannot read.
        const bool changes = kept() != earlier, changes_hidden = hidden() != unseen;
        if (act.stable && changes && *act.stable)
            return "the scan changes nothing, but according to the program it changes a variable";
        if (act.stable && !changes && !changes_hidden && !*act.stable)
            return "the scan changes a variable, but according to the program it changes nothing";
        if (act.evolves) stable = act.stable.value_or(!changes);
    }
    const bool writes = act.writes == ChartRun::Act::Writes::Yes;
    scans_.done(stable, writes);
    if (writes) return difference(cells_.outputs, controller_->outputs, after);
    for (const Id<ChartRun::Signal> output : controller_->outputs)
        if (before.values[output.index] != after.values[output.index] && !act.starts)
            return "output " + run_->signals[output].name + " changes, but no scan writes it";
    return {};
}

std::string ProgramControllerReplay::scan(const ChartRun::Act& act, const ChartRun::State& after) {
    // The interpreter expects the inputs in the order of the cells.
    std::vector<std::pair<std::size_t, std::int64_t>> sampled;
    for (std::size_t k = 0; k < cells_.inputs.size(); ++k) sampled.emplace_back(cells_.inputs[k], inputs_[k]);
    std::ranges::sort(sampled);
    std::vector<std::int64_t> values;
    for (const auto& [cell, value] : sampled) values.push_back(value);
    const bool advances = act.evolves && controller_->cycle;
    interpreter_.scan(values, advances ? controller_->cycle->least_ms : 0, log_);
    if (act.evolves) ++evolutions_;
    if (std::string fault = fault_difference(act); !fault.empty() || over_) return fault;
    if (std::string found = situation_difference(after); !found.empty()) return found;
    if (std::string found = difference(cells_.internals, internals_, after); !found.empty()) return found;
    return difference(cells_.outputs, controller_->images, after);
}

std::string ProgramControllerReplay::fault_difference(const ChartRun::Act& act) {
    const bool faulty = interpreter_.fault().has_value();
    over_ = faulty && act.race.value_or(true);
    raced_ = over_ && act.race.has_value();
    if (over_ || faulty == act.race.value_or(false)) return {};
    return faulty ? "no fault, but according to the program the scan has a run-time fault"
                  : "a run-time fault, but according to the program there is none";
}

std::string ProgramControllerReplay::difference(const std::vector<std::size_t>& cells,
                                                const std::vector<Id<ChartRun::Signal>>& signals,
                                                const ChartRun::State& now) const {
    for (std::size_t k = 0; k < cells.size(); ++k) {
        if (!signals[k].valid()) continue;
        const std::int64_t value = now.values[signals[k].index], expected = interpreter_.cells()[cells[k]];
        if (value != expected)
            return interpreter_.layout().cells[cells[k]].name + " is " + std::to_string(value) +
                   ", but according to the program " + std::to_string(expected);
    }
    return {};
}

std::string ProgramControllerReplay::situation_difference(const ChartRun::State& now) const {
    for (std::size_t k = 0; k < cells_.steps.size(); ++k) {
        const bool active = std::ranges::binary_search(now.situation, controller_->steps[k]);
        if (active == (interpreter_.cells()[cells_.steps[k]] != 0)) continue;
        return "step " + run_->steps[controller_->steps[k]].name.text() + " is " + (active ? "active" : "not active") +
               ", but according to the program it is " + (active ? "not active" : "active");
    }
    return {};
}

std::vector<std::int64_t> ProgramControllerReplay::hidden() const {
    std::vector<std::int64_t> values;
    for (const std::size_t cell : variable_cells(interpreter_.layout()))
        if (const ProgramCell& of = interpreter_.layout().cells[cell]; !of.input && !of.output && !of.step)
            values.push_back(interpreter_.cells()[cell]);
    return values;
}

std::vector<std::int64_t> ProgramControllerReplay::kept() const {
    std::vector<std::int64_t> values;
    for (const std::vector<std::size_t>* const cells : {&cells_.outputs, &cells_.internals, &cells_.steps})
        for (const std::size_t cell : *cells) values.push_back(interpreter_.cells()[cell]);
    return values;
}

namespace {

/// Executes the scans of a program with free inputs. Inputs that the run does not contain keep their initial values.
void replay_free_scans(const ChartRun& run, const Program& program,
                       const std::function<bool(std::size_t event, const ScanLog& log)>& visit) {
    ProgramRun interpreter(program);
    std::map<std::string, std::size_t> places;  // index of each input among the inputs of an act
    for (const Id<ChartRun::Signal> signal : run.controllers[{0}].inputs)
        places.emplace(run.signals[signal].name, places.size());
    for (std::size_t event = 0; event < run.moments.size() && !interpreter.fault(); ++event)
        for (const ChartRun::Act& act : run.moments[event].acts) {
            if (!act.elapsed_ms) continue;
            std::vector<std::int64_t> inputs;
            for (const ProgramCell& cell : interpreter.layout().cells) {
                if (!cell.input) continue;
                const auto place = places.find(cell.name);
                inputs.push_back(place == places.end() ? cell.initial : act.inputs[place->second]);
            }
            ScanLog log;
            interpreter.scan(inputs, *act.elapsed_ms, &log);
            if (!visit(event, log)) return;
        }
}

/// True if the run is a run of a program with free inputs, without a closed loop.
bool has_free_inputs(const ChartRun& run) {
    return std::ranges::any_of(run.moments, [](const ChartRun::Event& event) {
        return std::ranges::any_of(event.acts, [](const ChartRun::Act& act) { return act.elapsed_ms.has_value(); });
    });
}

}  // namespace

void replay_scans(const ChartRun& run, Id<ChartRun::Controller> controller, const Program& program,
                  const std::function<bool(std::size_t event, const ScanLog& log)>& visit) {
    if (has_free_inputs(run)) return replay_free_scans(run, program, visit);
    ProgramControllerReplay replay(run, run.controllers[controller], program);
    ScanLog log;
    replay.write_to(&log);
    const ChartRun::State* before = &run.moments.front().after;
    for (std::size_t event = 0; event < run.moments.size(); ++event) {
        const ChartRun::State& after = run.moments[event].after;
        const std::int64_t passed = run.timed ? after.time_ms - before->time_ms : 0;
        bool fails = passed > 0 && !replay.pass(passed).empty();
        for (const ChartRun::Act& act : run.moments[event].acts) {
            if (act.controller != controller) continue;
            log = {};
            fails = fails || !replay.does(act, *before, after).empty();
            if (fails) return;
            if ((act.starts || act.evolves) && !visit(event, log)) return;
            if (replay.fault()) return;
        }
        before = &after;
    }
}

}  // namespace grafverif
