// SPDX-License-Identifier: MIT
// ClosedLoop: controllers (charts) and instances of components (plant and environment), which are connected by shared
// variables, and the properties to prove. Names are resolved, but the automata are not yet composed. Model: the
// contents of one input file and of the files that it includes.
//
// Invariants (see verify): every id is in its table; every input of every controller and every input of every instance
// is driven by exactly one instance output or controller output; each driver has the same type as the input that it
// drives.
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
        std::string name = {};  ///< name of the chart
        Id<Chart> chart = {};   ///< index in Model::charts
        ExecutionMode mode = ExecutionMode::StabilitySearch;
        /// Empty for cycle time zero: a scan starts as soon as an input, a timer or the situation requires a scan.
        std::optional<TaskCycle> cycle = {};
        Span origin = {};
        bool operator==(const Controller&) const = default;
    };

    /// A variable shared by instances and controllers: a controller's input or output, or a variable of the plant.
    struct Shared {
        std::string name = {};
        /// For an integer output of an instance: the range that the component declares, evaluated for the arguments of
        /// the instance.
        Type type = {};
        Id<Controller> reader = {};  ///< the first controller with an input of this name; invalid if there is none
        Id<Controller> writer = {};  ///< the controller that writes the variable; invalid if there is none

        /// Variable of the chart of `writer` or, without a writer, of the chart of `reader`.
        Id<Chart::Variable> variable = {};
        Span origin = {};
        bool operator==(const Shared&) const = default;
    };

    /// Value bound to a parameter of the component: a shared variable, a constant (Booleans 0 and 1, durations in ms),
    /// or, for an input, a term over shared variables in `exprs`. A term replaces the input in the expressions of the
    /// component.
    using Argument = std::variant<Id<Shared>, std::int64_t, Id<Expr>>;

    struct Instance {
        std::string name = {};
        Id<Component> component = {};  ///< index in Model::components

        /// Value of each parameter; missing arguments have been replaced by the defaults of the component.
        std::vector<Argument> arguments = {};
        Id<Component::Location> initial = {};
        bool environment = false;
        Span origin = {};
        bool operator==(const Instance&) const = default;
    };

    /// A fault: from power-on or from any later time, the instance `of` may behave permanently as another component.
    /// `behaviour` is an instance of the component of the fault: it writes the variables that `of`
    /// writes, and its name is the name of the fault. Only the command `faults` reads the declared
    /// faults (pipeline/variants/fault_model.hpp).
    struct Fault {
        Id<Instance> of = {};
        Instance behaviour = {};
        bool operator==(const Fault&) const = default;
    };

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
    /// A monitoring automaton (DESDES06 section 4, Fig. 6): in each step of an untimed model, the automaton takes the
    /// first edge of its location whose guard holds; if no guard holds, the automaton stays in the location. The guards
    /// of an observer are stored in ClosedLoop::exprs.
    struct Observer {
        std::string name = {};
        Table<ObserverLocation> locations = {};
        Id<ObserverLocation> initial = {};
        std::vector<ObserverEdge> edges = {};
        Span origin = {};
        bool operator==(const Observer&) const = default;
    };

    /// A condition on the inputs of the controllers. The condition is assumed if the inputs are free, and is a property
    /// to prove if there are plant automata. The condition is declared in the loop, in the chart of a controller, or in
    /// a component; a component constrains only its outputs.
    struct Constraint {
        std::string name = {};  ///< generated name, such as `constraint_1` or `H_Cyl_constraint_1`
        Id<Expr> condition = {};
        Id<Controller> controller = {};  ///< controller with the chart that declares the constraint, if any
        Id<Instance> instance = {};      ///< instance of the component that declares the constraint, if any
        Span origin = {};
        bool operator==(const Constraint&) const = default;
    };

    // The following structs represent the possible meanings of a name in a property.
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
    /// An internal variable of an instance.
    struct OwnSymbol {
        Id<Instance> instance = {};
        Id<Component::Variable> variable = {};
        bool operator==(const OwnSymbol&) const = default;
    };
    /// The output of a timer of a chart. The time condition `t1/v/t2` (IEC 60848, time-dependent
    /// conditions) reads v and the output of its timer.
    struct TimeSymbol {
        Id<Controller> controller = {};
        /// Time condition of the chart; invalid for a timer of the actions of `step`.
        Id<Chart::TimeCondition> condition = {};
        Id<Chart::Step> step = {};
        /// For a timer of `step`: the delay of an action, or the sum of its delay and its time limit, in milliseconds.
        std::int64_t rise_ms = 0;
        bool operator==(const TimeSymbol&) const = default;
    };
    /// A symbol that is true if an observer is in a location.
    struct ObserverSymbol {
        Id<Observer> observer = {};
        Id<ObserverLocation> location = {};
        bool operator==(const ObserverSymbol&) const = default;
    };
    using Symbol =
        std::variant<SharedSymbol, InternalSymbol, StepSymbol, LocationSymbol, OwnSymbol, TimeSymbol, ObserverSymbol>;

    std::string name = {};
    Grain grain = Grain::Phased;
    /// Declared time unit; if empty, the time unit is the greatest common divisor of all durations.
    std::optional<std::int64_t> time_unit_ms = {};
    std::vector<NamedConstant> constants = {};
    Table<Controller> controllers = {};
    Table<Shared> shared = {};
    Table<Instance> instances = {};
    Table<Fault> faults = {};
    Exprs exprs = {};  ///< expressions of properties, constraints and observers; Variable leaves index `symbols`
    Table<Symbol> symbols = {};
    Table<Property> properties = {};
    Table<Constraint> constraints = {};
    Table<Observer> observers = {};
    /// Declared schedule of untimed models; if empty, the schedule is interleaved.
    std::optional<Schedule> schedule = {};
    Span time_unit_origin = {};
    Span origin = {};

    bool operator==(const ClosedLoop&) const = default;
};

