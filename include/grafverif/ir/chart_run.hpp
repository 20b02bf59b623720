// SPDX-License-Identifier: MIT
// ChartRun: a run of a closed loop in terms of its charts: the sampled inputs of each controller, the transitions
// cleared by its evolutions, the outputs written, and the moves of the plant. It contains no elements of the model in
// which it was found: no location of the PLC, no flag, no variable of the translation.
// `project` (run/project.hpp) creates it from a run of a Network or of a TransitionSystem. The replay (run/replay.hpp)
// checks it on IEC 60848, and `tell` (report/trace_rows.hpp) adds the rows to be printed. All displays use only it.
//
// The first event is power-on; each further entry is one event with the state after it. A row summarizes the events
// since the previous row. A search for stability, from the sampling of the inputs to the writing of the outputs, is one
// row, or two if the plant moves during it.
//
// Invariants (see verify): ids in their tables; the values of a state are as many as there are signals; situations are
// increasing; time never decreases; rows are in the order of their events; the loop begins at a row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/step_name.hpp"
#include "grafverif/ir/type.hpp"
#include "grafverif/support/table.hpp"

namespace grafverif {

struct ChartRun {
    enum class Kind { Plant, Environment, Timer, Controller, Delay, Observer };
    enum class Role {
        Input,     ///< inputs of controllers from the plant
        Output,    ///< outputs written by controllers
        Internal,  ///< internal variables of controllers
        Image,     ///< outputs with stored actions, before they are written
        Plant,     ///< variables of the plant only
    };
    struct Signal {
        Role role = Role::Input;
        std::string name = {};
        Type type = {};
        bool operator==(const Signal&) const = default;
    };
    struct Step {
        StepName name = {};           ///< in its chart
        std::string controller = {};  ///< empty if there is only one
        std::string short_name = {};  ///< shortest unambiguous name

        /// `2`, `G2.2`; with several controllers `press.2`, `press.G2.2`.
        std::string full_name() const { return (controller.empty() ? "" : controller + ".") + name.text(); }
        bool operator==(const Step&) const = default;
    };
    struct Transition {
        std::string name = {};
        bool operator==(const Transition&) const = default;
    };
    struct Timer {
        std::string name = {};                  ///< displayed name: of the timer, or of its controller
        std::string watched = {};               ///< in the notation of conditions: `X2`, `a`; empty for other terms
        std::optional<std::size_t> step = {};   ///< the observed step, in Controller::steps
        std::int64_t rise_ms = 0, fall_ms = 0;  ///< t1 and t2
        bool exact = false;                     ///< expires exactly at the time given by the rules
        bool operator==(const Timer&) const = default;
    };
    /// Lists are in the order of the chart's tables; lists of variables, in the order of those of that kind.
    struct Controller {
        std::string name = {};
        ExecutionMode mode = ExecutionMode::StabilitySearch;
        std::vector<Id<Step>> steps = {};
        std::vector<Id<Transition>> transitions = {};
        std::vector<Id<Signal>> inputs = {}, outputs = {}, internals = {};
        std::vector<Id<Signal>> images = {};  ///< per output; invalid: it has none, or the model does not show it
        std::vector<Id<Timer>> timers = {};
        std::vector<std::optional<std::size_t>> conditions = {};  ///< per time condition: its timer, if any
        bool operator==(const Controller&) const = default;
    };
    /// An instance of the loop, or a timer displayed like one.
    struct Instance {
        Kind kind = Kind::Plant;
        std::string name = {};
        std::vector<std::string> locations = {};
        bool operator==(const Instance&) const = default;
    };

