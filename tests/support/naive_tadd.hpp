// SPDX-License-Identifier: MIT
// The reference semantics of a Network in integer time, taken directly from the paper CEP13, section 2, equations (9)
// and (10) (docs/explanation/method.md). The target invariant of urgent edges is tested after their resets (ETFA12
// section 2). The implementation is small and slow: it evaluates terms and tests every edge. Tests compare engines,
// emitters and library components with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/network.hpp"

namespace grafverif {

struct TaddState {
    std::vector<std::uint32_t> locations = {};  ///< indexed by process
    std::vector<std::int64_t> variables = {};   ///< scratch variables are 0

    /// Indexed by the clocks of all processes in order; limited to the largest constant plus one.
    std::vector<std::int64_t> clocks = {};

    auto operator<=>(const TaddState&) const = default;
};

/// One step: an edge of a process, or one unit of time, for which `process` is not valid.
struct TaddMove {
    Id<Network::Process> process = {};
    Id<Network::Edge> edge = {};
    TaddState next = {};
    /// A value left its range or is undefined, which is a model error; `next` is then invalid.
    bool out_of_range = false;

    bool delay() const { return !process.valid(); }
};

class NaiveTadd {
public:
    explicit NaiveTadd(const Network& network);

    TaddState initial() const;
    /// Returns every enabled edge in order, and then the delay if time can pass.
    std::vector<TaddMove> successors(const TaddState& state) const;
    bool urgent_enabled(const TaddState& state) const;
    bool holds(Id<Expr> formula, const TaddState& state) const {
        return value(formula, state, nullptr).value_or(0) != 0;
    }
    bool settled(const TaddState& state) const { return holds(network_.settled, state); }

    /// Returns the value of the variable `name`.
    std::int64_t variable(const TaddState& state, const std::string& name) const;
    Id<Network::Variable> variable_id(const std::string& name) const;
    std::string location(const TaddState& state, const std::string& process) const;
    const Network& network() const { return network_; }

private:
    std::optional<std::int64_t> value(Id<Expr> root, const TaddState& state, const Network::Process* process) const;
    bool satisfied(const std::vector<Network::ClockConstraint>& constraints, Id<Network::Process> process,
                   const TaddState& state) const;
    bool invariants_hold(const TaddState& state) const;
    bool guard_holds(Id<Network::Process> process, const Network::Edge& edge, const TaddState& state) const;
    bool assign(const std::vector<Network::Assignment>& assignments, const Network::Process& process,
                TaddState& state) const;
    std::optional<TaddMove> fire(Id<Network::Process> process, Id<Network::Edge> edge, const TaddState& state) const;

    const Network& network_;
    std::vector<std::size_t> first_clock_ = {};  // indexed by process
    std::size_t clocks_ = 0;
    std::int64_t cap_ = 0;
    std::vector<std::vector<std::vector<Id<Network::Edge>>>> leaving_ = {};  // indexed by template and location
};

/// Reachable states of a network.
struct Reachable {
    std::set<TaddState> states = {};
    bool complete = false;  ///< true if the set contains all reachable states
    bool out_of_range = false;
};
/// Returns the reachable states. The search ends when it has found `limit` states.
Reachable reachable(const Network& network, std::size_t limit);

/// A network under test: the test sets inputs and lets time pass. The object stores every possible state, so that a
/// variable may have several values after a free choice.
class Bench {
public:
    explicit Bench(Network network);

    /// Writes an input, and then executes all events of this instant.
    void set(const std::string& variable, std::int64_t value);
    /// Lets time pass, one unit after another. No state remains if time cannot pass.
    void wait(std::int64_t units);
    std::set<std::int64_t> values(const std::string& variable) const;
    std::set<std::string> locations(const std::string& process) const;
    const std::set<TaddState>& states() const { return states_; }

private:
    void rest();  ///< Takes edges until time can pass, and discards the states in which time cannot pass.

    Network network_;
    NaiveTadd tadd_;
    std::set<TaddState> states_ = {};
};

/// Returns the plant of one instance of `component`, named `it`. The parameters of the component become variables of
/// the same names, and its constants have the given values or their defaults. The time unit is the greatest common
/// divisor of the durations.
Network lone_component(const Component& component, const std::map<std::string, std::int64_t>& constants = {},
                       const std::string& initially = "");

}  // namespace grafverif
