// SPDX-License-Identifier: MIT
#include "circuit/circuit.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace grafverif {

namespace {

using Faults = std::vector<std::string>;

void check_sources(const Circuit& circuit, Faults& faults) {
    std::vector<int> named(circuit.gates.size());
    const auto name = [&](std::uint32_t node, const std::string& what) {
        if (node == 0 || node >= named.size() || circuit.gates.is_gate(node))
            faults.push_back(fmt::format("{} is not a source", what));
        else if (++named[node] > 1) faults.push_back(fmt::format("{} shares its source with another element", what));
    };
    for (const Circuit::Input& input : circuit.inputs) name(input.node, "input `" + input.name + "`");
    for (const Circuit::Latch& latch : circuit.latches) name(latch.node, "latch `" + latch.name + "`");
    for (std::uint32_t node = 1; node < named.size(); ++node)
        if (!circuit.gates.is_gate(node) && named[node] == 0)
            faults.push_back("a source belongs neither to an input nor to a latch");
}

}  // namespace

std::vector<std::string> verify(const Circuit& circuit) {
    Faults faults;
    const Gates& gates = circuit.gates;
    for (std::uint32_t node = 1; node < gates.size(); ++node)
        if (node_of(gates[node].left) >= node || node_of(gates[node].right) >= node)
            faults.push_back(fmt::format("node {} reads itself or a later node", node));
    check_sources(circuit, faults);
    const auto known = [&](Gates::Literal literal, const char* what) {
        if (node_of(literal) >= gates.size())
            faults.push_back(fmt::format("{} refers to a node that does not exist", what));
    };
    for (const Circuit::Latch& latch : circuit.latches) known(latch.next, "a latch");
    for (const auto* words : {&circuit.words, &circuit.symbols})
        for (const Circuit::Word& word : *words)
            for (const Gates::Literal bit : word.bits) known(bit, "a word");
    for (const Circuit::Target& target : circuit.targets) {
        known(target.bad, "a target");
        known(target.undefined, "a target");
        for (const Gates::Literal each : target.justice) known(each, "a target");
    }
    for (const Circuit::Leak& leak : circuit.leaks) known(leak.bad, "a leak");
    known(circuit.possible, "the condition of possible states");
    known(circuit.in_range, "the condition of values in range");
    return faults;
}

void evaluate_gates(const Circuit& circuit, NodeValues& values) {
    values[0] = false;
    for (std::uint32_t node = 1; node < circuit.gates.size(); ++node)
        if (circuit.gates.is_gate(node))
            values[node] = value_of(values, circuit.gates[node].left) && value_of(values, circuit.gates[node].right);
}

std::int64_t value_of(const NodeValues& values, const Circuit::Word& word) {
    std::uint64_t value = 0;
    for (std::size_t place = 0; place < word.bits.size(); ++place)
        if (value_of(values, word.bits[place])) value |= std::uint64_t{1} << place;
    const std::size_t width = word.bits.size();
    if (word.with_sign && width > 0 && width < 64 && value_of(values, word.bits.back()))
        value |= ~std::uint64_t{0} << width;
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(word.base) + value);
}

void run_through(const Circuit& circuit, const std::vector<std::vector<bool>>& inputs,
                 const std::function<void(const NodeValues&)>& look) {
    NodeValues values(circuit.gates.size());
    for (const std::vector<bool>& given : inputs) {
        for (std::size_t i = 0; i < circuit.inputs.size(); ++i)
            values[circuit.inputs[i].node] = i < given.size() && given[i];
        evaluate_gates(circuit, values);
        look(values);
        std::vector<bool> next;
        for (const Circuit::Latch& latch : circuit.latches) next.push_back(value_of(values, latch.next));
        for (std::size_t i = 0; i < next.size(); ++i) values[circuit.latches[i].node] = next[i];
    }
}

std::vector<std::vector<std::int64_t>> states_of(const Circuit& circuit, const std::vector<std::vector<bool>>& inputs) {
    std::vector<std::vector<std::int64_t>> states;
    run_through(circuit, inputs, [&](const NodeValues& values) {
        std::vector<std::int64_t>& state = states.emplace_back();
        for (const Circuit::Word& word : circuit.words) state.push_back(value_of(values, word));
    });
    return states;
}

}  // namespace grafverif
