// SPDX-License-Identifier: MIT
// Circuit: bit-level form of a TransitionSystem and its properties. A latch is initially false, and its next value is a
// function of latches and inputs; an input has any value in each step. AIGER, the programs that read it, and the PDR
// engine use this form.
//
// Coding: a Boolean is one bit. An integer is coded as a binary number, or in two's complement if its range includes
// negative numbers. If fewer bits are sufficient for the offset from the minimum, the offset is coded instead. A bit
// that is initially true is stored inverted in its latch. If the initial value of a bit is not constant, the latch
// `started` selects between the initial value and the latch of the bit.
//
// The latch `broken` represents the invariants, the constraints on steps and the ranges of free variables. `broken`
// becomes true in the first step that violates one of these conditions, and remains true. Targets concern only states
// in which `broken` is false and the invariants hold. In all other states, the values of the bits do not represent a
// state of the system.
//
// Invariants of the circuit (see verify): operands precede their gates; words, latches and targets refer to existing
// nodes. Each source is the node of exactly one input or latch, and each input and latch has a source.
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
        std::string name = {};  ///< name such as `START` or `n[2]`; for a free first value: `n[2] at first`
        bool operator==(const Input&) const = default;
    };
    struct Latch {
        std::uint32_t node = 0;
        Literal next = Gates::no;
        std::string name = {};  ///< name such as `n[2]`; `!n[2]` if the bit is stored inverted
        bool operator==(const Latch&) const = default;
    };
    /// A variable or symbol: its value is `base` plus the number that the literals represent, least significant bit
    /// first. If `with_sign` is true, the last bit is a two's complement sign.
    struct Word {
        Type type = {};
        std::int64_t base = 0;
        bool with_sign = false;
        std::vector<Literal> bits = {};
        bool operator==(const Word&) const = default;
    };
    /// One property to decide. A state property is decided by the reachability of a state in which `bad` is true. A
    /// state in which `bad` is true violates the property or, for `reachable`, is the witness. A property of runs is
    /// violated if there is a run on which each literal of `justice` holds infinitely often; for such a property, `bad`
    /// is the constant `no`.
    struct Target {
        Id<Property> about = {};
        Literal bad = Gates::no;
        std::vector<Literal> justice = {};
        /// True in states in which a term of the property has no value. If such a state is reachable, the property is
        /// undefined.
        Literal undefined = Gates::no;
        bool operator==(const Target&) const = default;
    };
    /// A condition under which a step assigns a variable an undefined value or a value outside its range. If such a
    /// step is reachable, no verdict is valid.
    struct Leak {
        Id<FlatSystem::Variable> variable = {};
        Literal bad = Gates::no;
        bool operator==(const Leak&) const = default;
    };

    Gates gates = {};
    std::vector<Input> inputs = {};
    std::vector<Latch> latches = {};
    std::vector<Word> words = {};    ///< value of each variable of the flat system in the current state or step
    std::vector<Word> symbols = {};  ///< value of each symbol of the system's main module
    Literal broken = Gates::no;      ///< the latch `broken`; the constant `no` if the circuit has no such latch
    Literal possible = Gates::yes;   ///< true if the current state satisfies the system's invariants

    /// True if the current state is possible and quiescent. Valid only if the system has the term `settled`.
    Literal settled = Gates::no;
    Literal in_range = Gates::yes;  ///< true if every variable has a value of its type
    std::vector<Target> targets = {};
    std::vector<Leak> leaks = {};

    bool operator==(const Circuit&) const = default;
};

/// A property that the circuit cannot express, with the reason.
struct NotInCircuit {
    Id<Property> about = {};
    std::string reason = {};
};

struct CircuitOf {
    Circuit circuit = {};
    std::vector<NotInCircuit> omitted = {};
};
/// Translates the system. `flat` must be flattened(system); the function adds terms to it. Requires
/// verify(system).empty().
CircuitOf circuit_of(const TransitionSystem& system, FlatSystem& flat);

std::vector<std::string> verify(const Circuit& circuit);

/// The value of each node of a circuit.
using NodeValues = std::vector<bool>;
/// Computes all gates from the latches and inputs, which `values` already contains.
void evaluate_gates(const Circuit& circuit, NodeValues& values);
inline bool value_of(const NodeValues& values, Gates::Literal literal) {
    return values[node_of(literal)] != is_inverted(literal);
}
std::int64_t value_of(const NodeValues& values, const Circuit::Word& word);

/// Calls `look` for each state of the run with the given input values of each step; missing input values are false.
void run_through(const Circuit& circuit, const std::vector<std::vector<bool>>& inputs,
                 const std::function<void(const NodeValues&)>& look);

/// Returns the states of the run with the given input values of each step. A state has one value for each variable of
/// the flat system.
std::vector<std::vector<std::int64_t>> states_of(const Circuit& circuit, const std::vector<std::vector<bool>>& inputs);

}  // namespace grafverif
