// SPDX-License-Identifier: MIT
// FlatSystem: a TransitionSystem without modules: its state variables and choices in one table, definitions and
// parameters put in their places. What engines search, and what gives meaning to the numbers that a model checker prints.
//
// Variable leaves of `exprs` index `variables`. Shared terms stay shared: a term is a graph, and walking it as a tree
// may take exponential time; see `values` and BddTerms.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/transition_system.hpp"

namespace grafverif {

struct FlatSystem {
    struct Variable {
        std::string name = {};  ///< `START`, of an instance `station.X_2`
        Type type = {};
        bool choice = false;  ///< chosen anew in each step, no part of the state
        std::optional<Id<Expr>> initial = {};
        std::optional<Id<Expr>> next = {};
        Span origin = {};
        bool operator==(const Variable&) const = default;
    };

    Exprs exprs = {};
    Table<Variable> variables = {};
    std::vector<Id<Expr>> symbols = {};  ///< per symbol of the system's main: its value
    std::vector<Id<Expr>> invariants = {}, transitions = {}, justice = {};

    bool operator==(const FlatSystem&) const = default;
};

/// Requires verify(system).empty().
FlatSystem flattened(const TransitionSystem& system);

/// `term`, over the symbols of the system's main, as a term over the variables of `flat`, in flat.exprs.
Id<Expr> flattened(const TransitionSystem& system, FlatSystem& flat, Id<Expr> term);

/// How a program that reads a model of the system spells what is in its tables.
struct SystemSpelling {
    std::vector<std::string> variables = {};  ///< of flattened(system).variables
    std::vector<std::vector<std::string>> values =
        {};                                    ///< per variable, the names of its values from type.low; none: numbers
    std::vector<std::string> properties = {};  ///< of system.properties

    bool operator==(const SystemSpelling&) const = default;
};

/// A run of a TransitionSystem. States hold the value of each symbol of main; where that depends on choices, with those
/// of the step that leaves the state. A symbol without a value there (a definition that divides by zero) is 0.
struct SystemRun {
    std::vector<std::vector<std::int64_t>> states = {};  ///< the first is an initial state
    std::optional<std::size_t> loop = {};                ///< a last step leads back to this state, and so on for ever

    bool operator==(const SystemRun&) const = default;
};

/// Why a system means nothing: no verdict about it would be worth anything.
struct SystemFault {
    enum class Kind {
        NoInitialState,  ///< the invariants and initial values contradict each other
        DeadEnd,         ///< a reachable state has no step
        OutOfRange,      ///< a step gives `variable` a value outside its range, or none
    };
    Kind kind = Kind::NoInitialState;
    std::string variable = {};
    SystemRun run = {};  ///< to the state where it shows

    bool operator==(const SystemFault&) const = default;
};

/// `no-initial-state`, `dead-end`, `out-of-range`.
std::string_view word(SystemFault::Kind kind);

/// The same with one value for each of `variables`.
struct FlatRun {
    std::vector<std::vector<std::int64_t>> states = {};
    std::optional<std::size_t> loop = {};

    bool operator==(const FlatRun&) const = default;
};
/// As a run of the system that `flat` was made of.
SystemRun system_run(const FlatSystem& flat, const FlatRun& run);

/// The values of all symbols of main, as a state of a SystemRun. `variables`: one value for each of flat.variables.
std::vector<std::int64_t> symbol_values(const FlatSystem& flat, std::span<const std::int64_t> variables);

/// The value of a term over symbols of main, in a state of a run; 0 where it has none.
std::int64_t value_in(const TransitionSystem& system, const std::vector<std::int64_t>& state, Id<Expr> term);

}  // namespace grafverif
