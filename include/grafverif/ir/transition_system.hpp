// SPDX-License-Identifier: MIT
// TransitionSystem: a finite-state model of controllers, with or without their plant, untimed or with discrete time.
// The model consists of modules that are instantiated once or several times. A module contains variables with finite
// ranges, definitions, initial and next values, invariants, and justice conditions.
//
// Expressions are stored in `exprs`. In a term of a module, Variable leaves are indices in the `symbols` of the module:
// its parameters, variables, choices and definitions. `main` is the module of the system; only `main` contains
// instances of other modules.
//
// A variable without `next` is free: in each state, it has any value of its type. A variable without `initial` starts
// with any value. `next` reads only current values and choices. A choice, such as the process that moves, is a symbol
// that has any value of its type in each step and does not belong to the state. A step consists of current values,
// choices that satisfy all `transitions`, and the resulting next values. Only assignments that satisfy all invariants
// are states. The system is total: every reachable state has a successor.
//
// Invariants (see verify): ids are in their tables; definitions do not depend on themselves; the instance and the
// symbol of each MemberSymbol exist; types agree; initial values, invariants, justice conditions and properties do not
// read choices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "grafverif/ir/controller_words.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/named_constant.hpp"
#include "grafverif/ir/property.hpp"
#include "grafverif/ir/type.hpp"
#include "grafverif/support/source.hpp"
#include "grafverif/support/table.hpp"

namespace grafverif {

struct TransitionSystem {
    struct Module;
    struct Instance;
    struct Symbol;

    struct ParameterSymbol {
        bool operator==(const ParameterSymbol&) const = default;
    };
    struct StateSymbol {
        std::optional<Id<Expr>> initial = {};
        std::optional<Id<Expr>> next = {};
        bool operator==(const StateSymbol&) const = default;
    };
    /// A symbol whose value is chosen freely in each step.
    struct ChoiceSymbol {
        bool operator==(const ChoiceSymbol&) const = default;
    };
    struct DefineSymbol {
        Id<Expr> value = {};
        bool operator==(const DefineSymbol&) const = default;
    };
    /// The symbol `instance.symbol` in main.
    struct MemberSymbol {
        Id<Instance> instance = {};
        Id<Symbol> symbol = {};
        bool operator==(const MemberSymbol&) const = default;
    };

    struct Symbol {
        std::string name = {};
        Type type = {};
        std::variant<ParameterSymbol, StateSymbol, ChoiceSymbol, DefineSymbol, MemberSymbol> kind = ParameterSymbol{};
        std::string comment = {};  ///< section that contains the symbol: `inputs`, `steps`, ...
        Span origin = {};
        /// Names of the values from `type.low` to `type.high`, such as `still`; empty if the values are numbers.
        std::vector<std::string> values = {};
        bool operator==(const Symbol&) const = default;
    };

    struct Module {
        std::string name = {};
        Table<Symbol> symbols = {};  ///< parameters come first, in the order of the arguments
        std::vector<Id<Expr>> invariants = {};
        /// Conditions that every step satisfies; they restrict the values of the choices of a step.
        std::vector<Id<Expr>> transitions = {};
        /// Justice conditions: only runs in which each of them holds infinitely often are considered.
        std::vector<Id<Expr>> justice = {};
        bool operator==(const Module&) const = default;
    };

    struct Instance {
        std::string name = {};
        Id<Module> module = {};
        std::vector<Id<Symbol>> arguments = {};  ///< arguments for the parameters of the module: symbols of main
        bool operator==(const Instance&) const = default;
    };

    /// A property of the closed loop that the transition system cannot express, with the reason.
    struct Omitted {
        Property property = {};  ///< the omitted property, without operands
        std::string reason = {};
        std::size_t before = 0;  ///< position of the omitted property: index of the next property in `properties`
        bool operator==(const Omitted&) const = default;
    };

    // The following structs map the symbols of main to charts and plant, for traces and their replay.

