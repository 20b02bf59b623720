// SPDX-License-Identifier: MIT
// The search: every reachable state, breadth first.
#pragma once

#include <chrono>

#include "check/graph.hpp"
#include "check/watch.hpp"
#include "grafverif/check/timed.hpp"

namespace grafverif::timed {

/// The bounds of one check, and how far it has come.
class Limits {
public:
    explicit Limits(const TimedOptions& options) : options_(options), start_(std::chrono::steady_clock::now()) {}

    double seconds() const;
    /// Whether the user or the deadline ends the check.
    bool stopped() const;
    /// For every state of a loop that is no search: throws Stop where the check ends.
    struct Stop {};
    void poll() const {
        if (++polls_ % 65536 == 0 && stopped()) throw Stop{};
    }
    /// What ends the search, or None; shows progress now and then. `more`: bytes held besides the graph.
    Obstacle judge(const Graph& graph, std::uint32_t state, std::size_t more);
    bool too_many(std::size_t states) const { return states >= options_.max_states || states >= Store::most; }
    std::uint64_t max_memory() const { return options_.max_memory; }
    /// It was the memory allowed that ended the search, not what the system has.
    bool allowed_used() const { return allowed_used_; }

private:
    const TimedOptions& options_;
    std::chrono::steady_clock::time_point start_;
    double shown_ = 0;
    bool allowed_used_ = false;
    mutable std::uint32_t polls_ = 0;
};

/// Fills `graph` from the initial state; returns what ended it early, or None. States in which the `race` bit is set are
/// found but not left.
Obstacle explore(Graph& graph, Watch& watch, const std::vector<Field>& races, Limits& limits);

}  // namespace grafverif::timed
