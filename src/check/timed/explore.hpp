// SPDX-License-Identifier: MIT
// The search: every reachable state, breadth first.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "check/timed/graph.hpp"
#include "check/timed/machine.hpp"
#include "check/timed/timed.hpp"

namespace grafverif::timed {

// Watch: what the search looks for in single states, all properties at once. A watch is over when it has found its
// state, so that what is decided costs no more.

class Watch {
public:
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    /// Looks for a state where `predicate` ends in Yes. Returns the number of the watch.
    std::size_t add(std::uint32_t predicate);
    /// Looks for a state where the bit of a variable is set, and `settled` holds if it is not Program::yes.
    std::size_t add_bit(const Field& bit, std::uint32_t settled);

    /// A new state.
    void look(Machine& machine, std::uint32_t state, const Word* words) {
        if (!predicates_.empty() || !bits_.empty()) look_closely(machine, state, words);
    }
    /// The first state found, or none.
    std::uint32_t found(std::size_t watch) const { return results_[watch].state; }
    /// The predicate had no value in some state.
    bool broken(std::size_t watch) const { return results_[watch].broken; }

private:
    struct Result {
        std::uint32_t state = none;
        bool broken = false;
    };
    struct Predicate {
        std::uint32_t code = 0;
        std::size_t watch = 0;
    };
    struct Bit {
        Word mask = 0;
        std::size_t watch = 0;
    };
    struct Bits {  // of one word, under one condition
        std::uint16_t word = 0;
        std::uint32_t settled = 0;
        Word missing = 0;
        std::vector<Bit> each = {};
    };

    void look_closely(Machine& machine, std::uint32_t state, const Word* words);

    std::vector<Predicate> predicates_ = {};
    std::vector<Bits> bits_ = {};
    std::vector<Result> results_ = {};
};

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
    /// Explains the states found, once, where there are many and somebody asks.
    void explain(Graph& graph);
    bool too_many(std::size_t states) const { return states >= options_.max_states || states >= Store::most; }
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
};

/// Fills `graph` from the initial state; returns what ended it early, or None. States in which the `race` bit is set are
/// found but not left.
Obstacle explore(Graph& graph, Watch& watch, const std::vector<Field>& races, Limits& limits);

}  // namespace grafverif::timed
