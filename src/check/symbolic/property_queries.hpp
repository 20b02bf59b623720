// SPDX-License-Identifier: MIT
// Property queries: translates the properties of a system to sets of states and evaluates them on the reachable states.
#pragma once

#include <string>
#include <vector>

#include "check/symbolic/paths.hpp"
#include "check/symbolic/symbolic.hpp"

namespace grafverif::symbolic {

/// Result of a search of the reachable states.
struct ReachableSet {
    /// The rings that the search has already computed. A ring is a set of states at the same distance from the initial
    /// states.
    bdd::Rings rings = {};
    Bdd reached = {};
    /// If true, a run is computed for each `reachable` property that holds.
    bool witnesses = true;
    /// Reason why the search ended early; None if all reachable states were found.
    UnknownReason obstacle = UnknownReason::None;
    std::string reason = {};
};

/// Returns a shortest path from an initial state to a state of `goal`. Requires that a state of `goal` is reachable.
/// Computes further rings if necessary.
std::vector<State> shortest_trace(const StateSpace& model, ReachableSet& search, const Bdd& goal);

/// One verdict and the run that demonstrates it.
struct QueryResult {
    Verdict verdict = {};
    std::optional<FlatRun> run = {};
    /// The point of no return: a state from which the states that the property requires are unreachable.
    std::optional<State> dead_state = {};
};

class PropertyQueries {
public:
    PropertyQueries(const TransitionSystem& system, FlatSystem& flat);

    /// Adds a query for a property. All calls of add_query must precede `answers`, because add_query adds terms to the
    /// flat system.
    void add_query(Id<Property> property);
    /// Returns the verdicts, in the order of the calls of add_query(). `model` is null if the check ended before the
    /// model was built; in this case, all verdicts are unknown.
    std::vector<QueryResult> answers(const StateSpace* model, ReachableSet& search, const SymbolicOptions& options);

private:
    struct PropertyQuery {
        Id<Property> about = {};
        /// Operands over the variables of the flat system. For a property with `at stable`, the operands include the
        /// condition of quiescence.
        std::vector<Id<Expr>> operands = {};
    };
    /// The sets of states of a query.
    struct Sets {
        std::vector<Bdd> operands = {};
        bool undefined = false;  ///< true if some operand is undefined in some reachable state
    };

    const Property& of(const PropertyQuery& question) const { return system_.properties[question.about]; }
    Id<Expr> settled_and(const Property& property, Id<Expr> operand);
    Id<Expr> exactly_one(const std::vector<Id<Expr>>& operands);
    QueryResult answer(const PropertyQuery& question, const StateSpace& model, ReachableSet& search);
    void result_state(QueryResult& found, const PropertyQuery& question, const Sets& sets, const StateSpace& model,
                      ReachableSet& search);
    void decide_paths(QueryResult& found, const PropertyQuery& question, const Sets& sets, const StateSpace& model,
                      ReachableSet& search);
    Sets sets(const PropertyQuery& question, const StateSpace& model, ReachableSet& search) const;
    std::string what_is_dead(const StateSpace& model, const ReachableSet& search, const State& from);
    Path lasso(const StateSpace& model, ReachableSet& search, const Bdd& from, const Bdd& staying) const;
    void mark_vacuous(Verdict& verdict, const PropertyQuery& question, const Sets& sets, const StateSpace& model,
                      ReachableSet& search);
    void prepare(const StateSpace& model, ReachableSet& search);

    const TransitionSystem& system_;
    FlatSystem& flat_;
    Id<Expr> settled_ = {};
    std::vector<PropertyQuery> questions_ = {};
    bool prepared_ = false;
    std::vector<Bdd> justice_ = {};
    Bdd fair_ = {};  ///< reachable states from which a fair run starts
};

}  // namespace grafverif::symbolic
