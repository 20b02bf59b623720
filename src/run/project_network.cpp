// SPDX-License-Identifier: MIT
#include <algorithm>

#include "ir/slots.hpp"
#include "run/project.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

namespace {

ChartRun::Kind kind_of(Network::ProcessKind kind) {
    switch (kind) {
    case Network::ProcessKind::Plant: return ChartRun::Kind::Plant;
    case Network::ProcessKind::Environment: return ChartRun::Kind::Environment;
    case Network::ProcessKind::Controller: return ChartRun::Kind::Controller;
    case Network::ProcessKind::Timer: return ChartRun::Kind::Timer;
    case Network::ProcessKind::Observer: return ChartRun::Kind::Observer;
    }
    unreachable();
}

bool holds(const NetworkState& state, Id<Network::Variable> variable) { return state.variables[variable.index] != 0; }

/// Returns the variables that `edge` assigns directly, and not in a procedure. Each variable occurs once, in the order
/// of assignment.
std::vector<Id<Network::Variable>> assigned(const Slots& slots, const Network::Edge& edge) {
    std::vector<Id<Network::Variable>> found;
    for (const Network::Assignment& assignment : edge.assignments) {
        const Id<Network::Variable> variable = slots.variable(slots.network.exprs[assignment.target]);
        if (std::ranges::find(found, variable) == found.end()) found.push_back(variable);
    }
    return found;
}

}  // namespace

NetworkProjection::NetworkProjection(const Network& network, const NetworkState& state, ChartRun& run)
    : network_(network), run_(run), view_(run, network.variables.size(), network.controllers.size() == 1) {
    run_.name = network.name;
    controller_of_.resize(network.processes.size());
    timer_of_.resize(network.processes.size());
    for (const Network::Process& process : network.processes) {
        std::vector<std::string> locations;
        for (const Network::Location& location : network.templates[process.automaton].locations)
            locations.push_back(location.name);
        const bool plc = process.kind == Network::ProcessKind::Controller;
        instance_of_.push_back(plc ? Id<ChartRun::Instance>{}
                                   : run_.instances.add({kind_of(process.kind), process.name, std::move(locations)}));
    }
    add_controllers();
    for (const Id<Network::Variable> id : network.variables.ids()) {
        const Network::Variable& variable = network.variables[id];
        if (variable.role == Network::Role::Plant && !variable.scratch)
            view_.add_signal(id.index, {ChartRun::Role::Plant, variable.display_name(), variable.type});
    }
    ChartRun::Event power_on;
    for (const Id<Network::Controller> id : network.controllers.ids())
        if (!network.controllers[id].start.valid())  // the first evolution has no effect and therefore no edge
            power_on.acts.push_back({.controller = {id.index},
                                     .starts = true,
                                     .inputs = std::vector<std::int64_t>(run_.controllers[{id.index}].inputs.size())});
    power_on.after = view_.state(time_ms_, state.variables);
    run_.moments.push_back(std::move(power_on));
}

void NetworkProjection::add_controllers() {
    // A variable that a controller writes is an output, even if another controller reads it.
    for (const Network::Controller& from : network_.controllers)
        for (const auto& output : from.words.outputs) add_signal(output.variable, ChartRun::Role::Output);
    for (const Id<Network::Controller> id : network_.controllers.ids()) {
        const Network::Controller& from = network_.controllers[id];
        ChartRun::Controller controller = controller_of(from);
        add_timers(from, controller);
        controller_of_[from.process.index] = id;
        run_.controllers.add(std::move(controller));
    }
    shorten_names(run_.steps);
}

Id<ChartRun::Signal> NetworkProjection::add_signal(Id<Network::Variable> id, ChartRun::Role role) {
    return view_.add_signal(id.index, {role, network_.variables[id].name, network_.variables[id].type});
}

/// Adds the signals; an output and its image are adjacent.
ChartRun::Controller NetworkProjection::controller_of(const Network::Controller& from) {
    std::vector<Id<ChartRun::Signal>> images;
    ChartRun::Controller controller = view_.controller(from.words, [&](const auto& named, ChartRun::Role role) {
        if (role == ChartRun::Role::Internal)
            return view_.add_signal(named.variable.index, {role, named.name, network_.variables[named.variable].type});
        const Id<ChartRun::Signal> signal = add_signal(named.variable, role);
        if (role != ChartRun::Role::Output) return signal;
        const Id<Network::Variable> image = from.images[images.size()];
        images.push_back(image.valid() ? add_signal(image, ChartRun::Role::Image) : Id<ChartRun::Signal>{});
        return signal;
    });
    controller.images = std::move(images);
    return controller;
}

void NetworkProjection::add_timers(const Network::Controller& from, ChartRun::Controller& controller) {
    for (std::size_t k = 0; k < from.timers.size(); ++k) {
        const Network::Timer& timer = from.timers[k];
        const auto& words = from.words.timers[k];
        const bool exact = timer.restarts;  // timers as published in CEP13 do not restart and are therefore inexact
        timer_of_[timer.process.index] =
            run_.timers.add({from.words.name, words.watched, words.step, words.rise_ms, words.fall_ms, exact});
        controller.timers.push_back(timer_of_[timer.process.index]);
        end_of_.push_back(words.end);
    }
}

