// SPDX-License-Identifier: MIT
#include "check/timed/dead_transitions.hpp"

#include <algorithm>
#include <vector>

#include "check/lost_text.hpp"
#include "ir/step_names.hpp"
#include "syntax/print/chart.hpp"

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

/// Returns the firing condition that the cycle of the controller evaluates for the transition, or an invalid id if the
/// cycle does not evaluate one.
Id<Expr> condition_of(const Network& network, const Network::Controller& controller, const Named& transition) {
    const Network::Template& automaton = network.templates[network.processes[controller.process].automaton];
    for (const Network::Assignment& assignment : automaton.procedures[controller.fire].assignments)
        if (network.exprs[assignment.target].value == static_cast<std::int64_t>(transition.variable.index))
            return assignment.value;
    return {};
}

/// Returns the text of a step, of a named variable or of the negation of one of these (`X3`, `!a`). For any other term,
/// the result is empty.
std::string literal_text(const Network& network, Id<Expr> term) {
    if (network.exprs[term].op == Op::Not) {
        const std::string words = literal_text(network, network.exprs.operands(term)[0]);
        return words.empty() || words.starts_with('!') ? "" : "!" + words;
    }
    if (network.exprs[term].op != Op::Variable) return {};
    const Id<Network::Variable> id = {static_cast<std::uint32_t>(network.exprs[term].value)};
    if (network.variables[id].scratch) return {};
    switch (network.variables[id].role) {
    case Network::Role::Step: return step_variable_name(network, id);
    case Network::Role::Input:
    case Network::Role::Output:
    case Network::Role::Internal: return network.variables[id].name;
    default: return {};
    }
}

/// Returns the text of the first conjunct of the condition that has a text (see literal_text) and is false in all of
/// `states`. The result is empty if no conjunct has these properties.
std::string false_part(Graph& graph, Id<Expr> condition, const States& states) {
    const Network& network = graph.machine.network();
    if (!condition.valid()) return {};
    std::vector<Id<Expr>> parts = {condition};
    if (network.exprs[condition].op == Op::And)
        parts.assign(network.exprs.operands(condition).begin(), network.exprs.operands(condition).end());
    for (const Id<Expr> part : parts) {
        const std::string words = literal_text(network, part);
        if (words.empty()) continue;
        const std::uint32_t code = graph.machine.compiler().condition(part, Program::yes, Program::no);
        if (std::ranges::all_of(states, [&](std::uint32_t state) { return graph.holds(code, state) == End::No; }))
            return words;
    }
    return {};
}

/// True if the edge executes an evolution of the controller: it calls the procedure that clears transitions.
bool fires(const Network& network, const Network::Controller& controller, const Machine& machine, std::uint32_t edge) {
    if (machine.process_of(edge) != controller.process) return false;
    const Network::Template& automaton = network.templates[network.processes[controller.process].automaton];
    const auto& calls = automaton.edges[machine.edge_of(edge)].calls;
    return std::ranges::find(calls, controller.fire) != calls.end();
}

/// Determines for each transition of each controller whether an evolution from one of `states` clears the transition.
/// If an evolution consists of several edges, a variable contains the value of the firing condition in the states
/// between these edges. If an evolution is a single edge, a scratch variable contains this value; it is set only while
/// the edge is executed.
std::vector<std::vector<bool>> cleared(Graph& graph, const States& states, const Limits& limits) {
    const Network& network = graph.machine.network();
    const Layout& layout = graph.machine.layout();
    std::vector<std::vector<bool>> found;
    for (const Network::Controller& controller : network.controllers)
        found.emplace_back(controller.words.transitions.size(), false);
    const auto look = [&](Id<Network::Controller> id, const Word* words, bool fires) {
        const std::vector<Named>& transitions = network.controllers[id].words.transitions;
        for (std::size_t k = 0; k < transitions.size(); ++k)
            if (network.variables[transitions[k].variable].scratch == fires &&
                layout.variables[transitions[k].variable.index].get(words) != 0)
                found[id.index][k] = true;
    };
    Moves moves;
    for (const std::uint32_t state : states) {
        limits.poll();
        const Word* const words = graph.load(state);
        for (const Id<Network::Controller> id : network.controllers.ids()) look(id, words, false);
        if (network.grain == Grain::Phased) continue;
        graph.machine.expand(words, moves);
        for (std::size_t k = 0; k < moves.edges.size(); ++k)
            for (const Id<Network::Controller> id : network.controllers.ids())
                if (fires(network, network.controllers[id], graph.machine, moves.edges[k]))
                    look(id, moves.words.data() + k * layout.words, true);
    }
    return found;
}

}  // namespace

std::string dead_transitions_note(Graph& graph, std::uint32_t from, const Limits& limits) {
    const Network& network = graph.machine.network();
    const States states = reachable_from(graph, from, limits);
    const std::vector<std::vector<bool>> still = cleared(graph, states, limits);
    std::string text;
    for (const Id<Network::Controller> id : network.controllers.ids()) {
        const Network::Controller& controller = network.controllers[id];
        for (std::size_t k = 0; k < controller.words.transitions.size(); ++k) {
            if (still[id.index][k]) continue;
            const Named& transition = controller.words.transitions[k];
            text += text.empty() ? "" : ", ";
            text += prefix_of(network, controller) + transition.name;
            const std::string why = false_part(graph, condition_of(network, controller, transition), states);
            if (!why.empty()) text += " (" + why + " stays false)";
        }
    }
    return text.empty() ? text : dead_text + text;
}

}  // namespace grafverif::timed
