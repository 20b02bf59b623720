// SPDX-License-Identifier: MIT
#include "check/pdr/unrolling.hpp"

#include <array>
#include <utility>

namespace grafverif::pdr {

Unrolling::Unrolling(const Circuit& circuit, LimitMonitor& watch)
    : circuit_(circuit),
      watch_(watch),
      next_(circuit.gates.size()),
      is_latch_(circuit.gates.size()),
      solver_(unrolled_, watch) {
    for (const Circuit::Latch& latch : circuit.latches) {
        next_[latch.node] = latch.next;
        is_latch_[latch.node] = true;
    }
}

/// Determines the unrolled literal for `node` after `step` steps from the unrolled literals of its operands. Returns
/// false if a literal of an operand is necessary, but not known yet.
bool Unrolling::settle(std::uint32_t node, std::size_t step) {
    Literal& made = states_[step][node];
    const auto known = [&](Literal literal, std::size_t when) {
        const Literal of_node = states_[when][node_of(literal)];
        return of_node == unknown ? unknown : of_node ^ (literal & 1U);
    };
    if (circuit_.gates.is_gate(node)) {
        const Gates::Node gate = circuit_.gates[node];
        const Literal left = known(gate.left, step), right = known(gate.right, step);
        if (left == Gates::no || right == Gates::no) made = Gates::no;
        else if (left != unknown && right != unknown) made = unrolled_.gates.both(left, right);
    } else if (!is_latch_[node]) {
        made = unrolled_.gates.source();
    } else {
        made = step == 0 ? Gates::no : known(next_[node], step - 1);
    }
    return made != unknown;
}

/// Returns the literal of the unrolled circuit that represents the value of `literal` after `step` steps.
Literal Unrolling::at(Literal literal, std::size_t step) {
    while (states_.size() <= step) {
        states_.emplace_back(circuit_.gates.size(), unknown);
        states_.back()[0] = Gates::no;
    }
    std::vector<std::pair<std::uint32_t, std::size_t>> open{{node_of(literal), step}};
    while (!open.empty()) {
        watch_.look();
        const auto [node, when] = open.back();
        if (states_[when][node] != unknown || settle(node, when)) {
            open.pop_back();
            continue;
        }
        if (is_latch_[node]) {
            open.emplace_back(node_of(next_[node]), when - 1);
            continue;
        }
        // The left operand is unrolled first. If the left operand is the constant false, the right operand is not
        // unrolled.
        const Gates::Node gate = circuit_.gates[node];
        const bool left = states_[when][node_of(gate.left)] == unknown;
        open.emplace_back(node_of(left ? gate.left : gate.right), when);
    }
    return states_[step][node_of(literal)] ^ (literal & 1U);
}

std::optional<RunInputs> Unrolling::run_to(Literal bad, std::size_t steps) {
    const Literal there = at(bad, steps);
    if (there == Gates::no) return {};
    const int requested = solver_.of(there);
    if (solver_.solve(std::array{requested})) return inputs_of_result(steps);
    solver_.add(std::array{-requested});
    return {};
}

RunInputs Unrolling::inputs_of_result(std::size_t steps) const {
    RunInputs inputs;
    for (std::size_t step = 0; step <= steps; ++step) {
        std::vector<bool>& values = inputs.emplace_back();
        for (const Circuit::Input& input : circuit_.inputs) {
            const Literal literal = states_[step][input.node];
            values.push_back(literal != unknown && solver_.knows(literal) && solver_.value(literal));
        }
    }
    return inputs;
}

}  // namespace grafverif::pdr
