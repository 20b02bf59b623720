// SPDX-License-Identifier: MIT
// TransitionSystem: a finite-state model of controllers, with or without their plant, untimed or with discrete time. It
// has finite variables, definitions, initial and next values, invariants and justice conditions, in modules that are
// instantiated once or several times.
//
// Expressions are stored in `exprs`. Within a module, Variable leaves index the module's `symbols`: its parameters,
// variables and definitions. `main` is the module of the system; only `main` contains instances of other modules.
//
// A variable without `next` is free: it has any value of its type in each step. A variable without `initial` starts
// with any value. `next` reads only current values and choices. A choice, such as the process that moves, has any value
// in each step and does not belong to the state. A step consists of current values, choices that satisfy all
// `transitions`, and the resulting next values; states that violate an invariant do not exist. The system is total:
// every reachable state has a successor.
//
// Invariants (see verify): ids are in their tables; definitions do not depend on themselves; a symbol of main that
// refers to a symbol of an instance refers to an existing symbol; types agree; initial values, invariants, justice
// conditions and properties do not read choices.
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
        /// Conditions that every step satisfies; they restrict the choices in a state.
        std::vector<Id<Expr>> transitions = {};
        std::vector<Id<Expr>> justice = {};  ///< justice conditions, each of which holds infinitely often
        bool operator==(const Module&) const = default;
    };

    struct Instance {
        std::string name = {};
        Id<Module> module = {};
        std::vector<Id<Symbol>> arguments = {};  ///< arguments, which are symbols of main
        bool operator==(const Instance&) const = default;
    };

    /// A property that this system cannot express, with the reason.
    struct Omitted {
        Property property = {};  ///< the property, without operands
        std::string reason = {};
        std::size_t before = 0;  ///< position of the property: before the property of the system with this index
        bool operator==(const Omitted&) const = default;
    };

    // The following structs map the symbols of main to charts and plant, for traces and their replay.

    using Named = ControllerWords<Symbol>::Named;
    /// Each condition is evaluated in a state, with the choices of the step from this state. An invalid id has the
    /// meaning that the comment of the condition states.
    struct Controller {
        /// If `evolves` is true in a step, the step clears the transitions whose conditions held before the step.
        ControllerWords<Symbol> words = {};
        Id<Expr> starts = {};   ///< true in the first evolution; invalid if the first evolution has no visible effect
        Id<Expr> samples = {};  ///< true if inputs and timer outputs are sampled; invalid if equal to `evolves`
        Id<Expr> evolves = {};  ///< true if the step is one evolution; invalid if all steps are evolutions
        Id<Expr> scans = {};    ///< true if a scan of the task cycle begins; invalid without a task cycle
        Id<Expr> writes = {};   ///< true if outputs are written; invalid if evolutions write them as the mode requires
        bool operator==(const Controller&) const = default;
    };
    /// A component that moves in addition to the controllers: an instance of the loop or a timer.
    struct Component {
        enum class Kind { Plant, Environment, Timer };
        std::string name = {};
        Kind kind = Kind::Plant;
        /// Symbol of the location, with named values; invalid if there is only one location.
        Id<Symbol> location = {};
        std::vector<Named> variables = {};  ///< its variables that controllers neither read nor write
        std::vector<Named> inputs = {};     ///< inputs of controllers that this component writes
        bool operator==(const Component&) const = default;
    };

    /// A subsystem: a set of instances of an interleaved system. These instances share nothing with the other instances
    /// except time and the choice of the moving instance.
    struct Subsystem {
        std::string name = {};  ///< displayed name
        std::vector<Id<Instance>> instances = {};
        /// Symbols of main that belong to this subsystem, with the constants that replace them if the subsystem is
        /// omitted.
        std::vector<std::pair<Id<Symbol>, Id<Expr>>> without = {};
        Id<Expr> moves = {};  ///< condition of a step: an instance of this subsystem moves
        /// Conjunct of `settled` that concerns this subsystem; invalid if `settled` cannot be decomposed.
        Id<Expr> settled = {};
        bool operator==(const Subsystem&) const = default;
    };
    /// Independent subsystems, of which at most one moves in a step. All terms are over symbols of main.
    struct Subsystems {
        std::vector<Subsystem> each = {};  ///< the subsystems; empty if the system cannot be decomposed
        Id<Expr> waits = {};  ///< condition of a step: no subsystem moves; if clocks are counted, time passes
        Id<Expr> can_move = {}, can_wait = {};  ///< only if clocks are counted: some instance can move; time can pass
        bool operator==(const Subsystems&) const = default;
    };

    std::string name = {};
    std::vector<NamedConstant> constants = {};  ///< constants of the loop, for file headers
    std::string scope = {};  ///< consequence of verdicts for the timed plant, as one paragraph for file headers
    Exprs exprs = {};
    Table<Module> modules = {};
    Id<Module> main = {};
    Table<Instance> instances = {};            ///< instances in main
    std::vector<Id<Instance>> observers = {};  ///< observers, which monitor the steps of this system
    Table<Property> properties = {};           ///< properties over symbols of main
    /// Condition for a quiescent state, over symbols of main: the meaning of `at stable`. Every controller is stable
    /// and its outputs are up to date, so that one more cycle with the same inputs would change nothing.
    Id<Expr> settled = {};
    std::vector<Omitted> omitted = {};
    std::vector<Controller> controllers = {};
    std::vector<Component> components = {};
    Subsystems parts = {};
    /// Condition over symbols of main: time passes by `tick_ms`; invalid if the system is untimed.
    Id<Expr> ticks = {};
    std::int64_t tick_ms = 0;

    bool operator==(const TransitionSystem&) const = default;
};

std::vector<std::string> verify(const TransitionSystem& system);

}  // namespace grafverif
