// SPDX-License-Identifier: MIT
// Check: checks the properties of one system with the symbolic engine. The object owns the space of decision diagrams,
// the model and the verdicts. After a call of `result`, the object can answer further queries about the state space.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "check/symbolic/property_queries.hpp"
#include "check/symbolic/symbolic.hpp"

namespace grafverif::symbolic {

class Check {
public:
    /// Both arguments must outlive the object.
    Check(const TransitionSystem& system, const SymbolicOptions& options);
    Check(const Check&) = delete;
    Check& operator=(const Check&) = delete;

    /// Searches the states and decides the queries. This function must be called exactly once, before all other
    /// functions of this class.
    SymbolicResult result();

    /// True if all reachable states were found, and the search found no fault of the system.
    bool complete() const { return search_.obstacle == UnknownReason::None; }
    std::uint64_t bytes() const { return space_.bytes(); }
    const FlatSystem& flat() const { return flat_; }
    /// Returns the run of each verdict.
    const std::vector<std::optional<FlatRun>>& runs() const { return runs_; }
    /// Returns the state space. Requires complete().
    const StateSpace& model() const { return *model_; }
    const Bdd& reached() const { return search_.reached; }
    ReachableSet& search_made() { return search_; }
    /// Returns a term over the main module as a function of states and choices. Requires that the term has a value in
    /// every state.
    Bdd meaning(const TransitionSystem& system, Id<Expr> term);

private:
    double seconds() const;
    void note(const BddExhausted& exhausted);
    void count_states();
    void search();
    std::optional<SystemFault> fault();
    void answer();

    const SymbolicOptions& options_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    FlatSystem flat_;
    BddSpace space_;
    PropertyQueries questions_;
    std::optional<StateSpace> model_ = {};
    ReachableSet search_ = {};
    SymbolicResult result_ = {};
    std::vector<std::optional<FlatRun>> runs_ = {};
};

}  // namespace grafverif::symbolic
