// SPDX-License-Identifier: MIT
// ChartRun: a run of a closed loop in terms of its charts. For each controller, a ChartRun contains the sampled inputs,
// the cleared transitions and the written outputs. A ChartRun also contains the moves of the plant. A ChartRun does not
// contain elements of the translated model, such as locations of the PLC process, flags and auxiliary variables.
// `project` (run/project.hpp) converts a run of a Network or of a TransitionSystem to a ChartRun. The replay
// (run/replay.hpp) checks a ChartRun against the rules of IEC 60848, and `with_rows` (report/trace_rows.hpp) adds the
// rows to be printed. All texts, diagrams and JSON data of a run are generated from a ChartRun.
//
// The first entry of `moments` is power-on; each further entry is one event with the state after this event. A row
// summarizes the events since the previous row. A search for stability lasts from the sampling of the inputs to the
// writing of the outputs. A search is one row, or two rows if the plant moves during the search.
//
// Invariants (see verify): ids are in their tables; a state has one value per signal; the steps of a situation are in
// increasing order; time never decreases; rows are in the order of their events; the repeated events (`loop`) begin at
// a row.
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
        Input,     ///< controller input that the plant writes
        Output,    ///< output that a controller writes
        Internal,  ///< internal variable of a controller
        Image,     ///< value of an output with stored actions, before it is written to the plant
        Plant,     ///< variable that only the plant uses
    };
    struct Signal {
        Role role = Role::Input;
        std::string name = {};
        Type type = {};
        bool operator==(const Signal&) const = default;
    };
    struct Step {
        StepName name = {};           ///< name of the step in its chart
        std::string controller = {};  ///< name of its controller; empty if the loop has only one controller

        /// The shortest unambiguous name, such as `2`; otherwise the full name (see shorten_names).
        std::string short_name = {};

        /// Returns `2` or `G2.2`; if the loop has several controllers, `press.2` or `press.G2.2`.
        std::string full_name() const { return (controller.empty() ? "" : controller + ".") + name.text(); }
        bool operator==(const Step&) const = default;
    };
    struct Transition {
        std::string name = {};
        bool operator==(const Transition&) const = default;
    };
    struct Timer {
        std::string name = {};  ///< name of the controller that has the timer

        /// Name of the observed step variable or variable, such as `X2` or `a`; empty if another term is observed.
        std::string watched = {};
        std::optional<std::size_t> step = {};   ///< index of the observed step in Controller::steps
        std::int64_t rise_ms = 0, fall_ms = 0;  ///< times t1 and t2 of the time condition `t1/v/t2`
        bool exact = false;  ///< true if the timer expires exactly at the time that IEC 60848 prescribes
        bool operator==(const Timer&) const = default;
    };
    /// All lists are in the order of the chart's tables. `inputs` may contain signals with the role Output, which
    /// another controller writes.
    struct Controller {
        std::string name = {};
        ExecutionMode mode = ExecutionMode::StabilitySearch;
        std::optional<TaskCycle> cycle = {};  ///< empty: the cycle time is zero, or the model does not include time
        std::vector<Id<Step>> steps = {};
        std::vector<Id<Transition>> transitions = {};
        std::vector<Id<Signal>> inputs = {}, outputs = {}, internals = {};
        /// For each output: its signal with the role Image; invalid if the output has no visible image.
        std::vector<Id<Signal>> images = {};
        std::vector<Id<Timer>> timers = {};
        /// For each time condition of the chart: index of its timer in `timers`; empty if the condition is not read.
        std::vector<std::optional<std::size_t>> conditions = {};
        bool operator==(const Controller&) const = default;
    };
    /// An instance of the loop, or a timer that is displayed as an instance.
    struct Instance {
        Kind kind = Kind::Plant;
        std::string name = {};
        std::vector<std::string> locations = {};
        bool operator==(const Instance&) const = default;
    };

    /// The actions of one controller in an event: one phase of its PLC cycle, or several phases together.
    struct Act {
        enum class Writes { No, IfStable, Yes };
        Id<Controller> controller = {};
        bool begins = false;  ///< true if a cycle of the controller begins

        /// True if a scan of a controller with a task cycle begins. False for the scan at power-on, for which `starts`
        /// is true.
        bool scans = false;
        bool starts = false;   ///< true for the first evolution after power-on, in which all timer outputs are false
        bool samples = false;  ///< true if inputs and timer outputs are sampled
        bool evolves = false;  ///< true if the controller executes one evolution
        Writes writes = Writes::No;             ///< writing of the outputs; IfStable: only if the situation is stable
        std::vector<std::int64_t> inputs = {};  ///< sampled values of the inputs
        std::vector<bool> timers = {};          ///< sampled values of the timer outputs

        /// For an evolution: true for each timer whose time t1 had elapsed when the situation changed. If `done` is
        /// empty, the values of `timers` apply.
        std::vector<bool> done = {};
        /// If `evolves`: the transitions that the evolution clears. If the controller only samples
        /// its inputs: the transitions that the next evolution clears.
        std::vector<Id<Transition>> fired = {};
        /// For a scan of a PLC program with free inputs: the time since the previous scan in
        /// milliseconds. Empty for all other controllers: `State::time_ms` contains the times of
        /// their scans.
        std::optional<std::int64_t> elapsed_ms = {};
        /// Values of the flags `stable` and `race` after the evolution; empty if the model does not have these flags.
        std::optional<bool> stable = {}, race = {};
        bool operator==(const Act&) const = default;
    };
    struct State {
        std::int64_t time_ms = 0;  ///< time in ms; in an untimed run, number of previous steps
        std::vector<Id<Step>> situation = {};
        std::vector<std::int64_t> values = {};  ///< value of each signal
        bool operator==(const State&) const = default;
    };
    struct Event {
        Kind kind = Kind::Controller;
        bool internal = false;  ///< true for an auxiliary move of the translated model, such as a move of an observer
        std::size_t move = 0;   ///< index of the move in the run of the Network or TransitionSystem
        std::vector<Act> acts = {};
        Id<Instance> instance = {};                ///< the instance that moved
        std::optional<std::size_t> location = {};  ///< the new location of `instance`
        std::vector<Id<Signal>> changed = {};      ///< signals whose value the event changed
        Id<Timer> timer = {};                      ///< the timer that expired, if the event is the expiry of a timer
        bool timer_holds = false;                  ///< new value of the time condition `t1/v/t2` of `timer`
        State after = {};
        bool operator==(const Event&) const = default;
    };
    struct Row {
        Kind kind = Kind::Plant;
        std::string component = {};  ///< the instance, controller or timer; empty for a delay
        std::string what = {};       ///< description such as `going_out, H 4 -> 6`; may be empty

        /// Cleared transitions: one list for each evolution that cleared transitions.
        std::vector<std::vector<Id<Transition>>> fired = {};

        /// True for a row of an auxiliary move of the translated model, which is displayed only on
        /// request.
        bool internal = false;
        std::size_t moment = 0;  ///< index of the event whose state is the state after this row
        bool operator==(const Row&) const = default;
    };

    /// A value that causes the violation (explain/causes.hpp): the value of a signal, of a step (1: active), of an
    /// instance (1: in `location`), or of a named time condition (1: true). Exactly one of `signal`, `step`, `instance`
    /// and `timer` is valid.
    struct Cause {
        Id<Signal> signal = {};
        Id<Step> step = {};
        Id<Instance> instance = {};
        Id<Timer> timer = {};
        std::size_t location = 0;
        std::int64_t value = 0;
        /// Indices of events; the value is a cause in the states after the events `first` to `last`.
        std::size_t first = 0, last = 0;
        bool operator==(const Cause&) const = default;
    };

    /// A change of a signal, or an expiry of a timer, without which the violation does not occur. Exactly one of
    /// `signal` and `timer` is valid.
    struct Counterfactual {
        std::size_t moment = 0;
        Id<Signal> signal = {};
        Id<Timer> timer = {};
        bool operator==(const Counterfactual&) const = default;
    };

    std::string name = {};  ///< name of the loop
    bool timed = true;      ///< false for a run of an untimed model
    bool searches = true;   ///< true: a row summarizes a search for stability; false: each evolution has a row
    Table<Controller> controllers = {};
    Table<Step> steps = {};
    Table<Transition> transitions = {};
    Table<Timer> timers = {};
    Table<Signal> signals = {};
    Table<Instance> instances = {};
    std::vector<Event> moments = {};
    /// Index of an event; the events from this index on repeat forever. Empty if the run is finite.
    std::optional<std::size_t> loop = {};
    /// Index of the first move that is not possible in the state reached by the previous moves. The
    /// run contains neither this move nor any later move. Empty if all moves are possible.
    std::optional<std::size_t> broken_at = {};
    std::vector<Row> rows = {};
    /// Index of the first row of the repeated events; empty if the run is finite.
    std::optional<std::size_t> loop_from = {};
    std::vector<Cause> causes = {};  ///< causes of the violation, ordered by their first event
    bool causes_exact = true;        ///< false: causes may be missing or incorrect

    /// Event indices of a smallest set of free moves without which the violation does not occur
    /// (explain/counterfactual.hpp); empty if not determined.
    std::vector<std::size_t> left_out = {};
    /// For a run with free inputs and times: a smallest set of input changes and timer expiries without which the
    /// violation does not occur (explain/inputs.hpp), ordered by event.
    std::vector<Counterfactual> counterfactual_values = {};

    const State& after(const Row& row) const { return moments[row.moment].after; }

    bool operator==(const ChartRun&) const = default;
};

