// SPDX-License-Identifier: MIT
// FlatSystem: a TransitionSystem without modules. The state variables and choices of all modules are in one table, and
// definitions and parameters are replaced by their terms. The untimed engines use a FlatSystem. The values that an
// external model checker prints are converted to values of the variables of a FlatSystem.
//
// Variable leaves of `exprs` index `variables`. Terms share subterms; therefore, a traversal that visits a shared
// subterm more than once may take exponential time (see evaluate_all and BddTerms).
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
        std::string name = {};  ///< name such as `START`; for a variable of an instance, such as `station.X_2`
        Type type = {};
        bool choice = false;  ///< true if the value is chosen freely in each step and is not part of the state
        std::optional<Id<Expr>> initial = {};
        std::optional<Id<Expr>> next = {};
        Span origin = {};
        bool operator==(const Variable&) const = default;
    };

    Exprs exprs = {};
    Table<Variable> variables = {};
    /// For each symbol of the system's main module: its value as a term over `variables`.
    std::vector<Id<Expr>> symbols = {};
    std::vector<Id<Expr>> invariants = {}, transitions = {}, justice = {};

    bool operator==(const FlatSystem&) const = default;
};

/// Converts a system to a FlatSystem. Requires verify(system).empty().
FlatSystem flattened(const TransitionSystem& system);

/// Translates `term`, over the symbols of the system's main module, to a term over the variables of `flat`, stored in
/// flat.exprs.
Id<Expr> flattened(const TransitionSystem& system, FlatSystem& flat, Id<Expr> term);

/// Names that an external program uses when it prints a run of a generated model.
struct SystemSpelling {
    std::vector<std::string> variables = {};  ///< name of each element of flattened(system).variables
    std::vector<std::vector<std::string>> values =
        {};  ///< for each variable: names of its values, beginning with type.low; empty if the values are numbers
    std::vector<std::string> properties = {};  ///< name of each element of system.properties

    bool operator==(const SystemSpelling&) const = default;
};

/// A run of a TransitionSystem. A state contains the value of each symbol of main. If the value of a symbol depends on
/// choices, the state contains the value for the choices of the step that leaves the state. If the value of a symbol is
/// undefined (division by zero), the state contains 0.
struct SystemRun {
    std::vector<std::vector<std::int64_t>> states = {};  ///< states of the run, beginning with an initial state
    std::optional<std::size_t> loop = {};                ///< index of the state to which the step after the last state
                                                         ///< leads back; empty for a finite run

    bool operator==(const SystemRun&) const = default;
};

/// A fault of a TransitionSystem. No verdict on a system with a fault is valid.
struct SystemFault {
    enum class Kind {
        NoInitialState,  ///< the invariants and the initial values are contradictory
        DeadEnd,         ///< a reachable state has no successor
        OutOfRange,      ///< the next value of `variable` is undefined or outside its range in some step
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

/// Returns the value of a term over symbols of main in a state of a run; 0 if the value is undefined.
std::int64_t value_in(const TransitionSystem& system, const std::vector<std::int64_t>& state, Id<Expr> term);

}  // namespace grafverif
