// SPDX-License-Identifier: MIT
#include "plant/checks.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "ir/slots.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

/// The value of a term that reads no variable.
std::optional<std::int64_t> constant_value(const Slots& slots, Id<Expr> root) {
    const Exprs& exprs = slots.network.exprs;
    for (const Id<Expr> leaf : leaves(exprs, root))
        if (slots.variable(exprs[leaf]).valid()) return {};
    return evaluate(exprs, root, [&](const Expr& leaf) { return slots.constant(leaf); });
}

/// The variable that a term is; not valid for anything else.
Id<Network::Variable> variable_of(const Slots& slots, Id<Expr> root) {
    const Expr& node = slots.network.exprs[root];
    return node.op == Op::Parameter ? slots.variable(node) : Id<Network::Variable>{};
}

/// A variable moved by a constant amount: `X := X + D_X`.
struct Step {
    Id<Network::Process> process = {};
    std::int64_t length = 0;
};
using Steps = std::unordered_map<Id<Network::Variable>, Step>;  // the longest one of each variable

void collect_steps(const Network& network, Id<Network::Process> id, Steps& steps) {
    const Slots slots(network, id);
    for (const Network::Edge& edge : slots.automaton.edges) {
        for (const auto& [target, value] : edge.assignments) {
            const Expr& node = network.exprs[value];
            if (node.op != Op::Plus && node.op != Op::Minus) continue;
            const auto operands = network.exprs.operands(value);
            const bool left = operands[0] == target;
            if (!left && (operands[1] != target || node.op == Op::Minus)) continue;
            const auto length = constant_value(slots, operands[left ? 1 : 0]);
            const Id<Network::Variable> variable = variable_of(slots, target);
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

void note_bound(const Slots& slots, Id<Expr> comparison, std::vector<Bounds>& found) {
    const Op op = slots.network.exprs[comparison].op;
    if (op < Op::Less || op > Op::GreaterEqual) return;
    const auto operands = slots.network.exprs.operands(comparison);
    const bool turned = !variable_of(slots, operands[0]).valid();  // `3 <= X`
    const Id<Network::Variable> variable = variable_of(slots, operands[turned ? 1 : 0]);
    const auto value = constant_value(slots, operands[turned ? 0 : 1]);
    if (!variable.valid() || !value) return;
    auto here = std::ranges::find(found, variable, &Bounds::variable);
    if (here == found.end()) here = found.insert(found.end(), Bounds{variable, {}, {}});
    const bool upper = (op == Op::Less || op == Op::LessEqual) != turned;
    const std::int64_t strict = op == Op::Less || op == Op::Greater ? 1 : 0;
    if (upper) here->high = std::min(here->high.value_or(INT64_MAX), *value - strict);
    else here->low = std::max(here->low.value_or(INT64_MIN), *value + strict);
}

std::vector<Bounds> bounds(const Slots& slots, Id<Expr> guard) {
    const Exprs& exprs = slots.network.exprs;
    std::vector<Bounds> found;
    if (exprs[guard].op == Op::And)
        for (const Id<Expr> operand : exprs.operands(guard)) note_bound(slots, operand, found);
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
        const Slots slots(network, id);
        for (const Network::Edge& edge : slots.automaton.edges) {
            for (const auto& [variable, low, high] : bounds(slots, edge.guard)) {
                const auto step = steps.find(variable);
                if (step == steps.end() || step->second.process == id || !low || !high || *low > *high) continue;
                if (*high - *low + 1 >= step->second.length) continue;
                if (!told.emplace(id.index, variable.index, *low, *high).second) continue;
                const std::string& mover = network.processes[step->second.process].name;
                diagnostics.add(messages::range_skipped(slots.process.origin, network.variables[variable].name, mover,
                                                        step->second.length, slots.process.name, *low, *high));
            }
        }
    }
}

}  // namespace grafverif
