// SPDX-License-Identifier: MIT
// The reference semantics of a Network in integer time, directly from CEP13 section 2 (equations (9) and (10)). The
// target invariant of urgent edges is tested after their resets (ETFA12 section 2). Small and slow: it evaluates terms
// and tests every edge. Engines, emitters and library components are compared with it.
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
    std::vector<std::uint32_t> locations = {};  ///< per process
    std::vector<std::int64_t> variables = {};   ///< scratch variables are 0
    std::vector<std::int64_t> clocks = {};      ///< of every process in order, limited to the largest constant plus one

    auto operator<=>(const TaddState&) const = default;
};

/// One step: an edge of a process, or one unit of time (`process` is not valid then).
struct TaddMove {
    Id<Network::Process> process = {};
    Id<Network::Edge> edge = {};
    TaddState next = {};
    bool out_of_range = false;  ///< a value left its range or is undefined: a model error; `next` is invalid then

    bool delay() const { return !process.valid(); }
};

class NaiveTadd {
public:
    explicit NaiveTadd(const Network& network);

    TaddState initial() const;
    /// Every enabled edge, in order, then the delay if time can pass.
    std::vector<TaddMove> successors(const TaddState& state) const;
    bool urgent_enabled(const TaddState& state) const;
    bool holds(Id<Expr> formula, const TaddState& state) const {
        return value(formula, state, nullptr).value_or(0) != 0;
    }
    bool settled(const TaddState& state) const { return holds(network_.settled, state); }

    /// By name.
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
    std::vector<std::size_t> first_clock_ = {};  // per process
    std::size_t clocks_ = 0;
    std::int64_t cap_ = 0;
    std::vector<std::vector<std::vector<Id<Network::Edge>>>> leaving_ = {};  // per template and location
};

/// All reachable states; stops after `limit` states.
struct Reachable {
    std::set<TaddState> states = {};
    bool complete = false;
    bool out_of_range = false;
};
Reachable reachable(const Network& network, std::size_t limit);

/// A network under test: the test sets inputs and lets time pass. Keeps every possible state, so that free choices
/// appear as several values.
class Bench {
public:
    explicit Bench(Network network);

    /// Writes an input, then executes all events of this instant.
    void set(const std::string& variable, std::int64_t value);
    /// Lets time pass, unit by unit. No values remain if time cannot pass.
    void wait(std::int64_t units);
    std::set<std::int64_t> values(const std::string& variable) const;
    std::set<std::string> locations(const std::string& process) const;
    const std::set<TaddState>& states() const { return states_; }

private:
    void rest();  ///< takes edges until time can pass; drops states in which time cannot pass

    Network network_;
    NaiveTadd tadd_;
    std::set<TaddState> states_ = {};
};

/// The plant of one instance of `component`, named `it`. Its parameters become variables of the same names; constants
/// are given or have their defaults. The time unit is the greatest common divisor of its durations.
Network lone_component(const Component& component, const std::map<std::string, std::int64_t>& constants = {},
                       const std::string& initially = "");

}  // namespace grafverif
