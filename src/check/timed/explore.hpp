// SPDX-License-Identifier: MIT
// Exploration of the timed engine: finds all reachable states by a breadth-first search.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "check/timed/graph.hpp"
#include "check/timed/machine.hpp"
#include "check/timed/property_monitor.hpp"
#include "check/timed/timed.hpp"
#include "support/thread_pool.hpp"

namespace grafverif::timed {

/// The limits, the threads and the progress report of one check.
class Limits {
public:
    explicit Limits(const TimedOptions& options)
        : options_(options), start_(std::chrono::steady_clock::now()), team_(options.jobs) {}

    ThreadPool& team() const { return team_; }
    std::uint32_t slice() const { return options_.slice; }
    /// Returns the number of parts into which `share_states` divides work on `states` states. The result is 1 if the
    /// number of states is too small for parallel work.
    std::size_t parts(std::size_t states) const { return states < std::size_t{1024} * slice() ? 1 : team_.size(); }
    /// Calls `work(part)` for each part, in parallel.
    template <class Work>
    void share(std::size_t parts, const Work& work) const {
        if (parts == 1) return work(0);
        team_.share([&](unsigned member) {
            for (std::size_t part = member; part < parts; part += team_.size()) work(part);
        });
    }

    /// Calls `work(begin, end)` in parallel for ranges that partition the states. Different ranges do not share a word
    /// of a StateSet.
    template <class Work>
    void share_states(std::size_t states, const Work& work) const {
        const std::size_t parts = this->parts(states);
        const auto begin = [&](std::size_t part) { return part == parts ? states : states * part / parts / 64 * 64; };
        share(parts, [&](std::size_t part) { work(begin(part), begin(part + 1)); });
    }

    double seconds() const;
    /// True if the user has stopped the check or the deadline has passed.
    bool stopped() const;
    /// Exception that `poll` throws if the check must end. Loops over states that do not belong to the exploration call
    /// `poll`.
    struct Stop {};
    static constexpr std::size_t poll_interval = 65536;  ///< number of states between two polls
    void poll() const {
        if (++polls_ % poll_interval == 0 && stopped()) throw Stop{};
    }
    /// Returns the reason why the search must end, or None. Reports progress periodically. `more` is the number of
    /// bytes that the search uses in addition to the memory of the graph.
    UnknownReason stop_reason(const Graph& graph, std::uint32_t state, std::size_t more);
    /// Computes a profile of the states that have been found, if their number is large and the options request a
    /// profile. The function computes at most one profile.
    void explain(Graph& graph);
    bool too_many(const Graph& graph) const {
        return graph.states() >= options_.max_states || graph.states() >= Store::most ||
               graph.transitions >= options_.max_transitions;
    }
    bool until_decided() const { return options_.until_decided; }
    bool ignores_depth() const { return options_.covering_without.depth; }
    std::uint64_t max_memory() const { return options_.max_memory; }
    /// Requires that the search ended because of memory. True if the memory limit was reached, false if an allocation
    /// failed.
    bool allowed_used() const { return allowed_used_; }

private:
    const TimedOptions& options_;
    std::chrono::steady_clock::time_point start_;
    double shown_ = 0;
    bool allowed_used_ = false;
    bool explained_ = false;
    mutable std::uint32_t polls_ = 0;
    mutable ThreadPool team_;
};

/// Adds all reachable states to `graph`, beginning with the initial state. Returns the reason why the search ended
/// early, or None. States in which a bit of `races` is set are stored but not expanded.
UnknownReason explore(Graph& graph, PropertyMonitor& monitor, const std::vector<Field>& races, Limits& limits);

}  // namespace grafverif::timed
