// SPDX-License-Identifier: MIT
// TransitionSystem: finite variables, definitions, initial and next values, invariants and justice conditions, in
// modules that are instantiated once or more: the untimed model of a controller, with or without its plant.
//
// Expressions are stored in `exprs`. Within a module, Variable leaves index the module's `symbols`: its parameters,
// variables and definitions. `main` is the module of the system; modules do not nest deeper than main -> instance.
//
// A variable without `next` is free: it has any value of its type in each step. A variable without `initial` starts
// with any value. `next` reads only current values and choices. A choice has any value in each step and does not belong
// to the state: the moving process, which of two edges. A step consists of current values, choices that satisfy all
// `transitions`, and the resulting next values; states that violate an invariant do not exist. The system is total:
// every reachable state has a successor.
//
// Invariants (see verify): ids in their tables; definitions do not depend on themselves; a symbol that refers to an
// instance's symbol names an existing one; types agree; initial values, invariants, justice and properties read no
// choice.
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
    /// Chosen freely in each step.
    struct ChoiceSymbol {
        bool operator==(const ChoiceSymbol&) const = default;
    };
    struct DefineSymbol {
        Id<Expr> value = {};
        bool operator==(const DefineSymbol&) const = default;
    };
    /// `instance.symbol` in main.
    struct MemberSymbol {
        Id<Instance> instance = {};
        Id<Symbol> symbol = {};
        bool operator==(const MemberSymbol&) const = default;
    };

    struct Symbol {
        std::string name = {};
        Type type = {};
        std::variant<ParameterSymbol, StateSymbol, ChoiceSymbol, DefineSymbol, MemberSymbol> kind = ParameterSymbol{};
        std::string comment = {};  ///< section of the symbol: `inputs`, `steps`, ...
        Span origin = {};
        /// The names of its values, from `type.low` to `type.high`, if they are not numbers: `still`, `going_out`.
        std::vector<std::string> values = {};
        bool operator==(const Symbol&) const = default;
    };

    struct Module {
        std::string name = {};
        Table<Symbol> symbols = {};  ///< parameters first, in order of the arguments
        std::vector<Id<Expr>> invariants = {};
        std::vector<Id<Expr>> transitions = {};  ///< hold in every step: restrict the choices in a state
        std::vector<Id<Expr>> justice = {};      ///< each holds infinitely often
        bool operator==(const Module&) const = default;
    };

    struct Instance {
        std::string name = {};
        Id<Module> module = {};
        std::vector<Id<Symbol>> arguments = {};  ///< symbols of main
        bool operator==(const Instance&) const = default;
    };

    /// A property that this system cannot express, with the reason.
    struct Omitted {
        Property property = {};  ///< without operands
        std::string reason = {};
        std::size_t before = 0;  ///< its position: before the property with this index
        bool operator==(const Omitted&) const = default;
    };

    // Mapping of the symbols of main to charts and plant: for traces, and for their replay.

    using Named = ControllerWords<Symbol>::Named;
    /// Each condition is evaluated in a state with the choices of the step that leaves it; if invalid: see each.
    struct Controller {
        ControllerWords<Symbol> words =
            {};                 ///< a transition is cleared by a step that `evolves` if its condition held before
        Id<Expr> starts = {};   ///< the first evolution; invalid: it has no visible effect
        Id<Expr> samples = {};  ///< inputs and timer outputs are sampled; invalid: whenever it evolves
        Id<Expr> evolves = {};  ///< one evolution; invalid: in every step
        Id<Expr> writes = {};   ///< outputs are written; invalid: whenever it evolves and its mode requires it
        bool operator==(const Controller&) const = default;
    };
    /// An element that moves in addition to the controllers: an instance of the loop, a timer.
    struct Component {
        enum class Kind { Plant, Environment, Timer };
        std::string name = {};
        Kind kind = Kind::Plant;
        Id<Symbol> location = {};           ///< its values are named; invalid if there is only one location
        std::vector<Named> variables = {};  ///< those of its variables that no controller reads or writes
        std::vector<Named> inputs = {};     ///< the inputs of controllers that it writes
        bool operator==(const Component&) const = default;
    };

    /// Some instances of an interleaved system: they share with the others only the choice of the moving one, and time.
    struct Subsystem {
        std::string name = {};  ///< displayed name
        std::vector<Id<Instance>> instances = {};
        /// Symbols of main that belong to this part, and the constants that replace them if it is omitted.
        std::vector<std::pair<Id<Symbol>, Id<Expr>>> without = {};
        Id<Expr> moves = {};    ///< in a step: one of its instances moves
        Id<Expr> settled = {};  ///< its part of `settled`; invalid if that cannot be decomposed
        bool operator==(const Subsystem&) const = default;
    };
    /// Parts, of which at most one moves in a step. All terms over main.
    struct Subsystems {
        std::vector<Subsystem> each = {};       ///< empty: the system cannot be decomposed
        Id<Expr> waits = {};                    ///< in a step: none moves; if clocks count, time passes
        Id<Expr> can_move = {}, can_wait = {};  ///< if clocks count: some instance can move; time can pass
        bool operator==(const Subsystems&) const = default;
    };

    std::string name = {};
    std::vector<NamedConstant> constants = {};  ///< of the loop, for headers
    std::string scope = {};  ///< consequence of verdicts for the timed plant; one paragraph for headers
    Exprs exprs = {};
    Table<Module> modules = {};
    Id<Module> main = {};
    Table<Instance> instances = {};            ///< in main
    std::vector<Id<Instance>> observers = {};  ///< observers: they monitor the steps of this system
    Table<Property> properties = {};           ///< over symbols of main
    /// Quiescent: every controller is stable and its outputs are up to date, so that one more cycle with the same
    /// inputs would change nothing. Over symbols of main; the meaning of `at stable`.
    Id<Expr> settled = {};
    std::vector<Omitted> omitted = {};
    std::vector<Controller> controllers = {};
    std::vector<Component> components = {};
    Subsystems parts = {};
    Id<Expr> ticks = {};  ///< over symbols of main: time passes by `tick_ms`; invalid if the system is untimed
    std::int64_t tick_ms = 0;

    bool operator==(const TransitionSystem&) const = default;
};

std::vector<std::string> verify(const TransitionSystem& system);

}  // namespace grafverif
