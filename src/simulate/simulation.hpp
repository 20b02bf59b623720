// SPDX-License-Identifier: MIT
// Simulation: a closed loop or a chart alone, moved by commands. Whoever talks to a person, follows a script, walks at
// random or answers a page does so with these.
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
    /// What is simulated outlives the simulation.
    Simulation(const Network& network, std::vector<const Chart*> charts, Detail detail)
        : of_(std::in_place_type<LoopSimulation>, network, std::move(charts), detail) {}
    Simulation(const Chart& chart, ExecutionMode mode, Detail detail)
        : of_(std::in_place_type<ChartSimulation>, chart, mode, detail) {}

    /// What follows the power-on by itself; what went wrong, or empty.
    std::string begin();
    /// What went wrong; empty: all is well. Of commands that move nothing, nothing does.
    std::string obey(const Command& command);
    /// Whether the last command was an `expect` or a `wait until` that was not met; then what is so instead is what
    /// went wrong, and the simulation can go on.
    bool unmet() const { return unmet_; }

    /// How many commands there are that `undo` would undo.
    std::size_t undoable() const { return commands_.size(); }

    const ChartRun& told() const;
    /// The first row of `told` that is no run of the model any more, since a step was forced by hand; empty: all are.
    std::optional<std::size_t> trial_row() const;
    std::vector<Choice> choices() const;
    std::size_t choice_count() const;
    Patience patience() const;
    /// Constraints of the chart that the inputs break now; with a plant they are claims about it, to be proved.
    std::vector<std::string> broken_constraints() const;

    /// The whole run told in one go: what one command did is not told apart from what the next one did.
    ChartRun retold(Detail detail) const;

private:
    std::string made(const Command& command);
    std::string undo();
    std::size_t moves() const;
    std::string choose(std::size_t number);
    std::string expect(const ExpectCommand& wish);
    std::optional<std::string> unmet_at(const Claim& claim, std::size_t moment, std::string& problem) const;
    /// True if the claim has become true in the current instant, after the event `examined_`.
    bool met_in_passing(const Claim& claim);

    std::variant<LoopSimulation, ChartSimulation> of_;
    struct Before {
        std::size_t moves = 0, examined = 0;
    };
    std::vector<Before> commands_ = {};  ///< the values before each command that can be undone
    std::size_t examined_ = 0;           ///< the event of `told` after which `wait until` begins to examine
    bool unmet_ = false;
};

/// One command after the other, each of those possible as likely as the others; how long time passes is drawn too.
class RandomWalk {
public:
    explicit RandomWalk(std::uint64_t seed) : random_(seed) {}

    /// Empty: nothing can happen any more.
    std::optional<Command> draw(const Simulation& simulation);

private:
    std::mt19937_64 random_;
};

}  // namespace grafverif