    using Named = ControllerWords<Symbol>::Named;
    /// Each condition is evaluated in a state, with the choices of the step from this state. The comment of each
    /// condition states the meaning of an invalid id.
    struct Controller {
        /// Names and symbols of the chart. If `evolves` is true in a step, the step clears the transitions whose firing
        /// conditions held before the step.
        ControllerWords<Symbol> words = {};
        Id<Expr> starts = {};   ///< true in the first evolution; invalid if the first evolution has no visible effect
        Id<Expr> samples = {};  ///< true if inputs and timer outputs are sampled; invalid if equal to `evolves`
        Id<Expr> evolves = {};  ///< true if the step is one evolution; invalid if all steps are evolutions
        Id<Expr> scans = {};    ///< true if a scan of the task cycle begins; invalid without a task cycle

        /// True if outputs are written; invalid if writing is part of the step that executes an evolution. Under
        /// stability search, this step writes the outputs only if the situation after the evolution is stable.
        Id<Expr> writes = {};
        bool operator==(const Controller&) const = default;
    };
    /// A component that moves in addition to the controllers: an instance of the loop or a timer.
    struct Component {
        enum class Kind { Plant, Environment, Timer };
        std::string name = {};
        Kind kind = Kind::Plant;
        /// Symbol of the location, with named values; invalid if there is only one location.
        Id<Symbol> location = {};
        std::vector<Named> variables = {};  ///< variables of this component that controllers neither read nor write
        std::vector<Named> inputs = {};     ///< inputs of controllers that this component writes
        bool operator==(const Component&) const = default;
    };

    /// A subsystem: a set of instances of an interleaved system that share no variables with
    /// instances of other subsystems. All subsystems share only time and the choice of the moving
    /// instance.
    struct Subsystem {
        std::string name = {};  ///< displayed name of the subsystem
        std::vector<Id<Instance>> instances = {};
        /// Symbols of main that belong to this subsystem. Each symbol is paired with the constant that replaces it if
        /// the subsystem is omitted.
        std::vector<std::pair<Id<Symbol>, Id<Expr>>> without = {};
        Id<Expr> moves = {};  ///< true in a step in which an instance of this subsystem moves

        /// Conjunct of `settled` that concerns this subsystem; invalid if `settled` cannot be decomposed.
        Id<Expr> settled = {};
        bool operator==(const Subsystem&) const = default;
    };
    /// Independent subsystems, of which at most one moves in a step. All terms are over symbols of main.
    struct Subsystems {
        std::vector<Subsystem> each = {};  ///< the subsystems; empty if the system cannot be decomposed

        /// True in a step in which no subsystem moves; with discrete time, time passes in this step.
        Id<Expr> waits = {};
        /// True if some instance can move (`can_move`) or if time can pass (`can_wait`); valid only
        /// with discrete time.
        Id<Expr> can_move = {}, can_wait = {};
        bool operator==(const Subsystems&) const = default;
    };

    std::string name = {};
    /// Named constants of the loop, which the headers of generated files list.
    std::vector<NamedConstant> constants = {};
    std::string scope = {};  ///< what the verdicts imply for the timed plant, as one paragraph for file headers
    Exprs exprs = {};
    Table<Module> modules = {};
    Id<Module> main = {};
    Table<Instance> instances = {};            ///< module instances in main
    std::vector<Id<Instance>> observers = {};  ///< observers, which monitor the steps of this system
    Table<Property> properties = {};           ///< properties over symbols of main

    /// Condition for a quiescent state, over symbols of main: the meaning of `at stable`. Every controller is stable
    /// and its outputs are up to date, so that one more cycle with the same inputs would change only previous values.
    Id<Expr> settled = {};
    std::vector<Omitted> omitted = {};
    std::vector<Controller> controllers = {};
    std::vector<Component> components = {};
    Subsystems parts = {};
    /// Term over symbols of main: true in a step in which `tick_ms` milliseconds pass; invalid if the system is
    /// untimed.
    Id<Expr> ticks = {};
    std::int64_t tick_ms = 0;

    bool operator==(const TransitionSystem&) const = default;
};

std::vector<std::string> verify(const TransitionSystem& system);

}  // namespace grafverif
