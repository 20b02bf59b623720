// SPDX-License-Identifier: MIT
// Trace: a run of a closed loop in the words of its charts, for people and for other programs. Nothing of the network
// remains: no location of the PLC, no flag, no variable of the translation.
//
// The first step is the power-on; each further one is something that happened, and the state of everything behind it.
// A controller's step is a search for stability (or a cycle, in every_cycle) from the sampling of its inputs to the
// writing of its outputs, told as two where the plant moves meanwhile. The steps from `loop_from` on repeat for ever.
//
// Invariants (see verify): the values of a step are as many as there are signals; situations are increasing and name
// steps that exist; time never goes back; the loop begins at a step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/type.hpp"

namespace grafverif {

struct Trace {
    enum class Kind { Plant, Environment, Timer, Controller, Delay };

    struct Signal {
        std::string name = {};
        Type type = {};
        bool operator==(const Signal&) const = default;
    };

    /// Values in the order of the signals.
    struct State {
        std::int64_t time_ms = 0;    ///< of an untimed trace: steps of the model so far
        std::vector<std::uint32_t> situation = {};  ///< the active steps, indices into `steps_of_charts`
        std::vector<std::int64_t> inputs = {}, outputs = {}, internals = {}, plant = {};
        bool operator==(const State&) const = default;
    };

    struct Step {
        Kind kind = Kind::Plant;
        std::string component = {};  ///< the instance, the controller, the timer; of a delay empty
        std::string what = {};       ///< `going_out, H 4 -> 6`; may be empty
        /// The transitions cleared, one list per evolution that cleared any.
        std::vector<std::vector<std::string>> fired = {};
        bool internal = false;  ///< of the translation, for those who want to see all
        State after = {};
        bool operator==(const Step&) const = default;
    };

    std::vector<std::string> steps_of_charts = {};  ///< `2`, `G2.2`; of several controllers `press.2`
    std::vector<std::string> short_names = {};  ///< of the same steps; without what is not needed to tell them apart
    std::vector<Signal> inputs = {};            ///< what the controllers read of the plant
    std::vector<Signal> outputs = {};           ///< what they have written
    std::vector<Signal> internals = {};         ///< their internal variables
    std::vector<Signal> plant = {};             ///< what only the plant knows
    bool timed = true;                          ///< false: of a model that knows no time
    std::vector<Step> steps = {};
    std::optional<std::size_t> loop_from = {};  ///< in `steps`

    bool operator==(const Trace&) const = default;
};

/// The steps to show to people: all but the delays whose end the next step tells anyhow, where the loop keeps its
/// shape.
std::vector<std::size_t> shown_steps(const Trace& trace);
/// Whether step `index` is one of them.
bool is_shown(const Trace& trace, std::size_t index);

std::vector<std::string> verify(const Trace& trace);

/// `plant`, `environment`, `timer`, `controller`, `delay`.
std::string_view word(Trace::Kind kind);

/// Each name from its last point on, where that is enough to know it by: what short_names are.
std::vector<std::string> shortened_names(const std::vector<std::string>& names);

/// When a state is: its time, `12 s`, or the number of steps, `3`.
std::string moment_text(const Trace& trace, const Trace::State& state);

/// `0 s`, `12 s`, `0.25 s`.
std::string seconds_text(std::int64_t milliseconds);

}  // namespace grafverif
