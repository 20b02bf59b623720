// SPDX-License-Identifier: MIT
// TransitionSystem: finite variables, definitions, initial and next values, invariants and justice conditions, in
// modules that are instantiated once or more: the untimed view of a controller, with or without its plant.
//
// Expressions live in `exprs`. Within a module, Variable leaves index the module's own `symbols`: its parameters,
// variables and definitions. `main` is the module that is the system; modules do not nest deeper than main -> instance.
//
// A variable without `next` is free: it takes any value of its type in each step. A variable without `initial` starts
// with any value. `next` reads current values and choices only. A choice takes any value anew in each step and is no
// part of the state: who moves, which of two edges. A step is made of current values, choices that satisfy all
// `transitions`, and the next values they give; states that violate an invariant do not exist. The system is total:
// every reachable state has a step.
//
// Invariants (see verify): ids in their tables; definitions do not depend on themselves; a symbol that refers to an
// instance's symbol names one that exists; types agree; initial values, invariants, justice and properties read no
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
    /// Chosen anew in each step.
    struct ChoiceSymbol {
        bool operator==(const ChoiceSymbol&) const = default;
    };
    struct DefineSymbol {
        Id<Expr> value = {};
        bool operator==(const DefineSymbol&) const = default;
    };
    /// `instance.symbol`, as main sees it.
    struct MemberSymbol {
        Id<Instance> instance = {};
        Id<Symbol> symbol = {};
        bool operator==(const MemberSymbol&) const = default;
    };

    struct Symbol {
        std::string name = {};
        Type type = {};
        std::variant<ParameterSymbol, StateSymbol, ChoiceSymbol, DefineSymbol, MemberSymbol> kind = ParameterSymbol{};
        std::string comment = {};  ///< the section it is listed under: `inputs`, `steps`, ...
        Span origin = {};
        /// The names of its values, from `type.low` to `type.high`, where they are no numbers: `still`, `going_out`.
        std::vector<std::string> values = {};
        bool operator==(const Symbol&) const = default;
    };

    struct Module {
        std::string name = {};
        Table<Symbol> symbols = {};  ///< parameters first, in order of the arguments
        std::vector<Id<Expr>> invariants = {};
        std::vector<Id<Expr>> transitions = {};  ///< hold in every step: which choices a state offers
        std::vector<Id<Expr>> justice = {};      ///< each holds infinitely often
        bool operator==(const Module&) const = default;
    };

    struct Instance {
        std::string name = {};
        Id<Module> module = {};
        std::vector<Id<Symbol>> arguments = {};  ///< symbols of main
        bool operator==(const Instance&) const = default;
    };

    /// A property that cannot be said of this system, and why.
    struct Omitted {
        Property property = {};  ///< without operands
        std::string reason = {};
        std::size_t before = 0;  ///< its place: before the property of this index
        bool operator==(const Omitted&) const = default;
    };

    // What the symbols of main are to the charts and the plant: for traces, and for their replay on the rules.

    using Named = ControllerWords<Symbol>::Named;
    /// Of each condition below: it holds in a state and the choices with which a step leaves it. Not valid: as said.
    struct Controller {
        ControllerWords<Symbol> words =
            {};                 ///< a transition is cleared by a step that `evolves` leaves a state where it holds
        Id<Expr> starts = {};   ///< the first evolution; none: it shows in nothing
        Id<Expr> samples = {};  ///< inputs and timer ends are read; none: where it evolves
        Id<Expr> evolves = {};  ///< one evolution; none: in every step
        Id<Expr> writes = {};   ///< outputs are written; none: where it evolves and its mode asks for it
        bool operator==(const Controller&) const = default;
    };
    /// What moves beside the controllers: an instance of the loop, a timer.
    struct Component {
        enum class Kind { Plant, Environment, Timer };
        std::string name = {};
        Kind kind = Kind::Plant;
        Id<Symbol> location = {};           ///< its values are named; not valid: it has one location only
        std::vector<Named> variables = {};  ///< those of its variables that no controller reads or writes
        std::vector<Named> inputs = {};     ///< the inputs of controllers that it writes
        bool operator==(const Component&) const = default;
    };

    /// Some instances, where in each step one instance moves or none: they share with all others nothing but whose turn it
    /// is, and time.
    struct Part {
        std::string name = {};  ///< what users call it
        std::vector<Id<Instance>> instances = {};
        /// Symbols of main that are of this part, and the constants that stand for them where it is left out.
        std::vector<std::pair<Id<Symbol>, Id<Expr>>> without = {};
        Id<Expr> moves = {};    ///< in a step: one of its instances moves
        Id<Expr> settled = {};  ///< its share of `settled`; not valid: that does not come apart
        bool operator==(const Part&) const = default;
    };
    /// Parts, one of which moves in a step, or none. All terms over main.
    struct Parts {
        std::vector<Part> each = {};            ///< none: the system does not come apart
        Id<Expr> waits = {};                    ///< in a step: none moves; where clocks count, time passes
        Id<Expr> can_move = {}, can_wait = {};  ///< where clocks count: some instance can move; time can pass
        bool operator==(const Parts&) const = default;
    };

    std::string name = {};
    std::vector<NamedConstant> constants = {};  ///< of the loop, for headers
    std::string scope = {};  ///< what verdicts about this system say of the timed plant; one paragraph for headers
    Exprs exprs = {};
    Table<Module> modules = {};
    Id<Module> main = {};
    Table<Instance> instances = {};            ///< in main
    std::vector<Id<Instance>> observers = {};  ///< those that watch: what they see are the steps of this very system
    Table<Property> properties = {};           ///< over symbols of main
    /// Settled: every controller stable and its outputs up to date, so that one more cycle with the same inputs would
    /// change nothing. Over symbols of main; what `at stable` means here.
    Id<Expr> settled = {};
    std::vector<Omitted> omitted = {};
    std::vector<Controller> controllers = {};
    std::vector<Component> components = {};
    Parts parts = {};
    Id<Expr> ticks = {};  ///< likewise: time passes by `tick_ms`; not valid: the system knows no time
    std::int64_t tick_ms = 0;

    bool operator==(const TransitionSystem&) const = default;
};

std::vector<std::string> verify(const TransitionSystem& system);

}  // namespace grafverif
