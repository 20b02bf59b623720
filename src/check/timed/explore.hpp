// SPDX-License-Identifier: MIT
// The search: every reachable state, breadth first.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "check/timed/graph.hpp"
#include "check/timed/machine.hpp"
#include "check/timed/timed.hpp"
#include "check/timed/watch.hpp"
#include "support/team.hpp"

namespace grafverif::timed {

/// The bounds of one check, its threads, and how far it has come.
class Limits {
public:
    explicit Limits(const TimedOptions& options)
        : options_(options), start_(std::chrono::steady_clock::now()), team_(options.jobs) {}

    Team& team() const { return team_; }
    std::uint32_t slice() const { return options_.slice; }
    /// Into how many parts work on so many states is cut that costs little for each.
    std::size_t parts(std::size_t states) const { return states < std::size_t{1024} * slice() ? 1 : team_.size(); }
    /// Calls `work(part)` for each of so many parts, side by side.
    template <class Work>
    void share(std::size_t parts, const Work& work) const {
        if (parts == 1) return work(0);
        team_.share([&](unsigned member) {
            for (std::size_t part = member; part < parts; part += team_.size()) work(part);
        });
    }

    /// Calls `work(begin, end)` for ranges that are so many states in all, side by side; no two have a state in one word
    /// of a set.
    template <class Work>
    void share_states(std::size_t states, const Work& work) const {
        const std::size_t parts = this->parts(states);
        const auto begin = [&](std::size_t part) { return part == parts ? states : states * part / parts / 64 * 64; };
        share(parts, [&](std::size_t part) { work(begin(part), begin(part + 1)); });
    }

    double seconds() const;
    /// Whether the user or the deadline ends the check.
    bool stopped() const;
    /// For every state of a loop that is no search: throws Stop where the check ends.
    struct Stop {};
    static constexpr std::size_t look_every = 65536;  ///< states
    void poll() const {
        if (++polls_ % look_every == 0 && stopped()) throw Stop{};
    }
    /// What ends the search, or None; shows progress now and then. `more`: bytes held besides the graph.
    Obstacle judge(const Graph& graph, std::uint32_t state, std::size_t more);
    /// Explains the states found, once, where there are many and somebody asks.
    void explain(Graph& graph);
    bool too_many(std::size_t states) const { return states >= options_.max_states || states >= Store::most; }
    bool until_decided() const { return options_.until_decided; }
    std::uint64_t max_memory() const { return options_.max_memory; }
    /// It was the memory allowed that ended the search, not what the system has.
    bool allowed_used() const { return allowed_used_; }

private:
    const TimedOptions& options_;
    std::chrono::steady_clock::time_point start_;
    double shown_ = 0;
    bool allowed_used_ = false;
    bool explained_ = false;
    mutable std::uint32_t polls_ = 0;
    mutable Team team_;
};

/// Fills `graph` from the initial state; returns what ended it early, or None. States in which the `race` bit is set are
/// found but not left.
Obstacle explore(Graph& graph, Watch& watch, const std::vector<Field>& races, Limits& limits);

}  // namespace grafverif::timed
