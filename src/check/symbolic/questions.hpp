// SPDX-License-Identifier: MIT
// Questions: the properties of a system as sets of states, and their evaluation on the reachable states.
#pragma once

#include <string>
#include <vector>

#include "check/symbolic/paths.hpp"
#include "check/symbolic/symbolic.hpp"

namespace grafverif::symbolic {

/// Result of a search of the reachable states.
struct Search {
    bdd::Rings rings = {};  ///< around the initial states, as many as were needed so far
    Bdd reached = {};
    bool witnesses = true;               ///< a run for each `reachable` that holds
    Obstacle obstacle = Obstacle::None;  ///< None: all states were reached
    std::string reason = {};
};

/// A shortest path from an initial state to one of `goal`, of which some are reachable; extends the search if
/// necessary.
std::vector<State> shortest_way(const StateSpace& model, Search& search, const Bdd& goal);

/// One verdict, and the run that shows it.
struct Found {
    Verdict verdict = {};
    std::optional<FlatRun> run = {};
    std::optional<State> lost = {};  ///< a state from which the required states are unreachable
};

class Questions {
public:
    Questions(const TransitionSystem& system, FlatSystem& flat);

    /// Translates a property; must precede answers(), because the terms of `flat` may grow.
    void ask(Id<Property> property);
    /// The verdicts, in the order asked. `model` may be null if the search ended before it was built.
    std::vector<Found> answers(const StateSpace* model, Search& search, const SymbolicOptions& options);

private:
    struct Question {
        Id<Property> about = {};
        std::vector<Id<Expr>> operands = {};  ///< over the variables of the flat system, `at stable` resolved
    };
    /// The sets of states of a query.
    struct Sets {
        std::vector<Bdd> operands = {};
        bool undefined = false;  ///< some operand is undefined in some reachable state
    };

    const Property& of(const Question& question) const { return system_.properties[question.about]; }
    Id<Expr> settled_and(const Property& property, Id<Expr> operand);
    Id<Expr> exactly_one(const std::vector<Id<Expr>>& operands);
    Found answer(const Question& question, const StateSpace& model, Search& search);
    void answer_state(Found& found, const Question& question, const Sets& sets, const StateSpace& model,
                      Search& search);
    void answer_paths(Found& found, const Question& question, const Sets& sets, const StateSpace& model,
                      Search& search);
    Sets sets(const Question& question, const StateSpace& model, Search& search) const;
    std::string what_is_lost(const StateSpace& model, const Search& search, const State& from);
    Path lasso(const StateSpace& model, Search& search, const Bdd& from, const Bdd& staying) const;
    void mark_vacuous(Verdict& verdict, const Question& question, const Sets& sets, const StateSpace& model,
                      Search& search);
    void prepare(const StateSpace& model, Search& search);

    const TransitionSystem& system_;
    FlatSystem& flat_;
    Id<Expr> settled_ = {};
    std::vector<Question> questions_ = {};
    bool prepared_ = false;
    std::vector<Bdd> justice_ = {};
    Bdd fair_ = {};  ///< reachable states from which a fair run starts
};

}  // namespace grafverif::symbolic
