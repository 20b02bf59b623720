// SPDX-License-Identifier: MIT
#include "report/words.hpp"

#include <algorithm>
#include <vector>

#include "grafverif/ir/step_names.hpp"
#include "grafverif/report/tell.hpp"

namespace grafverif {

namespace {

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

std::string instance_words(const Network& network, const Fire& fire, const NetworkState& before,
                           const NetworkState& after, bool inputs) {
    const Network::Process& process = network.processes[fire.process];
    const Network::Edge& edge = network.templates[process.automaton].edges[fire.edge];
    std::string words;
    if (edge.from != edge.to) words = location_word(network, fire);
    for (const Id<Network::Variable> id : assigned(network, process, edge)) {
        const Network::Variable& variable = network.variables[id];
        const bool told = variable.role == Network::Role::Plant || (inputs && variable.role == Network::Role::Input);
        if (!told || before.variables[id.index] == after.variables[id.index]) continue;
        if (!words.empty()) words += ", ";
        words += change_words(variable.name, variable.type, before.variables[id.index], after.variables[id.index]);
    }
    return words;
}

std::string choice_words(const Network& network, const NetworkState& state, const Fire& fire) {
    NetworkState after = state;
    perform(network, after, fire);
    const Network::Process& process = network.processes[fire.process];
    const bool instance =
        process.kind == Network::ProcessKind::Plant || process.kind == Network::ProcessKind::Environment;
    const std::string words =
        instance ? instance_words(network, fire, state, after, true) : location_word(network, fire);
    return words.empty() ? process.name : process.name + ": " + words;
}

namespace {

std::string duration_words(const Network& network, std::int64_t units) {
    const std::int64_t ms = units * network.time_unit_ms;
    return ms % 1000 == 0 ? std::to_string(ms / 1000) + "s" : std::to_string(ms) + "ms";
}

/// What a timer watches as conditions write it; of a longer term nothing.
std::string watched_words(const Network& network, const Network::Controller& controller, Id<Network::Variable> watched) {
    for (const Network::Named& step : controller.steps)
        if (step.variable == watched) return step_variable_name(step.name);
    const std::string& level = network.variables[watched].name;
    for (const Network::Symbol& symbol : controller.symbols)
        if (level.ends_with("V_" + network.variables[symbol.variable].name))
            return network.variables[symbol.variable].name;
    return {};
}

}  // namespace

std::string timer_words(const Network& network, const Network::Controller& controller,
                        const Network::TimerVariables& timing, bool value) {
    const std::string watched = watched_words(network, controller, timing.watched);
    if (watched.empty()) return duration_words(network, value ? timing.rise : timing.fall) + " are over";
    std::string words = (timing.rise > 0 ? duration_words(network, timing.rise) + "/" : "") + watched;
    if (timing.fall > 0) words += "/" + duration_words(network, timing.fall);
    return words + (value ? " is true" : " is false");
}

const std::string& location_word(const Network& network, const Fire& fire) {
    const Network::Template& automaton = network.templates[network.processes[fire.process].automaton];
    return automaton.locations[automaton.edges[fire.edge].to].name;
}

std::string value_words(const std::string& name, const Type& type, std::int64_t value) {
    if (type.boolean) return value != 0 ? name : "!" + name;
    return name + " = " + std::to_string(value);
}

std::string change_words(const std::string& name, const Type& type, std::int64_t before, std::int64_t after) {
    if (type.boolean) return value_words(name, type, after);
    return name + " " + std::to_string(before) + " -> " + std::to_string(after);
}

}  // namespace grafverif
