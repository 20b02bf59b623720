// SPDX-License-Identifier: MIT
// FlatSystem: a TransitionSystem without modules. Its state variables and choices are in one table, and definitions and
// parameters are substituted. It is the input of the engines, and defines the meaning of the values that a model
// checker prints.
//
// Variable leaves of `exprs` index `variables`. Shared terms stay shared: a term is a graph, and traversing it as a
// tree may take exponential time; see `values` and BddTerms.
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
        std::string name = {};  ///< `START`; for an instance `station.X_2`
        Type type = {};
        bool choice = false;  ///< chosen freely in each step, not part of the state
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

/// Translates `term`, over the symbols of the system's main, to a term over the variables of `flat`, in flat.exprs.
Id<Expr> flattened(const TransitionSystem& system, FlatSystem& flat, Id<Expr> term);

/// Names in a generated model, as the external program that reads it prints them.
struct SystemSpelling {
    std::vector<std::string> variables = {};  ///< per flattened(system).variables
    std::vector<std::vector<std::string>> values =
        {};                                    ///< per variable: names of its values, starting with type.low; empty for
                                               ///< numbers
    std::vector<std::string> properties = {};  ///< per system.properties

    bool operator==(const SystemSpelling&) const = default;
};

/// A run of a TransitionSystem. A state contains the value of each symbol of main; if it depends on choices, with those
/// of the step that leaves the state. The value of an undefined symbol (a definition that divides by zero) is 0.
struct SystemRun {
    std::vector<std::vector<std::int64_t>> states = {};  ///< the first is an initial state
    std::optional<std::size_t> loop = {};                ///< the step after the last state leads back to this state,
                                                         ///< forming an infinite run

    bool operator==(const SystemRun&) const = default;
};

/// Reason why a system is ill-defined and no verdict about it is valid.
struct SystemFault {
    enum class Kind {
        NoInitialState,  ///< the invariants and initial values are contradictory
        DeadEnd,         ///< a reachable state has no successor
        OutOfRange,      ///< a step gives `variable` no value or one outside its range
    };
    Kind kind = Kind::NoInitialState;
    std::string variable = {};
    SystemRun run = {};  ///< to the state that shows the fault

    bool operator==(const SystemFault&) const = default;
};

/// `no-initial-state`, `dead-end`, `out-of-range`.
std::string_view word(SystemFault::Kind kind);

/// A run with one value for each of `variables` in every state.
struct FlatRun {
    std::vector<std::vector<std::int64_t>> states = {};
    std::optional<std::size_t> loop = {};

    bool operator==(const FlatRun&) const = default;
};
/// Converts to a run of the system from which `flat` was built.
SystemRun system_run(const FlatSystem& flat, const FlatRun& run);

/// Values of all symbols of main, as in a state of a SystemRun. `variables`: one value for each of flat.variables.
std::vector<std::int64_t> symbol_values(const FlatSystem& flat, std::span<const std::int64_t> variables);

/// Value of a term over symbols of main in a state of a run; 0 if undefined.
std::int64_t value_in(const TransitionSystem& system, const std::vector<std::int64_t>& state, Id<Expr> term);

}  // namespace grafverif
