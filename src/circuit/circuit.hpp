// SPDX-License-Identifier: MIT
// Circuit: a TransitionSystem bit by bit: latches that start false and take the value of a function in every step, inputs
// that have any value in every step, and what is asked of it. The one form for everything that speaks of bits: AIGER,
// programs that read it, the PDR engine.
//
// Coding: a Boolean is one bit; an integer is itself in binary, or in two's complement where its range holds negative
// numbers, or counted from its least value where that takes fewer bits. A bit that starts true is kept inverted in its latch;
// one whose first value is no constant is chosen between that value and its latch by the latch `started`.
//
// Invariants, constraints on steps and the ranges of what is free are folded into the latch `broken`: from the step on
// that breaks one, it is true, and so what is asked is asked of states where it is false and that keep the invariants.
// What the bits do after that means nothing.
//
// Invariants (see verify): gates come after what they read; words, latches and targets name nodes that are there; the
// inputs and the nodes of latches are sources, each once, and there are no others.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "circuit/gates.hpp"
#include "ir/flat_system.hpp"

namespace grafverif {

struct Circuit {
    using Literal = Gates::Literal;

    struct Input {
        std::uint32_t node = 0;
        std::string name = {};  ///< `START`, `n[2]`; of a first value that is free: `n[2] at first`
        bool operator==(const Input&) const = default;
    };
    struct Latch {
        std::uint32_t node = 0;
        Literal next = Gates::no;
        std::string name = {};  ///< `n[2]`; of one that holds the complement: `!n[2]`
        bool operator==(const Latch&) const = default;
    };
    /// A value as literals, the least significant bit first: base plus their number, the last one counting negatively
    /// where it is a sign.
    struct Word {
        Type type = {};
        std::int64_t base = 0;
        bool with_sign = false;
        std::vector<Literal> bits = {};
        bool operator==(const Word&) const = default;
    };
    /// One thing asked. Of a property about states: whether a state with `bad` is reached, which violates it, or shows what
    /// `reachable` asks for. Of one about runs: whether some run meets each of `justice` infinitely often, which violates
    /// it; `bad` is `no` then.
    struct Target {
        Id<Property> about = {};
        Literal bad = Gates::no;
        std::vector<Literal> justice = {};
        /// States where what it says has no value: one that is reached makes the property mean nothing.
        Literal undefined = Gates::no;
        bool operator==(const Target&) const = default;
    };
    /// A step that gives a variable a value outside its range, or none: if such a state is reached, nothing means anything.
    struct Leak {
        Id<FlatSystem::Variable> variable = {};
        Literal bad = Gates::no;
        bool operator==(const Leak&) const = default;
    };

    Gates gates = {};
    std::vector<Input> inputs = {};
    std::vector<Latch> latches = {};
    std::vector<Word> words = {};    ///< per variable of the flat system: its value in the state, or the step, at hand
    std::vector<Word> symbols = {};  ///< per symbol of the system's main: likewise
    Literal possible = Gates::yes;   ///< the state at hand is one of the system, as far as its invariants say
    Literal settled = Gates::no;     ///< ... and is settled, where that is a word of the system
    Literal in_range = Gates::yes;   ///< every variable has a value of its type
    std::vector<Target> targets = {};
    std::vector<Leak> leaks = {};

    bool operator==(const Circuit&) const = default;
};

/// A property that no target asks, and why.
struct NotInCircuit {
    Id<Property> about = {};
    std::string reason = {};
};

struct CircuitOf {
    Circuit circuit = {};
    std::vector<NotInCircuit> omitted = {};
};
/// `flat`: flattened(system), which gains terms. Requires verify(system).empty().
CircuitOf circuit_of(const TransitionSystem& system, FlatSystem& flat);

std::vector<std::string> verify(const Circuit& circuit);

/// One bit per node of a circuit.
using NodeValues = std::vector<bool>;
/// Every node from its latches and inputs, which `values` holds already.
void evaluate_gates(const Circuit& circuit, NodeValues& values);
inline bool value_of(const NodeValues& values, Gates::Literal literal) {
    return values[node_of(literal)] != is_inverted(literal);
}
std::int64_t value_of(const NodeValues& values, const Circuit::Word& word);

/// Looks at each state of a run, given by the values of the inputs in each, those that are missing being false.
void run_through(const Circuit& circuit, const std::vector<std::vector<bool>>& inputs,
                 const std::function<void(const NodeValues&)>& look);

/// The states of a run, from the values of the inputs in each: a value for each variable of the flat system.
std::vector<std::vector<std::int64_t>> states_of(const Circuit& circuit, const std::vector<std::vector<bool>>& inputs);

}  // namespace grafverif
