// SPDX-License-Identifier: MIT
#include "check/pdr/justify.hpp"

#include <algorithm>

namespace grafverif::pdr {

Justifier::Justifier(const Circuit& circuit)
    : circuit_(circuit),
      is_latch_(circuit.gates.size()),
      seen_(circuit.gates.size()),
      needed_(circuit.gates.size()),
      cost_(circuit.gates.size()),
      values_(circuit.gates.size()) {
    for (const Circuit::Latch& latch : circuit.latches) is_latch_[latch.node] = true;
}

void Justifier::collect(const std::vector<Gates::Literal>& targets) {
    cone_.clear();
    const auto meet = [this](Gates::Literal literal) {
        const std::uint32_t node = node_of(literal);
        if (node == 0 || seen_[node] == round_) return;
        seen_[node] = round_;
        cone_.push_back(node);
    };
    for (const Gates::Literal target : targets) meet(target);
    for (std::size_t i = 0; i < cone_.size(); ++i) {
        const Gates::Node gate = circuit_.gates[cone_[i]];
        meet(gate.left);
        meet(gate.right);
    }
    std::ranges::sort(cone_);
}

Justifier::Justification Justifier::part(const std::vector<Gates::Literal>& targets,
                                         const std::function<bool(Gates::Literal)>& value) {
    ++round_;
    collect(targets);
    const auto holds = [this](Gates::Literal literal) {
        return (values_[node_of(literal)] != 0) != is_inverted(literal);
    };
    constexpr std::uint32_t many = 1U << 20U;
    for (const std::uint32_t node : cone_) {
        const Gates::Node gate = circuit_.gates[node];
        if (!circuit_.gates.is_gate(node)) {
            values_[node] = value(2 * node) ? 1 : 0;
            cost_[node] = is_latch_[node] ? 1 : 0;
            continue;
        }
        const bool left = holds(gate.left), right = holds(gate.right);
        const std::uint32_t left_cost = cost_[node_of(gate.left)], right_cost = cost_[node_of(gate.right)];
        values_[node] = left && right ? 1 : 0;
        cost_[node] = left == right ? (left ? std::min(many, left_cost + right_cost) : std::min(left_cost, right_cost))
                                    : (left ? right_cost : left_cost);
    }
    Justification part;
    for (const Gates::Literal target : targets) needed_[node_of(target)] = round_;
    for (std::size_t i = cone_.size(); i-- > 0;) {
        const std::uint32_t node = cone_[i];
        if (needed_[node] != round_) continue;
        if (!circuit_.gates.is_gate(node)) {
            (is_latch_[node] ? part.latches : part.inputs).push_back(2 * node + (values_[node] != 0 ? 0 : 1));
            continue;
        }
        const Gates::Node gate = circuit_.gates[node];
        const std::uint32_t left = node_of(gate.left), right = node_of(gate.right);
        if (values_[node] != 0) {
            needed_[left] = needed_[right] = round_;
            continue;
        }
        const bool by_left = !holds(gate.left), by_right = !holds(gate.right);
        if ((by_left && needed_[left] == round_) || (by_right && needed_[right] == round_)) continue;
        needed_[by_left && (!by_right || cost_[left] <= cost_[right]) ? left : right] = round_;
    }
    std::ranges::reverse(part.latches);
    std::ranges::reverse(part.inputs);
    return part;
}

}  // namespace grafverif::pdr