struct Model {
    Table<Chart> charts = {};
    /// Components declared in the input files, and the library components that the input files use.
    Table<Component> components = {};
    Table<ClosedLoop> loops = {};

    bool operator==(const Model&) const = default;
};

std::vector<std::string> verify(const ClosedLoop& loop, const Model& model);

/// Returns the shared variables that an argument reads or writes, without duplicates.
std::vector<Id<ClosedLoop::Shared>> shared_in(const ClosedLoop& loop, const ClosedLoop::Argument& argument);

/// Returns the index of the internal variable `symbol` in the arguments of its process in a
/// Network. The arguments of the process are the arguments of the instance that are not terms,
/// followed by the internal variables of the instance.
std::size_t own_argument(const ClosedLoop& loop, const ClosedLoop::OwnSymbol& symbol);

/// True if the chart has the timer of `symbol`: the chart reads the time condition, or a delay or
/// time limit of an action of `symbol.step` ends `symbol.rise_ms` after the activation of the step.
bool is_waited_for(const Chart& chart, const ClosedLoop::TimeSymbol& symbol);
/// True if all timers that a property of the loop reads exist. A timer may be missing if a chart was changed after the
/// property was read.
bool has_its_timers(const ClosedLoop& loop, const Property& property, const Model& model);
/// Returns the variable of the timer output `symbol` in the equations of its controller's chart. Requires
/// `is_waited_for(chart, symbol)`.
Id<Equations::Variable> end_of(const Equations& equations, const ClosedLoop::TimeSymbol& symbol);

/// True if an operand of `property` reads the location of an observer; observers exist only in untimed models.
bool reads_observer(const ClosedLoop& loop, const Property& property);
/// Returns the violated invariants of all charts, components and loops.
std::vector<std::string> verify(const Model& model);

}  // namespace grafverif
