// SPDX-License-Identifier: MIT
#include "explain/standstill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <ostream>
#include <variant>

#include "ir/literal.hpp"
#include "ir/network_run.hpp"
#include "run/network_walk.hpp"
#include "syntax/print/chart.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

/// Returns text such as `t <= 2s`.
std::string clock_text(const Network& network, Id<Network::Process> id, const Network::ClockConstraint& constraint) {
    const std::int64_t bound = bound_value(network, network.processes[id], constraint.bound);
    return fmt::format("{} {} {}", automaton(network, id).clocks[constraint.clock].name,
                       chart_spelling(constraint.relation).token,
                       bound == 0 ? "0" : duration_text(bound * network.time_unit_ms));
}

/// Returns the guard and the clock constraint in the notation of components, with the names of the loop. Returns `true`
/// if the edge has neither.
std::string condition_text(const Network& network, Id<Network::Process> id, const Network::Edge& edge) {
    const auto leaf = [&](std::ostream& out, const Expr& of) {
        const auto index = static_cast<std::uint32_t>(of.value);
        const Network::Argument argument = of.op == Op::Variable ? Network::Argument(Id<Network::Variable>{index})
                                                                 : network.processes[id].arguments[index];
        if (const auto* const variable = std::get_if<Id<Network::Variable>>(&argument))
            out << network.variables[*variable].display_name();
        else out << std::get<std::int64_t>(argument);
    };
    std::string text;
    const bool guarded = !is_true(network.exprs, edge.guard);
    if (guarded || edge.constraint.empty()) text = expr_text(network.exprs, edge.guard, chart_spelling, leaf);
    if (network.exprs[edge.guard].op == Op::Or && !edge.constraint.empty()) text = '(' + text + ')';
    for (const Network::ClockConstraint& constraint : edge.constraint)
        text += (text.empty() ? "" : " && ") + clock_text(network, id, constraint);
    return text;
}

std::string blocker_words(const Network& network, const Standstill::Blocker& blocker, const std::string& name) {
    const Network::Template& shape = automaton(network, blocker.process);
    std::string bounds, edges;
    for (const Network::ClockConstraint& bound : blocker.bounds)
        bounds += (bounds.empty() ? "" : " && ") + clock_text(network, blocker.process, bound);
    for (const Network::Edge& edge : shape.edges)
        if (edge.from == blocker.location)
            edges += fmt::format("{}to `{}` when `{}`", edges.empty() ? "" : ", ", shape.locations[edge.to].name,
                                 condition_text(network, blocker.process, edge));
    return fmt::format("`{}` blocks time: location `{}`, invariant `{}`, {}", name,
                       shape.locations[blocker.location].name, bounds,
                       edges.empty() ? "no edge leaves this location" : "no edge enabled (" + edges + ")");
}

}  // namespace

Standstill standstill(const Network& network, const Run& run) {
    std::optional<std::vector<NetworkState>> states = replay(network, run);
    if (!states) return {};
    Run whole = run;
    const std::size_t end = states->size() - 1;
    if (!whole.loop && !continue_without_delay(network, whole, *states)) return {};

    const std::size_t first = whole.loop.value_or(states->size() - 1);
    // Element k is true if process k does not prevent time from passing: one of its edges is enabled, or its invariant
    // allows a delay.
    std::vector<bool> free(network.processes.size());
    for (std::size_t at = first; at < states->size(); ++at) {
        const NetworkState& state = (*states)[at];
        if (may_delay(network, state)) return {};
        for (const Fire& move : enabled(network, state)) free[move.process.index] = true;
        for (const Id<Network::Process> id : network.processes.ids())
            if (reached_bounds(network, state, id).empty()) free[id.index] = true;
    }
    Standstill found{.continued = states->size() - 1 > end};
    for (const Id<Network::Process> id : network.processes.ids()) {
        const auto moves = [&](const Move& move) { return std::get<Fire>(move).process == id; };
        if (!free[id.index])
            found.blockers.push_back(
                {id, states->back().locations[id.index], reached_bounds(network, states->back(), id)});
        if (whole.loop &&
            std::any_of(whole.moves.begin() + static_cast<std::ptrdiff_t>(first), whole.moves.end(), moves))
            found.repeating.push_back(id);
    }
    return found;
}

std::string standstill_words(const Network& network, const Standstill& found) {
    const std::vector<std::string> names = display_names(network);
    std::string text;
    for (const Standstill::Blocker& blocker : found.blockers)
        text += (text.empty() ? "" : "; ") + blocker_words(network, blocker, names[blocker.process.index]);
    if (!text.empty())
        return (found.continued ? "after further edges without delay, " : "") + text +
               "; add an edge that can leave the location when the invariant blocks time, or relax the invariant";
    for (const Id<Network::Process> id : found.repeating)
        text += fmt::format("{}`{}`", text.empty() ? "" : ", ", names[id.index]);
    if (text.empty()) return {};
    return "edges of " + text +
           " repeat forever within one instant; make one of these edges wait, for example for a clock";
}

}  // namespace grafverif
