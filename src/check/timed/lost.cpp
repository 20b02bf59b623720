// SPDX-License-Identifier: MIT
#include "check/timed/lost.hpp"

#include <algorithm>
#include <vector>

#include "ir/step_names.hpp"

namespace grafverif::timed {

namespace {

using States = std::vector<std::uint32_t>;
using Named = ControllerWords<Network::Variable>::Named;

States reachable_from(Graph& graph, std::uint32_t from, const Limits& limits) {
    StateSet seen(graph.states());
    States found = {from};
    seen.add(from);
    for (std::size_t k = 0; k < found.size(); ++k) {
        limits.poll();
        graph.each(found[k], [&](std::uint32_t next) {
            if (seen.has(next)) return;
            seen.add(next);
            found.push_back(next);
        });
    }
    return found;
}

/// Its condition, as the cycle computes it; not valid: nothing does.
Id<Expr> condition_of(const Network& network, const Network::Controller& controller, const Named& transition) {
    const Network::Template& automaton = network.templates[network.processes[controller.process].automaton];
    for (const Network::Assignment& assignment : automaton.procedures[controller.fire].assignments)
        if (network.exprs[assignment.target].value == static_cast<std::int64_t>(transition.variable.index))
            return assignment.value;
    return {};
}

/// `X3`, `!a`; empty: it is no step and no variable that a person knows.
std::string literal_words(const Network& network, Id<Expr> term) {
    if (network.exprs[term].op == Op::Not) {
        const std::string words = literal_words(network, network.exprs.operands(term)[0]);
        return words.empty() || words.starts_with('!') ? "" : "!" + words;
    }
    if (network.exprs[term].op != Op::Variable) return {};
    const Id<Network::Variable> id = {static_cast<std::uint32_t>(network.exprs[term].value)};
    switch (network.variables[id].role) {
    case Network::Role::Step: return step_variable_name(network, id);
    case Network::Role::Input:
    case Network::Role::Output:
    case Network::Role::Internal: return network.variables[id].name;
    default: return {};
    }
}

/// The first part of the condition that is false in all of these states.
std::string false_part(Graph& graph, Id<Expr> condition, const States& states) {
    const Network& network = graph.machine.network();
    if (!condition.valid()) return {};
    std::vector<Id<Expr>> parts = {condition};
    if (network.exprs[condition].op == Op::And)
        parts.assign(network.exprs.operands(condition).begin(), network.exprs.operands(condition).end());
    for (const Id<Expr> part : parts) {
        const std::string words = literal_words(network, part);
        if (words.empty()) continue;
        const std::uint32_t code = graph.machine.compiler().condition(part, Program::yes, Program::no);
        if (std::ranges::all_of(states, [&](std::uint32_t state) { return graph.holds(code, state) == End::No; }))
            return words;
    }
    return {};
}

}  // namespace

std::string lost_words(Graph& graph, std::uint32_t from, const Limits& limits) {
    const Network& network = graph.machine.network();
    if (network.grain != Grain::Phased) return {};
    const States states = reachable_from(graph, from, limits);
    std::string text;
    for (const Network::Controller& controller : network.controllers)
        for (const Named& transition : controller.words.transitions) {
            const Field field = graph.machine.layout().variables[transition.variable.index];
            const auto clears = [&](std::uint32_t state) { return field.get(graph.load(state)) != 0; };
            if (network.variables[transition.variable].scratch || std::ranges::any_of(states, clears)) continue;
            text += text.empty() ? "" : ", ";
            text += (network.controllers.size() > 1 ? controller.words.name + "." : "") + transition.name;
            const std::string why = false_part(graph, condition_of(network, controller, transition), states);
            if (!why.empty()) text += " (" + why + " stays false)";
        }
    return text.empty() ? text : "from the end of this run on these transitions are never cleared again: " + text;
}

}  // namespace grafverif::timed
