// SPDX-License-Identifier: MIT
// Simulation: a closed loop or a single chart, controlled by commands. Interactive simulations, scripts, random walks
// and the web page use this interface.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "simulate/chart_simulation.hpp"
#include "simulate/commands.hpp"
#include "simulate/loop_simulation.hpp"

namespace grafverif {

class Simulation {
public:
    /// The simulated model must outlive the simulation.
    Simulation(const Network& network, std::vector<const Chart*> charts, Detail detail)
        : of_(std::in_place_type<LoopSimulation>, network, std::move(charts), detail) {}
    Simulation(const Chart& chart, ExecutionMode mode, Detail detail)
        : of_(std::in_place_type<ChartSimulation>, chart, mode, detail) {}

    /// Executes the automatic moves after power-on. Returns an error message or an empty string.
    std::string begin();
    /// Executes a command. Returns an error message or an empty string. A command that performs no moves is not an
    /// error.
    std::string execute(const Command& command);
    /// True if the last command was an `expect` or `wait until` whose expectation did not hold. The error message then
    /// describes the actual state, and the simulation can continue.
    bool unmet() const { return unmet_; }

    /// Returns the number of commands that can be undone.
    std::size_t undoable() const { return commands_.size(); }

    const ChartRun& recorded_run() const;
    /// Returns the index of the row in which the user first forced a step to change, or nullopt if there is no such
    /// row. From this row on, the recording is not a run of the model.
    std::optional<std::size_t> what_if_row() const;
    std::vector<Choice> choices() const;
    std::size_t choice_count() const;
    DelayBounds delay_bounds() const;
    /// Returns the constraints of the chart that the current inputs violate. For a loop with a plant, the result is
    /// empty, because constraints are properties to prove.
    std::vector<std::string> violated_constraints() const;

    /// Returns the complete run with rows that do not depend on the boundaries between commands.
    ChartRun with_trace_rows(Detail detail) const;

private:
    std::string made(const Command& command);
    std::string undo();
    std::size_t moves() const;
    std::string choose(std::size_t number);
    std::string expect(const ExpectCommand& wanted);
    std::optional<std::string> unmet_at(const Expectation& claim, std::size_t moment, std::string& problem) const;
    /// Examines the events after the event `examined_`, and advances `examined_`. Returns true if `claim` becomes true
    /// at one of these events in the current instant.
    bool met_in_passing(const Expectation& claim);

    std::variant<LoopSimulation, ChartSimulation> of_;
    struct Before {
        std::size_t moves = 0, examined = 0;
    };
    std::vector<Before> commands_ = {};  ///< number of moves and `examined_` before each undoable command
    std::size_t examined_ = 0;           ///< index of the event after which the next `wait until` examines the run
    bool unmet_ = false;
};

/// Random walk: chooses commands at random. All possible commands have equal probability, and delays are also random.
class RandomWalk {
public:
    explicit RandomWalk(std::uint64_t seed) : random_(seed) {}

    /// Returns a command, or nullopt if no further event is possible.
    std::optional<Command> draw(const Simulation& simulation);

private:
    std::mt19937_64 random_;
};

}  // namespace grafverif
