// SPDX-License-Identifier: MIT
// Network: timed automata with discrete data that share variables (CEP13 2.4), the closed loop in the form for engines
// and emitters. Templates have parameters; processes instantiate them; `expand` gives each process a separate template.
//
// Semantics (CEP13 section 2; urgency as in ETFA12 section 2). One edge is taken at a time: its guard and clock
// constraint hold, its procedures and assignments are executed in order, clocks are reset, and the invariants of the
// new locations hold after the resets. Time may pass while every invariant holds and no urgent edge is enabled. An
// edge's assignments come first, then the procedures it calls, in order; each assignment uses the results of those
// before it. A value outside the range of its variable is a model error (`out-of-range`).
//
// Expressions are stored in `exprs`: Variable -> variables, Parameter -> parameters of the current template, At in
// properties. A `scratch` variable carries a value within one edge only: it is written before it is read, and does not
// belong to the state.
//
// Invariants (see verify): ids in their tables; guards are Boolean, over variables and parameters; urgent edges have no
// clock constraint; the target invariant of an urgent edge holds whenever it is taken; arguments match parameters in
// kind and type; initial values are in range; scratch variables are written before read.
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
        Step,  ///< of a controller
        FiringCondition,
        Sample,
        Image,  ///< within its cycle: stored firing conditions, sampled inputs, outputs not yet written
        TimerEnd,
        TimerPending,  ///< of its timers
        Previous,
        Watched,  ///< previous values for edges, levels that timers observe
        Flag,     ///< EVOL_PL, EVOL_TI, stable, race
        Plant,    ///< shared by instances only
    };
    struct Variable {
        std::string name = {};
        Role role = Role::Plant;
        Type type = {};
        std::int64_t initial = 0;
        bool scratch = false;
        Span origin = {};
        std::string told = {};  ///< name in properties and traces, `Gate.X`; empty: `name`

        const std::string& display_name() const { return told.empty() ? name : told; }
        bool operator==(const Variable&) const = default;
    };

    enum class ParameterKind { Read, Written, Constant };  ///< Read and Written: a variable by reference
    struct Parameter {
        std::string name = {};
        ParameterKind kind = ParameterKind::Read;
        Type type = {};  ///< Constant: Booleans 0 and 1; durations are integers, in time units
        bool operator==(const Parameter&) const = default;
    };

    struct Clock {
        std::string name = {};
        bool operator==(const Clock&) const = default;
    };
    struct ClockConstraint {
        Id<Clock> clock = {};
        Op relation = Op::LessEqual;  ///< Less, LessEqual, Equal, GreaterEqual, Greater
        Id<Expr> bound = {};          ///< over constants and Constant parameters; in time units
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
    /// A named list of assignments that edges call: `fire`, `evolve`, `write`.
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
        Id<Location> initial = {};  ///< default for processes
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
        Id<Location> initial = {};  ///< in the template's locations
        ProcessKind kind = ProcessKind::Plant;
        Span origin = {};
        bool operator==(const Process&) const = default;
    };

    /// One controller: its names, and the elements of its cycle.
    struct Timer {
        Id<Process> process = {};
        Id<Location> done = {};  ///< location in the process after t1 has elapsed; invalid if it has no t1
        bool restarts = true;    ///< a request restarts it; false: it follows its step by level
        bool operator==(const Timer&) const = default;
    };
    struct Controller {
        ControllerWords<Variable> words = {};
        Id<Process> process = {};   ///< the PLC
        Id<Location> waiting = {};  ///< W, in its template
        Id<Variable> stable = {};
        std::vector<Timer> timers = {};            ///< in the order of `words`
        std::vector<Id<Variable>> variables = {};  ///< per variable of its equations: as visible to other processes
        std::vector<Id<Variable>> images = {};     ///< per output: its storage until it is written; invalid: none
        Id<Procedure> start = {};                  ///< invalid: no effect before the first cycle
        Id<Procedure> fire = {}, evolve = {}, write = {};
        bool operator==(const Controller&) const = default;
    };

    std::string name = {};
    Grain grain = Grain::Phased;
    std::int64_t time_unit_ms = 1000;
    std::vector<NamedConstant> constants = {};  ///< of the loop, for headers
    Exprs exprs = {};
    Table<Variable> variables = {};
    Table<Template> templates = {};
    Table<Process> processes = {};
    Table<Controller> controllers = {};
    Table<Property> properties = {};
    /// Quiescent: every controller in W and stable, no flag set, no urgent edge enabled. Over variables and At.
    Id<Expr> settled = {};
    /// The flag that two stored actions have raced; invalid if impossible.
    Id<Variable> race = {};

    bool operator==(const Network&) const = default;
};

std::vector<std::string> verify(const Network& network);

/// Value of `bound` for the arguments of `process`: clock bounds read only constants.
std::int64_t bound_value(const Network& network, const Network::Process& process, Id<Expr> bound);

/// True if the invariant of the target of `edge` holds whenever the edge is taken without delay: each clock that is
/// bounded there is reset by the edge, or bounded in its source at least as strongly. UPPAAL tests urgency on the guard
/// alone, so a Network has no urgent edge for which this is false.
bool keeps_target_invariant(const Network& network, const Network::Process& process, const Network::Edge& edge);

/// The same network with one template per process and no parameters; process and location indices are unchanged, and
/// properties keep their meaning.
Network expand(const Network& network);

}  // namespace grafverif
