// SPDX-License-Identifier: MIT
// ChartRun: a run of a closed loop in the words of its charts: what each controller sampled, which transitions each of
// its evolutions cleared, what it wrote, what the plant did meanwhile. Nothing of the model that the run was found in
// remains: no location of the PLC, no flag, no variable of the translation. `project` (run/project.hpp) makes one of a
// run of a Network or of a TransitionSystem, the replay (run/replay.hpp) checks it on the rules of IEC 60848, `tell`
// (report/tell.hpp) adds the rows that people read, and whoever shows a run reads it and nothing else.
//
// The first moment is the power-on; each further one is one thing that happened, and the state of everything behind it.
// A row sums up the moments since the row before it: a search for stability, from the sampling of the inputs to the
// writing of the outputs, is one row, or two where the plant moves meanwhile.
//
// Invariants (see verify): ids in their tables; the values of a state are as many as there are signals; situations are
// increasing; time never goes back; rows are in the order of their moments; the loop begins at a row.
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
        Input,     ///< what the controllers read of the plant
        Output,    ///< what they have written
        Internal,  ///< their internal variables
        Image,     ///< outputs with stored actions, as they will be written
        Plant,     ///< what only the plant knows
    };
    struct Signal {
        Role role = Role::Input;
        std::string name = {};
        Type type = {};
        bool operator==(const Signal&) const = default;
    };
    struct Step {
        StepName name = {};           ///< in its chart
        std::string controller = {};  ///< empty: there is one alone
        std::string short_name = {};  ///< without what is not needed to tell it from the others

        /// `2`, `G2.2`; of several controllers `press.2`, `press.G2.2`.
        std::string full_name() const { return (controller.empty() ? "" : controller + ".") + name.text(); }
        bool operator==(const Step&) const = default;
    };
    struct Transition {
        std::string name = {};
        bool operator==(const Transition&) const = default;
    };
    struct Timer {
        std::string name = {};                  ///< who is said to end: the timer, or its controller
        std::string watched = {};               ///< as conditions write it: `X2`, `a`; of a longer term empty
        std::optional<std::size_t> step = {};   ///< the step it watches, in Controller::steps
        std::int64_t rise_ms = 0, fall_ms = 0;  ///< t1 and t2
        bool exact = false;                     ///< it is to be over exactly when the rules say so
        bool operator==(const Timer&) const = default;
    };
    /// Lists are in the order of the chart's tables; of variables, of those of the kind.
    struct Controller {
        std::string name = {};
        ExecutionMode mode = ExecutionMode::StabilitySearch;
        std::vector<Id<Step>> steps = {};
        std::vector<Id<Transition>> transitions = {};
        std::vector<Id<Signal>> inputs = {}, outputs = {}, internals = {};
        std::vector<Id<Signal>> images = {};  ///< per output; not valid: it has none, or the model shows none
        std::vector<Id<Timer>> timers = {};
        std::vector<std::optional<std::size_t>> conditions = {};  ///< per time condition: its timer, if any
        bool operator==(const Controller&) const = default;
    };
    /// An instance of the loop, or a timer that is told like one.
    struct Instance {
        Kind kind = Kind::Plant;
        std::string name = {};
        std::vector<std::string> locations = {};
        bool operator==(const Instance&) const = default;
    };

    /// What one controller did in a moment: one phase of its cycle, or several at once.
    struct Act {
        enum class Writes { No, IfStable, Yes };
        Id<Controller> controller = {};
        bool begins = false;                    ///< a cycle begins
        bool starts = false;                    ///< the first evolution after power-on; it finds no timer over
        bool samples = false;                   ///< inputs and ends of timers are read
        bool evolves = false;                   ///< one evolution
        Writes writes = Writes::No;             ///< outputs are written
        std::vector<std::int64_t> inputs = {};  ///< as sampled
        std::vector<bool> timers = {};          ///< as sampled: whether it is over
        /// Of an evolution: the timers whose t1 was over when the situation changed; empty: those sampled.
        std::vector<bool> done = {};
        std::vector<Id<Transition>> fired = {};      ///< cleared; of a sampling alone, those to be cleared
        std::optional<bool> stable = {}, race = {};  ///< behind the evolution, where the model says so
        bool operator==(const Act&) const = default;
    };
    struct State {
        std::int64_t time_ms = 0;  ///< of an untimed run: steps of the model so far
        std::vector<Id<Step>> situation = {};
        std::vector<std::int64_t> values = {};  ///< per signal
        bool operator==(const State&) const = default;
    };
    struct Moment {
        Kind kind = Kind::Controller;
        bool internal = false;  ///< of the model, not of the loop
        std::size_t move = 0;   ///< of the run that this one was made of
        std::vector<Act> acts = {};
        Id<Instance> instance = {};                ///< the one that moved
        std::optional<std::size_t> location = {};  ///< where it went
        std::vector<Id<Signal>> changed = {};      ///< what it changed
        Id<Timer> timer = {};                      ///< the one whose delay is over
        bool timer_holds = false;                  ///< and what `t1/v/t2` is then
        State after = {};
        bool operator==(const Moment&) const = default;
    };
    struct Row {
        Kind kind = Kind::Plant;
        std::string component = {};  ///< the instance, the controller, the timer; of a delay empty
        std::string what = {};       ///< `going_out, H 4 -> 6`; may be empty
        std::vector<std::vector<Id<Transition>>> fired = {};  ///< one list per evolution that cleared any
        bool internal = false;                                ///< of the translation, for those who want to see all
        std::size_t moment = 0;                               ///< the state behind it is the one behind this moment
        bool operator==(const Row&) const = default;
    };

    /// A value that makes the property fail that the run shows violated (explain/causes.hpp says what that is): of a signal, of
    /// a step (1: it is active), of an instance (1: it is at `location`), or of a time that has a name (1: it is over). The
    /// others are not valid.
    struct Cause {
        Id<Signal> signal = {};
        Id<Step> step = {};
        Id<Instance> instance = {};
        Id<Timer> timer = {};
        std::size_t location = 0;
        std::int64_t value = 0;
        std::size_t first = 0, last = 0;  ///< behind these moments, and each between them, it is one
        bool operator==(const Cause&) const = default;
    };

    /// What a signal becomes at a moment, or a time that is over then, and could have been without: one of the two is valid.
    struct LeftOut {
        std::size_t moment = 0;
        Id<Signal> signal = {};
        Id<Timer> timer = {};
        bool operator==(const LeftOut&) const = default;
    };

    std::string name = {};  ///< the loop
    bool timed = true;      ///< false: of a model that knows no time
    bool searches = true;   ///< a search for stability is one row; false: each evolution is
    Table<Controller> controllers = {};
    Table<Step> steps = {};
    Table<Transition> transitions = {};
    Table<Timer> timers = {};
    Table<Signal> signals = {};
    Table<Instance> instances = {};
    std::vector<Moment> moments = {};
    std::optional<std::size_t> loop = {};       ///< the moments from here on repeat for ever; none: nothing happens
    std::optional<std::size_t> broken_at = {};  ///< the move of the run that could not be made; the rest is missing
    std::vector<Row> rows = {};
    std::optional<std::size_t> loop_from = {};  ///< the same loop, in rows
    std::vector<Cause> causes = {};             ///< by their first moment
    bool causes_exact = true;                   ///< false: some may be missing, and some may be none
    /// The fewest free moves without which the property holds along the run (explain/change.hpp), as moments; empty: none
    /// were looked for, or found.
    std::vector<std::size_t> left_out = {};
    /// Where inputs and times are free, what they become is (explain/inputs.hpp), one by one; by their moments.
    std::vector<LeftOut> left_out_values = {};

    const State& after(const Row& row) const { return moments[row.moment].after; }

    bool operator==(const ChartRun&) const = default;
};

/// The rows to show to people: all but the delays whose end the next row tells anyhow, where the loop keeps its shape.
std::vector<std::size_t> shown_rows(const ChartRun& run);
/// Whether row `index` is one of them.
bool is_shown(const ChartRun& run, std::size_t index);

/// The signals of one role, in order.
std::vector<Id<ChartRun::Signal>> signals_of(const ChartRun& run, ChartRun::Role role);

std::vector<std::string> verify(const ChartRun& run);

/// `plant`, `environment`, `timer`, `controller`, `delay`.
std::string_view word(ChartRun::Kind kind);
/// `input`, `output`, `internal`, `image`, `plant`.
std::string_view word(ChartRun::Role role);

/// Gives each step its name without any partial chart and controller for a short one, where that is enough to know it by.
void shorten_names(Table<ChartRun::Step>& steps);

/// When a state is: its time, `12 s`, or the number of steps, `3`.
std::string moment_text(const ChartRun& run, const ChartRun::State& state);

/// `0 s`, `12 s`, `0.25 s`.
std::string seconds_text(std::int64_t milliseconds);

}  // namespace grafverif