    /// Actions of one controller in an event: one phase of its cycle, or several together.
    struct Act {
        enum class Writes { No, IfStable, Yes };
        Id<Controller> controller = {};
        bool begins = false;                    ///< a cycle begins
        bool starts = false;                    ///< the first evolution after power-on; all timers are false
        bool samples = false;                   ///< inputs and timer outputs are sampled
        bool evolves = false;                   ///< one evolution
        Writes writes = Writes::No;             ///< outputs are written
        std::vector<std::int64_t> inputs = {};  ///< as sampled
        std::vector<bool> timers = {};          ///< sampled outputs
        /// For an evolution: the timers whose t1 had elapsed when the situation changed; empty: those sampled.
        std::vector<bool> done = {};
        std::vector<Id<Transition>> fired = {};      ///< cleared; for a sampling alone, those to be cleared
        std::optional<bool> stable = {}, race = {};  ///< after the evolution, if the model includes them
        bool operator==(const Act&) const = default;
    };
    struct State {
        std::int64_t time_ms = 0;  ///< in an untimed run: number of steps of the model so far
        std::vector<Id<Step>> situation = {};
        std::vector<std::int64_t> values = {};  ///< per signal
        bool operator==(const State&) const = default;
    };
    struct Event {
        Kind kind = Kind::Controller;
        bool internal = false;  ///< internal to the model
        std::size_t move = 0;   ///< index in the original run
        std::vector<Act> acts = {};
        Id<Instance> instance = {};                ///< the instance that moved
        std::optional<std::size_t> location = {};  ///< its new location
        std::vector<Id<Signal>> changed = {};      ///< changed signals
        Id<Timer> timer = {};                      ///< the timer whose delay has elapsed
        bool timer_holds = false;                  ///< new value of `t1/v/t2`
        State after = {};
        bool operator==(const Event&) const = default;
    };
    struct Row {
        Kind kind = Kind::Plant;
        std::string component = {};  ///< the instance, the controller or the timer; empty for a delay
        std::string what = {};       ///< `going_out, H 4 -> 6`; may be empty
        std::vector<std::vector<Id<Transition>>> fired = {};  ///< one list per evolution that cleared transitions
        bool internal = false;                                ///< internal to the translation; shown on request
        std::size_t moment = 0;                               ///< the state after the row is that after this event
        bool operator==(const Row&) const = default;
    };

    /// A value that causes the violation (explain/causes.hpp). It is a value of a signal, of a step (1: active), of an
    /// instance (1: at `location`), or of a named time condition (1: true). The other ids are invalid.
    struct Cause {
        Id<Signal> signal = {};
        Id<Step> step = {};
        Id<Instance> instance = {};
        Id<Timer> timer = {};
        std::size_t location = 0;
        std::int64_t value = 0;
        std::size_t first = 0, last = 0;  ///< a cause after these events and each between them
        bool operator==(const Cause&) const = default;
    };

    /// An avoidable change: of a signal at an event, or the expiry of a timer; one of the two ids is valid.
    struct Counterfactual {
        std::size_t moment = 0;
        Id<Signal> signal = {};
        Id<Timer> timer = {};
        bool operator==(const Counterfactual&) const = default;
    };

    std::string name = {};  ///< name of the loop
    bool timed = true;      ///< false: of an untimed model
    bool searches = true;   ///< a search for stability is one row; false: each evolution is a row
    Table<Controller> controllers = {};
    Table<Step> steps = {};
    Table<Transition> transitions = {};
    Table<Timer> timers = {};
    Table<Signal> signals = {};
    Table<Instance> instances = {};
    std::vector<Event> moments = {};
    std::optional<std::size_t> loop = {};       ///< the events from here on repeat forever; empty: no further event
    std::optional<std::size_t> broken_at = {};  ///< the first move of the run that failed; the rest is missing
    std::vector<Row> rows = {};
    std::optional<std::size_t> loop_from = {};  ///< the same loop, in rows
    std::vector<Cause> causes = {};             ///< ordered by their first event
    bool causes_exact = true;                   ///< false: causes may be missing or wrong
    /// A smallest set of avoidable free moves (explain/counterfactual.hpp), as events; empty: none searched, or found.
    std::vector<std::size_t> left_out = {};
    /// The same for single values, if inputs and times are free (explain/inputs.hpp); ordered by event.
    std::vector<Counterfactual> counterfactual_values = {};

    const State& after(const Row& row) const { return moments[row.moment].after; }

    bool operator==(const ChartRun&) const = default;
};

/// The rows to display: all except delays whose end the next row shows, if the loop keeps its shape.
std::vector<std::size_t> shown_rows(const ChartRun& run);
/// True if row `index` is one of them.
bool is_shown(const ChartRun& run, std::size_t index);

/// The signals of one role, in order.
std::vector<Id<ChartRun::Signal>> signals_of(const ChartRun& run, ChartRun::Role role);

std::vector<std::string> verify(const ChartRun& run);

/// `plant`, `environment`, `timer`, `controller`, `delay`.
std::string_view word(ChartRun::Kind kind);
/// `input`, `output`, `internal`, `image`, `plant`.
std::string_view word(ChartRun::Role role);

/// Sets the short name of each step to its name without partial chart and controller, if this is unambiguous.
void shorten_names(Table<ChartRun::Step>& steps);

/// Time of a state: `12 s`, or the number of steps, `3`.
std::string event_text(const ChartRun& run, const ChartRun::State& state);

/// `0 s`, `12 s`, `0.25 s`.
std::string seconds_text(std::int64_t milliseconds);

}  // namespace grafverif
