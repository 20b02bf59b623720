// SPDX-License-Identifier: MIT
// Timed check of a network: compiles the network, explores its states, and evaluates the properties.
#include "check/timed/timed.hpp"

#include <algorithm>
#include <memory>
#include <new>

#include "check/timed/premises.hpp"
#include "check/timed/profile.hpp"
#include "check/timed/property_queries.hpp"
#include "ir/patterns.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

namespace {

ModelError error_of(timed::Graph& graph, const timed::FaultAt& at) {
    ModelError error;
    error.kind = at.fault.kind == timed::End::OutOfRange ? ModelError::Kind::OutOfRange : ModelError::Kind::NoValue;
    if (error.kind == ModelError::Kind::OutOfRange) error.variable = {at.fault.variable};
    error.process = graph.machine.process_of(at.fault.edge);
    error.edge = graph.machine.edge_of(at.fault.edge);
    error.run = graph.run_to(at.state);
    return error;
}

std::vector<ModelError> errors_of(timed::Graph& graph) {
    std::vector<ModelError> errors;
    for (const timed::FaultAt& at : graph.faults) errors.push_back(error_of(graph, at));
    if (!graph.race) return errors;
    errors.push_back({.kind = ModelError::Kind::ActionRace,
                      .variable = graph.machine.network().race,
                      .run = graph.run_to(*graph.race)});
    return errors;
}

std::optional<Premises> premises(timed::Graph& graph, std::uint32_t quiescent, const timed::Limits& limits) {
    try {
        return timed::premises_of(graph, quiescent, limits);
    } catch (const timed::Limits::Stop&) {
    } catch (const std::bad_alloc&) {
    }
    return {};
}

/// Returns the state profile of the graph, or nullopt if memory is exhausted.
std::optional<StateProfile> measured(timed::Graph& graph, const TimedOptions& options, timed::Effort effort) {
    try {
        return timed::profile_of(graph, options.finest ? options.finest() : std::nullopt, effort);
    } catch (const std::bad_alloc&) {
        return {};
    }
}

}  // namespace

TimedResult check_timed(const Network& network, const TimedOptions& options) {
    timed::Limits limits(options);
    const Network flat = expand(network);
    const bool about_single_states =
        !options.timelock && std::ranges::all_of(flat.properties, [&](const Property& property) {
            return is_about_states(property.pattern) || !timed::is_selected(options, property);
        });
    const bool macro_steps = options.macro_steps.enabled && about_single_states;
    timed::Machine machine(flat, options.choices, macro_steps ? timed::unread_variables(flat) : timed::VariableSet{});
    timed::PropertyMonitor monitor;
    timed::PropertyQueries queries(flat, machine, monitor, options.abstracted || !options.choices.empty());
    const Property timelock = timed::undeclared_timelock(flat);
    bool timelock_requested = !options.timelock;
    for (const Id<Property> id : flat.properties.ids()) {
        const Property& property = flat.properties[id];
        if (!timed::is_selected(options, property)) continue;
        queries.add_query(id, property);
        timelock_requested = timelock_requested || timed::about_time(property);
    }
    if (!timelock_requested) queries.add_query({}, timelock);
    std::uint32_t quiescent = timed::Program::no;
    if (options.premises && flat.settled.valid())
        quiescent = machine.compiler().condition(flat.settled, timed::Program::yes, timed::Program::no);

    timed::Graph graph(machine);
    graph.linked = options.keep_links && (options.premises || queries.follow_edges());
    if (options.covering && !options.premises && about_single_states) {
        auto covering =
            std::make_unique<timed::Covering>(flat, machine.layout(), machine.clocks(), options.covering_without);
        graph.covered = covering->applies();
        if (graph.covered) graph.covering = std::move(covering);
    }
    std::vector<timed::Field> races;
    if (flat.race.valid()) races.push_back(machine.layout().variables[flat.race.index]);
    if (macro_steps) graph.macro_steps = timed::MacroSteps(machine, monitor, races, options.macro_steps);
    const UnknownReason ended =
        machine.layout().fits() ? timed::explore(graph, monitor, races, limits) : UnknownReason::Unsupported;

    TimedResult result;
    result.bytes = graph.bytes();
    result.state_bytes = graph.store.state_bytes();
    if (graph.linked) graph.store.drop_index();
    result.errors = errors_of(graph);
    result.verdicts = queries.answers(graph, ended, result.errors, limits);
    if (options.paths) result.paths = queries.paths(graph);
    result.states = graph.states();
    result.transitions = graph.transitions;
    result.complete = ended == UnknownReason::None;
    result.time_passes = graph.time_passes;
    if (options.premises && result.complete) result.premises = premises(graph, quiescent, limits);
    const bool is_large = !result.complete || result.states >= many_states;
    const bool explained = options.profile == ProfileFor::All || (options.profile == ProfileFor::IfLarge && is_large);
    if (explained && result.states > (result.complete ? 0 : 1))  // computes no profile if the search expanded no state
        result.profile =
            measured(graph, options, ended == UnknownReason::Stopped ? timed::Effort::Brief : timed::Effort::Full);
    if (options.each_state && result.complete && !graph.covered) {
        NetworkState now;
        for (std::uint32_t state = 0; state < graph.states(); ++state) {
            graph.read(state, now);
            options.each_state(now);
        }
    }
    result.seconds = limits.seconds();
    for (Verdict& verdict : result.verdicts) {
        verdict.states = std::to_string(result.states);
        verdict.transitions = result.transitions;
        verdict.seconds = result.seconds;
    }
    return result;
}

}  // namespace grafverif
