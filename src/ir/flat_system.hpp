// SPDX-License-Identifier: MIT
// FlatSystem: a TransitionSystem without modules. Its state variables and choices are in one table, and definitions and
// parameters are substituted. The engines use this form. The values that an external model checker prints are converted
// to values of the variables of this form.
//
// Variable leaves of `exprs` index `variables`. Shared terms remain shared: a term is a graph, and traversing it as a
// tree may take exponential time (see evaluate_all and BddTerms).
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
        std::string name = {};  ///< `START`; `station.X_2` for a variable of an instance
        Type type = {};
        bool choice = false;  ///< true if the value is chosen freely in each step and is not part of the state
        std::optional<Id<Expr>> initial = {};
        std::optional<Id<Expr>> next = {};
        Span origin = {};
        bool operator==(const Variable&) const = default;
    };

    Exprs exprs = {};
    Table<Variable> variables = {};
    std::vector<Id<Expr>> symbols = {};  ///< for each symbol of the system's main module: its value
    std::vector<Id<Expr>> invariants = {}, transitions = {}, justice = {};

    bool operator==(const FlatSystem&) const = default;
};

/// Flattens a system. Requires verify(system).empty().
FlatSystem flattened(const TransitionSystem& system);

/// Translates `term`, over the symbols of the system's main module, to a term over the variables of `flat`, stored in
/// flat.exprs.
Id<Expr> flattened(const TransitionSystem& system, FlatSystem& flat, Id<Expr> term);

/// Names in a generated model, as printed by the external program that reads it.
struct SystemSpelling {
    std::vector<std::string> variables = {};  ///< names of flattened(system).variables
    std::vector<std::vector<std::string>> values =
        {};  ///< for each variable: names of its values, starting with type.low; empty for numbers
    std::vector<std::string> properties = {};  ///< names of system.properties

    bool operator==(const SystemSpelling&) const = default;
};

/// A run of a TransitionSystem. A state contains the value of each symbol of main. If the value of a symbol depends on
/// choices, the state contains the value for the choices of the step that leaves the state. A symbol whose definition
/// is undefined has the value 0.
struct SystemRun {
    std::vector<std::vector<std::int64_t>> states = {};  ///< states of the run, beginning with an initial state
    std::optional<std::size_t> loop = {};                ///< index of the state to which the step after the last state
                                                         ///< leads back; empty for a finite run

    bool operator==(const SystemRun&) const = default;
};

/// Reason why a system is ill-defined and no verdict about it is valid.
struct SystemFault {
    enum class Kind {
        NoInitialState,  ///< the invariants and the initial values are contradictory
        DeadEnd,         ///< a reachable state has no successor
        OutOfRange,      ///< a step assigns `variable` no value or a value outside its range
    };
    Kind kind = Kind::NoInitialState;
    std::string variable = {};
    SystemRun run = {};  ///< run to the state in which the fault occurs

    bool operator==(const SystemFault&) const = default;
};

/// Returns `no-initial-state`, `dead-end` or `out-of-range`.
std::string_view word(SystemFault::Kind kind);

/// A run in which every state contains one value for each element of FlatSystem::variables.
struct FlatRun {
    std::vector<std::vector<std::int64_t>> states = {};
    std::optional<std::size_t> loop = {};

    bool operator==(const FlatRun&) const = default;
};
/// Converts `run` to a run of the system from which `flat` was built.
SystemRun system_run(const FlatSystem& flat, const FlatRun& run);

/// Returns the values of all symbols of main, as in a state of a SystemRun. `variables` contains one value for each
/// element of `flat.variables`.
std::vector<std::int64_t> symbol_values(const FlatSystem& flat, std::span<const std::int64_t> variables);

/// Returns the value of a term over symbols of main in a state of a run; 0 if undefined.
std::int64_t value_in(const TransitionSystem& system, const std::vector<std::int64_t>& state, Id<Expr> term);

}  // namespace grafverif
