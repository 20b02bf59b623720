// SPDX-License-Identifier: MIT
#include "grafverif/report/tell.hpp"

#include <algorithm>
#include <unordered_set>

#include "grafverif/support/overloaded.hpp"
#include "report/words.hpp"

namespace grafverif {

namespace {

constexpr std::uint32_t nobody = Id<Network::Controller>::none;

std::vector<std::int64_t> values(const NetworkState& state, const std::vector<Id<Network::Variable>>& variables) {
    std::vector<std::int64_t> list;
    list.reserve(variables.size());
    for (const Id<Network::Variable> variable : variables) list.push_back(state.variables[variable.index]);
    return list;
}

bool differ(const NetworkState& left, const NetworkState& right, Id<Network::Variable> variable) {
    return left.variables[variable.index] != right.variables[variable.index];
}

Trace::Kind kind_of(Network::ProcessKind kind) {
    switch (kind) {
        case Network::ProcessKind::Plant: return Trace::Kind::Plant;
        case Network::ProcessKind::Environment: return Trace::Kind::Environment;
        case Network::ProcessKind::Controller: return Trace::Kind::Controller;
        case Network::ProcessKind::Timer: return Trace::Kind::Timer;
    }
    unreachable();
}

bool calls(const Network::Edge& edge, Id<Network::Procedure> procedure) {
    return procedure.valid() && std::ranges::find(edge.calls, procedure) != edge.calls.end();
}

const Network::Edge& edge_of(const Network& network, const Fire& fire) {
    return network.templates[network.processes[fire.process].automaton].edges[fire.edge];
}

const char* phase_word(const Network::Controller& controller, const Network::Edge& edge) {
    if (calls(edge, controller.start)) return "first evolution";
    if (edge.calls.size() > 1) return "cycle";
    if (calls(edge, controller.fire)) return "inputs sampled";
    if (calls(edge, controller.evolve)) return "evolution";
    if (calls(edge, controller.write)) return "outputs written";
    return edge.to == controller.waiting ? "cycle ends" : "cycle begins";
}

std::vector<std::string> cleared(const Network::Controller& controller, const NetworkState& state) {
    std::vector<std::string> names;
    for (const Network::Named& transition : controller.transitions)
        if (state.variables[transition.variable.index] != 0) names.push_back(transition.name);
    return names;
}

}  // namespace

Teller::Teller(const Network& network, Detail detail) : network_(network), detail_(detail) {
    make_signals();
    index_processes();
    open_.resize(network.controllers.size());
    const bool alone = network.controllers.size() == 1;
    add({.kind = Trace::Kind::Controller,
         .component = alone ? network.controllers.begin()->name : network.name,
         .what = "power on"},
        initial_state(network));
}

void Teller::make_signals() {
    std::unordered_set<std::uint32_t> written;
    for (const Network::Controller& controller : network_.controllers)
        for (const Network::Symbol& symbol : controller.symbols)
            if (symbol.role == Network::Role::Output) written.insert(symbol.variable.index);
    std::unordered_set<std::uint32_t> told;
    const auto signal = [&](Id<Network::Variable> id, std::vector<Id<Network::Variable>>& ids,
                            std::vector<Trace::Signal>& list) {
        if (!told.insert(id.index).second) return;
        ids.push_back(id);
        list.push_back({network_.variables[id].name, network_.variables[id].type});
    };
    for (const Network::Controller& controller : network_.controllers) {
        const std::string prefix = network_.controllers.size() == 1 ? "" : controller.name + ".";
        for (const Network::Named& step : controller.steps) {
            steps_.push_back(step.variable);
            trace_.steps_of_charts.push_back(prefix + step.name);
        }
        for (const auto& [role, variable, image, name] : controller.symbols) {
            if (role == Network::Role::Input && !written.contains(variable.index))
                signal(variable, inputs_, trace_.inputs);
            if (role == Network::Role::Output) signal(variable, outputs_, trace_.outputs);
            if (role == Network::Role::Internal) signal(variable, internals_, trace_.internals);
        }
    }
    trace_.short_names = shortened_names(trace_.steps_of_charts);
    for (const Id<Network::Variable> id : network_.variables.ids())
        if (network_.variables[id].role == Network::Role::Plant && !network_.variables[id].scratch)
            signal(id, plant_, trace_.plant);
}

void Teller::index_processes() {
    controller_of_.assign(network_.processes.size(), nobody);
    for (const Id<Network::Controller> id : network_.controllers.ids()) {
        controller_of_[network_.controllers[id].process.index] = id.index;
        for (const Id<Network::Process> timer : network_.controllers[id].timers) controller_of_[timer.index] = id.index;
    }
}

Trace::State Teller::snapshot(const NetworkState& state) const {
    Trace::State told{.time_ms = time_ms_,
                      .inputs = values(state, inputs_),
                      .outputs = values(state, outputs_),
                      .internals = values(state, internals_),
                      .plant = values(state, plant_)};
    for (std::uint32_t i = 0; i < steps_.size(); ++i)
        if (state.variables[steps_[i].index] != 0) told.situation.push_back(i);
    return told;
}

void Teller::add(Trace::Step step, const NetworkState& state) {
    step.after = snapshot(state);
    trace_.steps.push_back(std::move(step));
}

void Teller::close_delay(const NetworkState& state) {
    if (delay_ms_ == 0) return;
    time_ms_ += delay_ms_;
    const std::string what = seconds_text(delay_ms_) + (delay_ms_ == 1000 ? " passes" : " pass");
    delay_ms_ = 0;
    add({.kind = Trace::Kind::Delay, .what = what}, state);
}

void Teller::close(std::size_t controller, const NetworkState& state) {
    Open& open = open_[controller];
    const bool sampled = open.sampled;
    if (!open.fired.empty() || open.changed) {
        Trace::Step step{.kind = Trace::Kind::Controller,
                         .component = network_.controllers[{static_cast<std::uint32_t>(controller)}].name};
        if (open.first) step.what = "first evolution";
        else if (!open.written) step.what = "outputs not yet written";
        step.fired = std::move(open.fired);
        add(std::move(step), state);
    }
    open = {};
    open.sampled = sampled;
}

void Teller::flush(const NetworkState& now) {
    close_delay(now);
    for (std::size_t controller = 0; controller < open_.size(); ++controller) close(controller, now);
}

void Teller::begin_loop(const NetworkState& now) {
    flush(now);
    trace_.loop_from = trace_.steps.size();
}

void Teller::finish(const NetworkState& now) {
    flush(now);
    if (!trace_.loop_from) return;
    const auto loop = trace_.steps.begin() + static_cast<std::ptrdiff_t>(*trace_.loop_from);
    if (loop == trace_.steps.end()) {
        add({.kind = Trace::Kind::Controller, .what = "cycles go on for ever, no time passes, nothing changes"}, now);
        return;
    }
    const bool waits =
        std::all_of(loop, trace_.steps.end(), [](const Trace::Step& step) { return step.kind == Trace::Kind::Delay; });
    if (waits) loop->what = "time passes, for ever";
}

void Teller::move(const Move& move, const NetworkState& before, const NetworkState& after) {
    std::visit(overloaded{
                   [&](const Delay& delay) {
                       for (std::size_t controller = 0; controller < open_.size(); ++controller)
                           close(controller, before);
                       delay_ms_ += delay.units * network_.time_unit_ms;
                   },
                   [&](const Fire& fire) {
                       close_delay(before);
                       switch (network_.processes[fire.process].kind) {
                           case Network::ProcessKind::Plant:
                           case Network::ProcessKind::Environment: return tell_instance(fire, before, after);
                           case Network::ProcessKind::Timer: return tell_timer(fire, before, after);
                           case Network::ProcessKind::Controller: return tell_controller(fire, before, after);
                       }
                   },
               },
               move);
}

/// The sampling of a cycle matters where a sampled input changes before the evolution that reads it.
void Teller::tell_sampling(const NetworkState& before, const NetworkState& after) {
    for (const Id<Network::Controller> id : network_.controllers.ids()) {
        Open& open = open_[id.index];
        const Network::Controller& controller = network_.controllers[id];
        if (!open.sampled || detail_ == Detail::Everything || cleared(controller, before).empty()) continue;
        const bool changes = std::ranges::any_of(controller.symbols, [&](const Network::Symbol& symbol) {
            return symbol.role == Network::Role::Input && differ(before, after, symbol.variable);
        });
        if (!changes) continue;
        add({.kind = Trace::Kind::Controller, .component = controller.name, .what = "inputs sampled"}, before);
        open.sampled = false;
    }
}

void Teller::tell_instance(const Fire& fire, const NetworkState& before, const NetworkState& after) {
    for (std::size_t controller = 0; controller < open_.size(); ++controller) close(controller, before);
    tell_sampling(before, after);
    const Network::Process& process = network_.processes[fire.process];
    add({.kind = kind_of(process.kind),
         .component = process.name,
         .what = instance_words(network_, fire, before, after)},
        after);
}

void Teller::tell_timer(const Fire& fire, const NetworkState& before, const NetworkState& after) {
    const Id<Network::Controller> id{controller_of_[fire.process.index]};
    const std::string& name = network_.processes[fire.process].name;
    if (id.index != nobody) {
        const Network::Controller& controller = network_.controllers[id];
        const auto place = std::ranges::find(controller.timers, fire.process) - controller.timers.begin();
        const Network::TimerVariables& timing = controller.timing[static_cast<std::size_t>(place)];
        const bool value = after.variables[timing.end.index] != 0;
        // Without a delay the end variable only follows what the timer watches.
        if (differ(before, after, timing.end) && (value ? timing.rise : timing.fall) > 0) {
            for (std::size_t other = 0; other < open_.size(); ++other) close(other, before);
            return add({.kind = Trace::Kind::Timer,
                        .component = name,
                        .what = timer_words(network_, controller, timing, value)},
                       after);
        }
    }
    if (detail_ == Detail::Everything)
        add({.kind = Trace::Kind::Timer, .component = name, .what = location_word(network_, fire), .internal = true},
            after);
}

void Teller::tell_controller(const Fire& fire, const NetworkState& before, const NetworkState& after) {
    const std::uint32_t index = controller_of_[fire.process.index];
    const Network::Controller& controller = network_.controllers[{index}];
    const Network::Edge& edge = edge_of(network_, fire);
    for (std::size_t other = 0; other < open_.size(); ++other)
        if (other != index) close(other, before);

    Open& open = open_[index];
    const bool fires = calls(edge, controller.fire);
    if (fires) open.sampled = true;
    if (calls(edge, controller.evolve)) {
        // Firing conditions are forgotten by the evolution where it is an edge of its own.
        std::vector<std::string> names = cleared(controller, fires ? after : before);
        if (!names.empty()) open.fired.push_back(std::move(names));
        open.sampled = false;
        open.written = false;
    }
    for (const auto& [role, variable, image, name] : controller.symbols)
        if (role != Network::Role::Input &&
            (differ(before, after, variable) || (image.valid() && differ(before, after, image))))
            open.changed = true;
    open.first = open.first || (open.changed && calls(edge, controller.start));
    const bool writes = calls(edge, controller.write) &&
                        (network_.grain == Grain::Phased || controller.mode == ExecutionMode::EveryCycle ||
                         after.variables[controller.stable.index] != 0);
    open.written = open.written || writes;
    if (detail_ == Detail::Everything) return tell_phase(index, edge, open, after);
    if (writes) close(index, after);
}

void Teller::tell_phase(std::size_t controller, const Network::Edge& edge, const Open& open,
                        const NetworkState& after) {
    const Network::Controller& words = network_.controllers[{static_cast<std::uint32_t>(controller)}];
    Trace::Step step{
        .kind = Trace::Kind::Controller, .component = words.name, .what = phase_word(words, edge), .fired = open.fired};
    step.internal = open.fired.empty() && !open.changed;
    add(std::move(step), after);
    const bool sampled = open.sampled;
    open_[controller] = {};
    open_[controller].sampled = sampled;
}

Trace tell(const Network& network, const Run& run, Detail detail) {
    Teller teller(network, detail);
    NetworkState state = initial_state(network);
    for (std::size_t i = 0; i < run.moves.size(); ++i) {
        if (run.loop == i) teller.begin_loop(state);
        const NetworkState before = state;
        perform(network, state, run.moves[i]);
        teller.move(run.moves[i], before, state);
    }
    teller.finish(state);
    return teller.trace();
}

}  // namespace grafverif
