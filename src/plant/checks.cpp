// SPDX-License-Identifier: MIT
#include "plant/checks.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "support/messages.hpp"

namespace grafverif {

namespace {

/// The value of a term that reads no variable, under the arguments of a process.
std::optional<std::int64_t> constant_value(const Network& network, const Network::Process& process, Id<Expr> root) {
    for (const Id<Expr> leaf : leaves(network.exprs, root)) {
        const Expr& node = network.exprs[leaf];
        if (node.op != Op::Parameter ||
            !std::holds_alternative<std::int64_t>(process.arguments[static_cast<std::size_t>(node.value)]))
            return {};
    }
    return evaluate(network.exprs, root, [&](const Expr& leaf) {
        return std::get<std::int64_t>(process.arguments[static_cast<std::size_t>(leaf.value)]);
    });
}

/// The variable that a leaf stands for in a process; not valid for anything else.
Id<Network::Variable> variable_of(const Network& network, const Network::Process& process, Id<Expr> root) {
    const Expr& node = network.exprs[root];
    if (node.op != Op::Parameter) return {};
    const auto* variable = std::get_if<Id<Network::Variable>>(&process.arguments[static_cast<std::size_t>(node.value)]);
    return variable ? *variable : Id<Network::Variable>{};
}

/// A variable moved by a constant amount: `X := X + D_X`.
struct Step {
    Id<Network::Process> process = {};
    std::int64_t length = 0;
};
using Steps = std::unordered_map<Id<Network::Variable>, Step>;  // the longest one of each variable

void collect_steps(const Network& network, Id<Network::Process> id, Steps& steps) {
    const Network::Process& process = network.processes[id];
    for (const Network::Edge& edge : network.templates[process.automaton].edges) {
        for (const auto& [target, value] : edge.assignments) {
            const Expr& node = network.exprs[value];
            if (node.op != Op::Plus && node.op != Op::Minus) continue;
            const auto operands = network.exprs.operands(value);
            const bool left = operands[0] == target;
            if (!left && (operands[1] != target || node.op == Op::Minus)) continue;
            const auto length = constant_value(network, process, operands[left ? 1 : 0]);
            const Id<Network::Variable> variable = variable_of(network, process, target);
            if (!length || !variable.valid()) continue;
            Step& step = steps[variable];
            if (std::abs(*length) > step.length) step = {id, std::abs(*length)};
        }
    }
}

/// What a conjunction says about a variable: its least and greatest value.
struct Bounds {
    Id<Network::Variable> variable = {};
    std::optional<std::int64_t> low = {}, high = {};
};

void note_bound(const Network& network, const Network::Process& process, Id<Expr> comparison,
                std::vector<Bounds>& found) {
    const Op op = network.exprs[comparison].op;
    if (op < Op::Less || op > Op::GreaterEqual) return;
    const auto operands = network.exprs.operands(comparison);
    const bool turned = !variable_of(network, process, operands[0]).valid();  // `3 <= X`
    const Id<Network::Variable> variable = variable_of(network, process, operands[turned ? 1 : 0]);
    const auto value = constant_value(network, process, operands[turned ? 0 : 1]);
    if (!variable.valid() || !value) return;
    auto here = std::ranges::find(found, variable, &Bounds::variable);
    if (here == found.end()) here = found.insert(found.end(), Bounds{variable, {}, {}});
    const bool upper = (op == Op::Less || op == Op::LessEqual) != turned;
    const std::int64_t strict = op == Op::Less || op == Op::Greater ? 1 : 0;
    if (upper) here->high = std::min(here->high.value_or(INT64_MAX), *value - strict);
    else here->low = std::max(here->low.value_or(INT64_MIN), *value + strict);
}

std::vector<Bounds> bounds(const Network& network, const Network::Process& process, Id<Expr> guard) {
    std::vector<Bounds> found;
    if (network.exprs[guard].op == Op::And)
        for (const Id<Expr> operand : network.exprs.operands(guard)) note_bound(network, process, operand, found);
    return found;
}

}  // namespace

void check_urgent_invariants(const Network& network, Diagnostics& diagnostics) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> told;  // template, edge
    for (const Network::Process& process : network.processes) {
        const Network::Template& automaton = network.templates[process.automaton];
        for (const Id<Network::Edge> id : automaton.edges.ids()) {
            const Network::Edge& edge = automaton.edges[id];
            if (!edge.urgent || keeps_target_invariant(network, process, edge)) continue;
            if (told.emplace(process.automaton.index, id.index).second)
                diagnostics.add(
                    messages::urgent_invariant(edge.origin, automaton.name, automaton.locations[edge.to].name));
        }
    }
}

void warn_skipped_ranges(const Network& network, Diagnostics& diagnostics) {
    Steps steps;
    for (const Id<Network::Process> process : network.processes.ids()) collect_steps(network, process, steps);
    std::set<std::tuple<std::uint32_t, std::uint32_t, std::int64_t, std::int64_t>> told;
    for (const Id<Network::Process> id : network.processes.ids()) {
        const Network::Process& process = network.processes[id];
        for (const Network::Edge& edge : network.templates[process.automaton].edges) {
            for (const auto& [variable, low, high] : bounds(network, process, edge.guard)) {
                const auto step = steps.find(variable);
                if (step == steps.end() || step->second.process == id || !low || !high || *low > *high) continue;
                if (*high - *low + 1 >= step->second.length) continue;
                if (!told.emplace(id.index, variable.index, *low, *high).second) continue;
                const std::string& mover = network.processes[step->second.process].name;
                diagnostics.add(messages::range_skipped(process.origin, network.variables[variable].name, mover,
                                                        step->second.length, process.name, *low, *high));
            }
        }
    }
}

}  // namespace grafverif