void NetworkProjection::append(const Move& move, const NetworkState& before, const NetworkState& after) {
    ChartRun::Event moment{.move = run_.moments.size() - 1};
    std::visit(overloaded{
                   [&](const Delay& delay) {
                       time_ms_ += delay.units * network_.time_unit_ms;
                       moment.kind = ChartRun::Kind::Delay;
                   },
                   [&](const Fire& fire) { fill(moment, fire, before, after); },
               },
               move);
    moment.after = view_.state(time_ms_, after.variables);
    run_.moments.push_back(std::move(moment));
}

void NetworkProjection::append_by_hand(const NetworkState& after) {
    run_.moments.push_back({.kind = ChartRun::Kind::Environment,
                            .internal = true,
                            .move = run_.moments.size() - 1,
                            .after = view_.state(time_ms_, after.variables)});
}

void NetworkProjection::fill(ChartRun::Event& moment, const Fire& fire, const NetworkState& before,
                             const NetworkState& after) const {
    const Network::Process& process = network_.processes[fire.process];
    const Network::Edge& edge = network_.templates[process.automaton].edges[fire.edge];
    moment.kind = kind_of(process.kind);
    moment.instance = instance_of_[fire.process.index];
    if (moment.kind == ChartRun::Kind::Controller)
        return moment.acts.push_back(act(controller_of_[fire.process.index], edge, before, after));
    if (edge.from != edge.to || moment.kind == ChartRun::Kind::Timer) moment.location = edge.to.index;
    if (moment.kind == ChartRun::Kind::Observer) {  // observers do not change the state of the loop
        moment.internal = true;
        return;
    }
    if (moment.kind != ChartRun::Kind::Timer) {
        for (const Id<Network::Variable> variable : assigned(Slots(network_, fire.process), edge)) {
            const bool changes = before.variables[variable.index] != after.variables[variable.index];
            if (const auto signal = view_.signal(variable.index); signal.valid() && changes)
                moment.changed.push_back(signal);
        }
        return;
    }
    moment.internal = true;
    const Id<ChartRun::Timer> timer = timer_of_[fire.process.index];
    if (!timer.valid()) return;
    moment.timer_holds = holds(after, end_of_[timer.index]);
    // The event is internal if the output of the timer does not change because of an elapsed delay.
    const ChartRun::Timer& of = run_.timers[timer];
    moment.internal = holds(before, end_of_[timer.index]) == moment.timer_holds ||
                      (moment.timer_holds ? of.rise_ms : of.fall_ms) == 0;
    if (!moment.internal) moment.timer = timer;
}

ChartRun::Act NetworkProjection::act(Id<Network::Controller> id, const Network::Edge& edge, const NetworkState& before,
                                     const NetworkState& after) const {
    const Network::Controller& from = network_.controllers[id];
    ChartRun::Act act{.controller = {id.index},
                      .begins = edge.calls.empty() && edge.to != from.waiting,
                      .scans = from.words.cycle && !edge.urgent,
                      .starts = has_call(edge, from.start),
                      .samples = has_call(edge, from.fire),
                      .evolves = has_call(edge, from.evolve)};
    if (act.starts || act.samples) act.inputs = view_.inputs(from.words, act, before.variables);
    for (std::size_t k = 0; k < from.timers.size(); ++k) {
        if (act.samples) act.timers.push_back(holds(before, from.words.timers[k].end));
        // The output of the timer does not show if the rise time has elapsed, because the output may still be true from
        // an earlier rise.
        if (act.evolves) act.done.push_back(before.locations[from.timers[k].process.index] == from.timers[k].done);
    }
    // If the evolution is a separate edge, this edge resets the firing conditions. Therefore the firing conditions are
    // read in the state before this edge.
    const NetworkState& fired_in = act.samples ? after : before;
    for (std::size_t k = 0; (act.samples || act.evolves) && k < from.words.transitions.size(); ++k)
        if (holds(fired_in, from.words.transitions[k].variable))
            act.fired.push_back(run_.controllers[act.controller].transitions[k]);
    if (act.evolves) act.stable = holds(after, from.stable);
    if (act.evolves || act.starts) act.race = network_.race.valid() && holds(after, network_.race);
    const bool searches = network_.grain == Grain::Atomic && from.words.mode == ExecutionMode::StabilitySearch;
    if (has_call(edge, from.write) && (!searches || holds(after, from.stable))) act.writes = ChartRun::Act::Writes::Yes;
    return act;
}

ChartRun project(const Network& network, const Run& run) {
    ChartRun made;
    NetworkState state = initial_state(network);
    NetworkProjection projection(network, state, made);
    for (std::size_t i = 0; i < run.moves.size(); ++i) {
        if (run.loop == i) made.loop = made.moments.size();
        const NetworkState before = state;
        if (perform(network, state, run.moves[i]).result != Step::Result::Done) {
            made.broken_at = i;
            break;
        }
        projection.append(run.moves[i], before, state);
    }
    return made;
}

}  // namespace grafverif
