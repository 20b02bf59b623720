// SPDX-License-Identifier: MIT
// Network: timed automata with discrete data that share variables (CEP13 2.4). A Network represents the closed loop for
// the engines and for the generation of models for other tools. Templates have parameters, and processes instantiate
// templates. `expand` gives each process a separate template.
//
// Semantics (CEP13 section 2; urgency as in ETFA12 section 2). Processes take edges one at a time. An edge can be taken
// if its guard and its clock constraint hold and the invariant of its target location holds after its clock resets.
// Taking the edge executes its assignments and then the procedures that it calls, in order, and resets clocks. Time may
// pass while every invariant holds and no urgent edge is enabled. Each assignment uses the results of the previous
// assignments. An assignment of a value outside the range of its target is a model error (`out-of-range`).
//
// Expressions are stored in `exprs`; apart from constants, their leaves are Variable (index in
// `variables`), Parameter (index in the `parameters` of the current template) and, in properties
// and `settled`, At. A `scratch` variable stores a value only within one edge: it is written before
// it is read, and does not belong to the state.
//
// Invariants (see verify): ids are in their tables; guards are Boolean, over variables and parameters; urgent edges
// have no clock constraint; whenever an urgent edge is taken, the invariant of its target location holds; arguments
// match parameters in kind and type; initial values are in range; scratch variables are written before they are read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
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

struct Network {
    enum class Role {
        Input,
        Output,
        Internal,
        Step,  ///< step activity of a controller
        FiringCondition,
        Sample,        ///< input of a controller, as sampled for its PLC cycle
        Image,         ///< output of a controller before it is written
        TimerEnd,      ///< output of a timer
        TimerPending,  ///< request of a controller to start or stop a timer
        Previous,      ///< value of a term in the previous cycle, from which its rising and falling edges are computed
        Watched,       ///< level that a timer observes
        Flag,          ///< flag of a controller: EVOL_PL, EVOL_TI, stable or race
        Plant,         ///< variable that only instances share
    };
    struct Variable {
        std::string name = {};
        Role role = Role::Plant;
        Type type = {};
        std::int64_t initial = 0;
        bool scratch = false;
        Span origin = {};
        std::string shown_name = {};  ///< name in properties and traces, such as `Gate.X`; if empty, `name` is used

        const std::string& display_name() const { return shown_name.empty() ? name : shown_name; }
        bool operator==(const Variable&) const = default;
    };

    enum class ParameterKind { Read, Written, Constant };  ///< Read and Written pass a variable by reference
    struct Parameter {
        std::string name = {};
        ParameterKind kind = ParameterKind::Read;
        Type type = {};  ///< for kind Constant, Booleans are 0 and 1, and durations are integers in time units
        bool operator==(const Parameter&) const = default;
    };

    struct Clock {
        std::string name = {};
        bool operator==(const Clock&) const = default;
    };
    struct ClockConstraint {
        Id<Clock> clock = {};
        Op relation = Op::LessEqual;  ///< one of Less, LessEqual, Equal, GreaterEqual and Greater
        Id<Expr> bound = {};          ///< term over constants and Constant parameters, in time units
        bool operator==(const ClockConstraint&) const = default;
    };

    struct Location {
        std::string name = {};
        std::vector<ClockConstraint> invariant = {};
        Span origin = {};
        bool operator==(const Location&) const = default;
    };

    struct Assignment {
        Id<Expr> target = {};  ///< a Variable leaf, or a Parameter leaf of kind Written
        Id<Expr> value = {};
        bool operator==(const Assignment&) const = default;
    };
    /// A named list of assignments that edges call, such as `fire`, `evolve`, `write`.
    struct Procedure {
        std::string name = {};
        std::vector<Assignment> assignments = {};
        bool operator==(const Procedure&) const = default;
    };

    struct Edge {
        Id<Location> from = {}, to = {};
        bool urgent = false;
        Id<Expr> guard = {};
        std::vector<ClockConstraint> constraint = {};
        std::vector<Id<Clock>> resets = {};
        std::vector<Assignment> assignments = {};
        std::vector<Id<Procedure>> calls = {};
        Span origin = {};
        bool operator==(const Edge&) const = default;
    };