/// Returns the rows to display. A delay is omitted because the next row shows the time at which the delay ends. Delays
/// at the end of the run and at the beginning of `loop` are displayed.
std::vector<std::size_t> shown_rows(const ChartRun& run);
/// True if `shown_rows` contains row `index`.
bool is_shown(const ChartRun& run, std::size_t index);

/// Returns the signals with the given role, in order.
std::vector<Id<ChartRun::Signal>> signals_of(const ChartRun& run, ChartRun::Role role);

std::vector<std::string> verify(const ChartRun& run);

/// Returns `plant`, `environment`, `timer`, `controller`, `delay` or `observer`.
std::string_view word(ChartRun::Kind kind);
/// Returns `input`, `output`, `internal`, `image` or `plant`.
std::string_view word(ChartRun::Role role);

/// Sets the short name of each step to its name without partial chart and controller, if that name is unambiguous.
void shorten_names(Table<ChartRun::Step>& steps);

/// Returns the time of a state, such as `12 s`. For an untimed run, returns the number of previous steps, such as `3`.
std::string event_text(const ChartRun& run, const ChartRun::State& state);

/// Returns a time in seconds: `0 s`, `12 s`, `0.25 s`.
std::string seconds_text(std::int64_t milliseconds);

}  // namespace grafverif
