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
    bdd::Rings rings = {};  ///< rings around the initial states that were computed so far
    Bdd reached = {};
    bool witnesses = true;                         ///< true: find a run for each `reachable` that holds
    UnknownReason obstacle = UnknownReason::None;  ///< reason why the search ended; None if all states were reached
    std::string reason = {};
};

/// Returns a shortest path from an initial state to a state of `goal`. Requires that a state of `goal` is reachable.
/// Extends the search if necessary.
std::vector<State> shortest_trace(const StateSpace& model, ReachableSet& search, const Bdd& goal);

/// One verdict and the run that shows it.
struct QueryResult {
    Verdict verdict = {};
    std::optional<FlatRun> run = {};
    std::optional<State> dead_state = {};  ///< a state from which the states required by the property are unreachable
};

class PropertyQueries {
public:
    PropertyQueries(const TransitionSystem& system, FlatSystem& flat);

    /// Translates a property. All calls must precede answers(), because the function adds terms to `flat`.
    void add_query(Id<Property> property);
    /// Returns the verdicts, in the order of the calls of add_query(). `model` may be null if the search ended before
    /// it was built.
    std::vector<QueryResult> answers(const StateSpace* model, ReachableSet& search, const SymbolicOptions& options);

private:
    struct PropertyQuery {
        Id<Property> about = {};
        /// Operands over the variables of the flat system, with `at stable` included.
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
