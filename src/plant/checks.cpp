// SPDX-License-Identifier: MIT
#include "plant/checks.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "ir/slots.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

/// Returns the value of a term that reads no variable; nullopt for any other term.
std::optional<std::int64_t> constant_value(const Slots& slots, Id<Expr> root) {
    const Exprs& exprs = slots.network.exprs;
    for (const Id<Expr> leaf : leaves(exprs, root))
        if (slots.variable(exprs[leaf]).valid()) return {};
    return evaluate(exprs, root, [&](const Expr& leaf) { return slots.constant(leaf); });
}

/// Returns the variable if the term is a variable, otherwise an invalid id.
Id<Network::Variable> variable_of(const Slots& slots, Id<Expr> root) {
    const Expr& node = slots.network.exprs[root];
    return node.op == Op::Parameter ? slots.variable(node) : Id<Network::Variable>{};
}

/// A change of a variable by a constant, such as `X := X + D_X`.
struct Step {
    Id<Network::Process> process = {};
    std::int64_t length = 0;
};
using Steps = std::unordered_map<Id<Network::Variable>, Step>;  // for each variable: its change by the largest constant

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

/// Bounds of a variable that a conjunction implies.
struct Bounds {
    Id<Network::Variable> variable = {};
    std::optional<std::int64_t> low = {}, high = {};
};

/// True if the absolute value of `value` exceeds about 2^41. No variable can have such a value, and the sum of two
/// smaller values fits into 64 bits.
bool is_far(std::int64_t value) { return std::abs(value / 2) > std::int64_t{1} << 40U; }

/// A variable, or a linear term with one variable that is bound to an input, such as `H`, `H - 2` or `10 - H`.
struct Shifted {
    Id<Network::Variable> variable = {};  ///< invalid if the term has a different form
    std::int64_t offset = 0;
    bool mirrored = false;
};

Shifted shifted(const Slots& slots, Id<Expr> root) {
    const Exprs& exprs = slots.network.exprs;
    const Op op = exprs[root].op;
    if (op == Op::Parameter || op == Op::Variable) return {slots.variable(exprs[root]), 0, false};
    if (op != Op::Plus && op != Op::Minus) return {};
    const auto operands = exprs.operands(root);
    const auto left = constant_value(slots, operands[0]), right = constant_value(slots, operands[1]);
    if (left.has_value() == right.has_value() || is_far(left.value_or(right.value_or(0)))) return {};
    Shifted made = shifted(slots, operands[left ? 1 : 0]);
    const bool turned = left && op == Op::Minus;
    const std::int64_t by = left ? *left : op == Op::Minus ? -*right : *right;
    if (turned) made.mirrored = !made.mirrored;
    made.offset = by + (turned ? -made.offset : made.offset);
    return made;
}

void note_bound(const Slots& slots, Id<Expr> comparison, std::vector<Bounds>& found) {
    const Op op = slots.network.exprs[comparison].op;
    if (op < Op::Less || op > Op::GreaterEqual) return;
    const auto operands = slots.network.exprs.operands(comparison);
    const auto left = constant_value(slots, operands[0]);  // the constant of a comparison such as `3 <= X`
    const auto value = left ? left : constant_value(slots, operands[1]);
    const Shifted of = shifted(slots, operands[left ? 1 : 0]);
    if (!of.variable.valid() || !value || is_far(*value)) return;
    auto here = std::ranges::find(found, of.variable, &Bounds::variable);
    if (here == found.end()) here = found.insert(found.end(), Bounds{of.variable, {}, {}});
    const std::int64_t at = of.mirrored ? of.offset - *value : *value - of.offset;
    const bool upper = ((op == Op::Less || op == Op::LessEqual) != left.has_value()) != of.mirrored;
    const std::int64_t strict = op == Op::Less || op == Op::Greater ? 1 : 0;
    if (upper) here->high = std::min(here->high.value_or(INT64_MAX), at - strict);
    else here->low = std::max(here->low.value_or(INT64_MIN), at + strict);
}

/// Returns the bounds of variables that the conjunction `guard` implies. Nested conjunctions are included; they occur
/// if a guard reads an input that is bound to a conjunction.
std::vector<Bounds> bounds(const Slots& slots, Id<Expr> guard) {
    const Exprs& exprs = slots.network.exprs;
    std::vector<Bounds> found;
    std::vector<Id<Expr>> waiting{guard};
    while (!waiting.empty()) {
        const Id<Expr> term = waiting.back();
        waiting.pop_back();
        if (exprs[term].op != Op::And) note_bound(slots, term, found);
        else std::ranges::copy(exprs.operands(term), std::back_inserter(waiting));
    }
    return found;
}

}  // namespace

void check_urgent_invariants(const Network& network, Diagnostics& diagnostics) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> reported;  // pairs of template and edge that are already reported
    for (const Network::Process& process : network.processes) {
        const Network::Template& automaton = network.templates[process.automaton];
        for (const Id<Network::Edge> id : automaton.edges.ids()) {
            const Network::Edge& edge = automaton.edges[id];
            if (!edge.urgent || keeps_target_invariant(network, process, edge)) continue;
            if (reported.emplace(process.automaton.index, id.index).second)
                diagnostics.add(
                    messages::urgent_invariant(edge.origin, automaton.name, automaton.locations[edge.to].name));
        }
    }
}

void warn_skipped_ranges(const Network& network, Diagnostics& diagnostics) {
    Steps steps;
    for (const Id<Network::Process> process : network.processes.ids()) collect_steps(network, process, steps);
    std::set<std::tuple<std::uint32_t, std::uint32_t, std::int64_t, std::int64_t>> reported;
    for (const Id<Network::Process> id : network.processes.ids()) {
        const Slots slots(network, id);
        for (const Network::Edge& edge : slots.automaton.edges) {
            for (const auto& [variable, low, high] : bounds(slots, edge.guard)) {
                const auto step = steps.find(variable);
                if (step == steps.end() || step->second.process == id || !low || !high || *low > *high) continue;
                if (*high - *low + 1 >= step->second.length) continue;
                if (!reported.emplace(id.index, variable.index, *low, *high).second) continue;
                const std::string& mover = network.processes[step->second.process].name;
                diagnostics.add(messages::range_skipped(slots.process.origin, network.variables[variable].name, mover,
                                                        step->second.length, slots.process.name, *low, *high));
            }
        }
    }
}

}  // namespace grafverif