    struct Template {
        std::string name = {};
        Table<Parameter> parameters = {};
        Table<Clock> clocks = {};
        Table<Location> locations = {};
        Id<Location> initial = {};  ///< initial location of each process that does not override it
        Table<Procedure> procedures = {};
        Table<Edge> edges = {};
        Span origin = {};
        bool operator==(const Template&) const = default;
    };

    using Argument = std::variant<Id<Variable>, std::int64_t>;
    enum class ProcessKind { Plant, Environment, Controller, Timer, Observer };
    struct Process {
        std::string name = {};
        Id<Template> automaton = {};
        std::vector<Argument> arguments = {};
        Id<Location> initial = {};  ///< initial location, as an index in the template
        ProcessKind kind = ProcessKind::Plant;
        Span origin = {};
        bool operator==(const Process&) const = default;
    };

    struct Timer {
        Id<Process> process = {};
        Id<Location> done = {};  ///< location of the timer process after t1 has elapsed; invalid if the timer has no t1

        /// True: the timer restarts whenever its step is activated, even if the step was deactivated in the same
        /// instant. False: the timer observes only the activity of its step (CEP13 Fig. 33b), and does not notice that
        /// the step was deactivated and activated again in one instant.
        bool restarts = true;
        bool operator==(const Timer&) const = default;
    };
    /// A controller: the names of its chart, and the elements of the network that implement its PLC cycle.
    struct Controller {
        ControllerWords<Variable> words = {};
        Id<Process> process = {};   ///< process that represents the PLC
        Id<Location> waiting = {};  ///< location W (the PLC waits for the next cycle) of the template of `process`
        Id<Variable> stable = {};
        std::vector<Timer> timers = {};  ///< timers in the order of `words`

        /// For each variable of the controller's equations: the corresponding variable of the network.
        std::vector<Id<Variable>> variables = {};
        /// For each output: the variable that stores the new value until the output is written; invalid if the output
        /// has no such variable.
        std::vector<Id<Variable>> images = {};
        /// Procedure that is executed before the first cycle; invalid if no such procedure is necessary.
        Id<Procedure> start = {};
        Id<Procedure> fire = {}, evolve = {}, write = {};
        bool operator==(const Controller&) const = default;
    };

    std::string name = {};
    Grain grain = Grain::Phased;
    std::int64_t time_unit_ms = 1000;
    /// Named constants of the loop, which the headers of generated files list.
    std::vector<NamedConstant> constants = {};
    Exprs exprs = {};
    Table<Variable> variables = {};
    Table<Template> templates = {};
    Table<Process> processes = {};
    Table<Controller> controllers = {};
    Table<Property> properties = {};
    /// Condition for a quiescent state, over variables and At. In a quiescent state, every controller is stable and in
    /// its location W (`waiting`), and no process other than a controller has an enabled urgent edge. No controller has
    /// an unprocessed change of the plant or of a timer (EVOL_PL, EVOL_TI), and no timer request is pending.
    Id<Expr> settled = {};
    /// Flag that is set when two stored actions have written different values (race); invalid if a race is impossible.
    Id<Variable> race = {};

    bool operator==(const Network&) const = default;
};

std::vector<std::string> verify(const Network& network);

/// True if the edge calls the procedure; false if `procedure` is invalid.
bool has_call(const Network::Edge& edge, Id<Network::Procedure> procedure);

/// Returns the value of `bound` for the arguments of `process`. A clock bound contains only
/// constants.
std::int64_t bound_value(const Network& network, const Network::Process& process, Id<Expr> bound);

/// True if the invariant of the target of `edge` holds whenever the edge is taken without delay: each clock that this
/// invariant bounds is either reset by the edge or bounded at least as strongly in the source location. UPPAAL ignores
/// invariants when it decides if an urgent edge is enabled; therefore, `verify` requires that this function is true for
/// every urgent edge.
bool keeps_target_invariant(const Network& network, const Network::Process& process, const Network::Edge& edge);

/// Returns an equivalent network with one template per process and without parameters. Indices of processes and
/// locations are unchanged, so the properties of `network` remain valid for the result.
Network expand(const Network& network);

}  // namespace grafverif
