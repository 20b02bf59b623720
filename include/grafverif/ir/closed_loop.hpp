// SPDX-License-Identifier: MIT
// ClosedLoop: controllers (charts) and the instances of the plant and its environment, wired by shared variables, and
// the properties to prove; names resolved, nothing composed yet. Model: all that one input file and its includes hold.
//
// Invariants (see verify): every id is in its table; every input of every controller and every input of every instance
// is driven by exactly one instance output or controller output; types agree at both ends.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/component.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/named_constant.hpp"
#include "grafverif/ir/property.hpp"

namespace grafverif {

struct ClosedLoop {
    struct Controller {
        std::string name = {};  ///< the chart's name
        Id<Chart> chart = {};   ///< in Model::charts
        ExecutionMode mode = ExecutionMode::StabilitySearch;
        Span origin = {};
        bool operator==(const Controller&) const = default;
    };

    /// A variable shared by instances and controllers: a controller's input or output, or one of the plant's own.
    struct Shared {
        std::string name = {};
        Type type = {};  ///< of a plant variable: the range its writer declares, arguments applied
        Id<Controller> reader =
            {};  ///< the first controller with this input (others have one of that name); else not valid
        Id<Controller> writer = {};         ///< the controller whose output it is; else not valid
        Id<Chart::Variable> variable = {};  ///< in the chart of the writer, else of the reader, where one is valid
        Span origin = {};
        bool operator==(const Shared&) const = default;
    };

    /// What a parameter of the component is bound to: a shared variable, a constant (Booleans 0 and 1, durations in ms),
    /// or, of an input, a term over shared variables in `exprs`: wherever the component reads the input, it reads the term.
    using Argument = std::variant<Id<Shared>, std::int64_t, Id<Expr>>;

    struct Instance {
        std::string name = {};
        Id<Component> component = {};          ///< in Model::components
        std::vector<Argument> arguments = {};  ///< one per parameter, defaults applied
        Id<Component::Location> initial = {};
        bool environment = false;
        Span origin = {};
        bool operator==(const Instance&) const = default;
    };

    /// An automaton that watches (DESDES06 section 4, Fig. 6): in each step of an untimed model it takes the first of
    /// its edges whose guard holds, or stays. Guards are expressions of the loop, like the operands of properties.
    struct ObserverLocation {
        std::string name = {};
        Span origin = {};
        bool operator==(const ObserverLocation&) const = default;
    };
    struct ObserverEdge {
        Id<ObserverLocation> from = {}, to = {};
        Id<Expr> guard = {};
        Span origin = {};
        bool operator==(const ObserverEdge&) const = default;
    };
    struct Observer {
        std::string name = {};
        Table<ObserverLocation> locations = {};
        Id<ObserverLocation> initial = {};
        std::vector<ObserverEdge> edges = {};
        Span origin = {};
        bool operator==(const Observer&) const = default;
    };

    /// Something that is said to hold always of the inputs of the controllers: assumed where they are free, a property
    /// to prove beside plant automata. Written in the loop, in the chart of a controller, or in a component whose outputs
    /// are meant.
    struct Constraint {
        std::string name = {};  ///< `constraint_1`, `H_Cyl_constraint_1`
        Id<Expr> condition = {};
        Id<Controller> controller = {};  ///< whose chart says so; else not valid
        Id<Instance> instance = {};      ///< whose component says so; else not valid
        Span origin = {};
        bool operator==(const Constraint&) const = default;
    };

    /// What a name in a property stands for.
    struct SharedSymbol {
        Id<Shared> shared = {};
        bool operator==(const SharedSymbol&) const = default;
    };
    struct InternalSymbol {
        Id<Controller> controller = {};
        Id<Chart::Variable> variable = {};
        bool operator==(const InternalSymbol&) const = default;
    };
    struct StepSymbol {
        Id<Controller> controller = {};
        Id<Chart::Step> step = {};
        bool operator==(const StepSymbol&) const = default;
    };
    struct LocationSymbol {
        Id<Instance> instance = {};
        Id<Component::Location> location = {};
        bool operator==(const LocationSymbol&) const = default;
    };
    /// A variable of an instance's own.
    struct OwnSymbol {
        Id<Instance> instance = {};
        Id<Component::Variable> variable = {};
        bool operator==(const OwnSymbol&) const = default;
    };
    /// The end of a timer of a chart: what `t1/v/t2` is to the controller beside v itself (IEC 60848, 4.4).
    struct TimeSymbol {
        Id<Controller> controller = {};
        Id<Chart::TimeCondition> condition = {};  ///< of the chart; not valid: what times continuous actions of `step`
        Id<Chart::Step> step = {};
        std::int64_t rise_ms = 0;  ///< of `step`: their delay, or the end of their limit
        bool operator==(const TimeSymbol&) const = default;
    };
    /// An observer is at a location.
    struct ObserverSymbol {
        Id<Observer> observer = {};
        Id<ObserverLocation> location = {};
        bool operator==(const ObserverSymbol&) const = default;
    };
    using Symbol =
        std::variant<SharedSymbol, InternalSymbol, StepSymbol, LocationSymbol, OwnSymbol, TimeSymbol, ObserverSymbol>;

    std::string name = {};
    Grain grain = Grain::Phased;
    std::optional<std::int64_t> time_unit_ms = {};  ///< as written; else the greatest common divisor is taken
    std::vector<NamedConstant> constants = {};
    Table<Controller> controllers = {};
    Table<Shared> shared = {};
    Table<Instance> instances = {};
    Exprs exprs = {};  ///< of properties, constraints, observers; Variable leaves -> symbols
    Table<Symbol> symbols = {};
    Table<Property> properties = {};
    Table<Constraint> constraints = {};
    Table<Observer> observers = {};
    std::optional<Schedule> schedule = {};  ///< as written; else interleaved
    Span time_unit_origin = {};
    Span origin = {};

    bool operator==(const ClosedLoop&) const = default;
};

struct Model {
    Table<Chart> charts = {};
    Table<Component> components = {};  ///< those written in the input and those of the library that are used
    Table<ClosedLoop> loops = {};

    bool operator==(const Model&) const = default;
};

std::vector<std::string> verify(const ClosedLoop& loop, const Model& model);

/// The shared variables that an argument reads or writes, each once.
std::vector<Id<ClosedLoop::Shared>> shared_in(const ClosedLoop& loop, const ClosedLoop::Argument& argument);

/// Where the variable stands among the arguments of its process in a Network: behind those of the parameters, inputs that
/// are terms apart.
std::size_t own_argument(const ClosedLoop& loop, const ClosedLoop::OwnSymbol& symbol);

/// Whether something of the chart waits for it, so that there is such a timer.
bool is_waited_for(const Chart& chart, const ClosedLoop::TimeSymbol& symbol);
/// Likewise of all that a property of the loop reads: in a chart that was changed afterwards perhaps nothing waits any more.
bool has_its_timers(const ClosedLoop& loop, const Property& property, const Model& model);
/// The variable of the equations of its controller's chart that is the end of that timer, which something waits for.
Id<Equations::Variable> end_of(const Equations& equations, const ClosedLoop::TimeSymbol& symbol);

/// Whether an operand of `property` asks where an observer is: untimed models alone have observers.
bool reads_observer(const ClosedLoop& loop, const Property& property);
/// Of every chart, component and loop.
std::vector<std::string> verify(const Model& model);

}  // namespace grafverif
