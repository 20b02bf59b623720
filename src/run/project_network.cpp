// SPDX-License-Identifier: MIT
#include <algorithm>

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
    }
    unreachable();
}

bool holds(const NetworkState& state, Id<Network::Variable> variable) { return state.variables[variable.index] != 0; }

bool calls(const Network::Edge& edge, Id<Network::Procedure> procedure) {
    return procedure.valid() && std::ranges::find(edge.calls, procedure) != edge.calls.end();
}

/// The variables that `edge` assigns, each once, in order.
std::vector<Id<Network::Variable>> assigned(const Network& network, const Network::Process& process,
                                            const Network::Edge& edge) {
    std::vector<Id<Network::Variable>> found;
    for (const Network::Assignment& assignment : edge.assignments) {
        const Expr& leaf = network.exprs[assignment.target];
        const auto index = static_cast<std::uint32_t>(leaf.value);
        const Id<Network::Variable> variable = leaf.op == Op::Variable
                                                   ? Id<Network::Variable>{index}
                                                   : std::get<Id<Network::Variable>>(process.arguments[index]);
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
            view_.add_signal(id.index, {ChartRun::Role::Plant, variable.name, variable.type});
    }
    ChartRun::Moment power_on;
    for (const Id<Network::Controller> id : network.controllers.ids())
        if (!network.controllers[id].start.valid())  // the first evolution has nothing to do
            power_on.acts.push_back({.controller = {id.index},
                                     .starts = true,
                                     .inputs = std::vector<std::int64_t>(run_.controllers[{id.index}].inputs.size())});
    power_on.after = view_.state(time_ms_, state.variables);
    run_.moments.push_back(std::move(power_on));
}

void NetworkProjection::add_controllers() {
    const auto add = [this](Id<Network::Variable> id, ChartRun::Role role) {
        return view_.add_signal(id.index, {role, network_.variables[id].name, network_.variables[id].type});
    };
    // What a controller has written is an output, even where another one reads it.
    for (const Network::Controller& from : network_.controllers)
        for (const Network::Symbol& symbol : from.symbols)
            if (symbol.role == Network::Role::Output) add(symbol.variable, ChartRun::Role::Output);
    for (const Id<Network::Controller> id : network_.controllers.ids()) {
        const Network::Controller& from = network_.controllers[id];
        ChartRun::Controller controller{.name = from.name, .mode = from.mode};
        for (const Network::Named& step : from.steps) view_.add_step(controller, step.name, step.variable.index);
        for (const Network::Named& transition : from.transitions)
            controller.transitions.push_back(run_.transitions.add({transition.name}));
        for (const Network::Symbol& symbol : from.symbols) {
            if (symbol.role == Network::Role::Input)
                controller.inputs.push_back(add(symbol.variable, ChartRun::Role::Input));
            if (symbol.role == Network::Role::Internal)
                controller.internals.push_back(add(symbol.variable, ChartRun::Role::Internal));
            if (symbol.role != Network::Role::Output) continue;
            controller.outputs.push_back(view_.signal(symbol.variable.index));
            controller.images.push_back(symbol.image.valid() ? add(symbol.image, ChartRun::Role::Image)
                                                             : Id<ChartRun::Signal>{});
        }
        add_timers(from, controller);
        controller_of_[from.process.index] = id;
        run_.controllers.add(std::move(controller));
    }
    shorten_names(run_.steps);
}

void NetworkProjection::add_timers(const Network::Controller& from, ChartRun::Controller& controller) {
    for (std::size_t k = 0; k < from.timers.size(); ++k) {
        const Network::TimerVariables& timing = from.timing[k];
        ChartRun::Timer timer{.name = network_.processes[from.timers[k]].name,
                              .watched = timing.watched_name,
                              .rise_ms = timing.rise * network_.time_unit_ms,
                              .fall_ms = timing.fall * network_.time_unit_ms,
                              .exact = timing.pending.valid()};  // as published they are wrong, and are meant to be
        const auto step = std::ranges::find(from.steps, timing.watched, &Network::Named::variable);
        if (step != from.steps.end()) timer.step = static_cast<std::size_t>(step - from.steps.begin());
        timer_of_[from.timers[k].index] = run_.timers.add(std::move(timer));
        controller.timers.push_back(timer_of_[from.timers[k].index]);
        end_of_.push_back(timing.end);
    }
    controller.conditions = from.conditions;
}

void NetworkProjection::append(const Move& move, const NetworkState& before, const NetworkState& after) {
    ChartRun::Moment moment{.move = run_.moments.size() - 1};
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

void NetworkProjection::fill(ChartRun::Moment& moment, const Fire& fire, const NetworkState& before,
                             const NetworkState& after) const {
    const Network::Process& process = network_.processes[fire.process];
    const Network::Edge& edge = network_.templates[process.automaton].edges[fire.edge];
    moment.kind = kind_of(process.kind);
    moment.instance = instance_of_[fire.process.index];
    if (moment.kind == ChartRun::Kind::Controller)
        return moment.acts.push_back(act(controller_of_[fire.process.index], edge, before, after));
    if (edge.from != edge.to || moment.kind == ChartRun::Kind::Timer) moment.location = edge.to.index;
    if (moment.kind != ChartRun::Kind::Timer) {
        for (const Id<Network::Variable> variable : assigned(network_, process, edge)) {
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
    // Without a delay the end only follows what the timer watches.
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
                      .starts = calls(edge, from.start),
                      .samples = calls(edge, from.fire),
                      .evolves = calls(edge, from.evolve)};
    if (act.starts || act.samples)
        for (const Network::Symbol& symbol : from.symbols)
            if (symbol.role == Network::Role::Input) act.inputs.push_back(before.variables[symbol.variable.index]);
    for (std::size_t k = 0; k < from.timers.size(); ++k) {
        if (act.samples) act.timers.push_back(holds(before, from.timing[k].end));
        // Its end does not tell, since it may still be true of an earlier rise.
        if (act.evolves) act.done.push_back(before.locations[from.timers[k].index] == from.timing[k].done);
    }
    // Firing conditions are forgotten by the evolution where it is an edge of its own.
    const NetworkState& fired_in = act.samples ? after : before;
    for (std::size_t k = 0; (act.samples || act.evolves) && k < from.transitions.size(); ++k)
        if (holds(fired_in, from.transitions[k].variable))
            act.fired.push_back(run_.controllers[act.controller].transitions[k]);
    if (act.evolves) act.stable = holds(after, from.stable);
    if (act.evolves || act.starts) act.race = network_.race.valid() && holds(after, network_.race);
    const bool searches = network_.grain == Grain::Atomic && from.mode == ExecutionMode::StabilitySearch;
    if (calls(edge, from.write) && (!searches || holds(after, from.stable))) act.writes = ChartRun::Act::Writes::Yes;
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
