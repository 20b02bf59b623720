// SPDX-License-Identifier: MIT
// LoopSimulation: a closed loop, moved by hand. Whoever moves it chooses what the plant and its environment do, sets inputs
// and lets time pass; the rest follows by itself, in a fixed order, until somebody has to choose again:
//
//   1  urgent edges of the plant and its environment, where an instance has one only: sensors follow the plant
//   2  timers
//   3  PLC cycles
//   4  edges that an invariant forces now, where an instance has one only: movements go on
//
// By hand a step can be forced besides, as a trial, between two cycles of its PLC.
//
// With Detail::Everything nothing follows by itself: every edge is a choice.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/network.hpp"
#include "ir/network_run.hpp"
#include "report/tell.hpp"
#include "run/by_hand.hpp"
#include "run/project.hpp"
#include "simulate/settings.hpp"
#include "simulate/trial.hpp"

namespace grafverif {

class LoopSimulation {
public:
    /// `network` and `charts`, those of its controllers, outlive the simulation.
    LoopSimulation(const Network& network, std::vector<const Chart*> charts, Detail detail);
    LoopSimulation(const LoopSimulation&) = delete;
    LoopSimulation& operator=(const LoopSimulation&) = delete;

    const ChartRun& told() const { return told_; }
    ChartRun retold(Detail detail) const { return tell(project(network_, run_), detail); }

    /// Empty after a race.
    std::vector<Choice> choices() const;
    std::size_t choice_count() const { return fires().size(); }
    Patience patience() const;

    /// Each of these is one command: it makes its moves and lets the rest follow. The answer says what went wrong;
    /// empty: all is well. A command that went wrong may have made some moves.
    std::string settle();
    /// Of the choices, counted from 0.
    std::string choose(std::size_t choice);
    std::string wait(std::int64_t milliseconds);
    /// Until something changes by itself, or can.
    std::string wait();
    /// Makes the first choice after which the input, or variable of the plant, has its value.
    std::string set(const std::vector<Setting>& settings);
    /// Makes the first choice of `instance` that leads to `location`; empty: the first.
    std::string act(std::string_view instance, std::string_view location);
    /// Makes the step active, or not, by hand.
    std::string force(std::string_view step, bool active);
    /// The first row that is no run of the network any more.
    std::optional<std::size_t> trial_row() const { return trial_row_; }
    /// How long until something happens by itself, or can be chosen; empty: for ever.
    std::optional<std::int64_t> soonest_ms() const;
    /// Location of the instance after the event `moment` of `told`; empty: there is no such instance.
    std::optional<std::string> location_of(std::string_view instance, std::size_t moment) const;
    /// What the variable behind a port is called: of `Main.FLOW` that what the output writes, of an input what it reads;
    /// empty: there is no such port, or what it reads is a term.
    std::string behind_port(std::string_view name) const;
    /// Undoes the last command; false: there is none.
    bool back();
    /// How many there are to undo.
    std::size_t commands() const { return commands_.size(); }

private:
    /// A trial, before the move of that number.
    struct Forced {
        std::size_t at = 0;
        Trial trial = {};
    };
    /// What there was before a command.
    struct Mark {
        std::size_t moves = 0, trials = 0;
    };

    void power_on();
    void begin_command() { commands_.push_back({run_.moves.size(), trials_.size()}); }
    void put(const Trial& trial);
    ByHand forced(const Trial& trial) const;
    std::vector<Fire> fires() const;
    std::string choose(const Fire& fire);
    /// One edge, nothing follows. False: it cannot be made, or broke the model off.
    bool move(const Move& move, std::string& problem);
    std::string command_of(const std::vector<Fire>& moves, std::size_t choice) const;
    std::string follow();
    std::optional<Fire> next_by_itself() const;
    std::string pass(std::int64_t units);
    std::string waiting_for() const;
    std::string problem_of(const Step& step, const Move& move) const;

    const Network& network_;
    std::vector<const Chart*> charts_;  ///< per controller
    Detail detail_;
    NetworkState state_;
    Run run_ = {};
    ChartRun told_ = {};
    std::optional<NetworkProjection> projection_;  ///< of the run, into `told_`
    std::optional<Teller> teller_;
    std::vector<Forced> trials_ = {};
    std::vector<Mark> commands_ = {};
    std::optional<std::size_t> trial_row_ = {};
    bool broken_ = false;
};

}  // namespace grafverif
