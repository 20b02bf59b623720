// SPDX-License-Identifier: MIT
// Questions: the properties of a network as code and watches before the search, and as verdicts after it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/timed/explore.hpp"
#include "check/timed/fixpoints.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif::timed {

/// `no timelock`, which every timed check decides, for models that do not declare it.
Property undeclared_timelock(const Network& network);
/// Whether `property` is `no timelock` of all states.
bool about_time(const Property& property);
/// Whether `options` ask for `property`.
bool asked(const TimedOptions& options, const Property& property);

class Questions {
public:
    Questions(const Network& network, Machine& machine, Watch& watch);

    void ask(Id<Property> about, const Property& property);
    /// Whether some property asked goes along the edges of many states.
    bool follow_edges() const;
    /// The verdicts, after a search that `ended`.
    std::vector<Verdict> answers(Graph& graph, Obstacle ended, const std::vector<ModelError>& errors,
                                 const Limits& limits);
    /// True if the search has met the state that decides a property about single states; in the order of the verdicts.
    bool shown(std::size_t verdict) const { return watch_.found(questions_[verdict].watch) != Watch::none; }
    /// Per verdict what TimedResult::paths has.
    std::vector<std::vector<AbstractState>> paths(Graph& graph) const;

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    /// One verdict to give.
    struct Question {
        Verdict verdict = {};
        const Property* property = nullptr;
        std::size_t watch = none;  // the state that decides it, or that keeps it from being vacuous
        std::uint32_t p = Program::no, q = Program::no;
        bool at_stable = false;
        std::optional<std::uint32_t> lost = {};  // a state from which what is asked is impossible
    };

    std::uint32_t settled_and(const Property& property, Id<Expr> operand);
    std::uint32_t settled_but_not(const Property& property, Id<Expr> operand);
    std::uint32_t not_exactly_one(const Property& property);
    void ask_steps(const Property& property, const Question& prototype);
    void compile(Question& question);

    /// What is the same for all verdicts of one search.
    struct Outcomes {
        Obstacle obstacle = Obstacle::None;  // against `holds` of what is about all states
        std::string reason = {};
    };
    void answer(Question& question, Graph& graph, const Limits& limits);
    void answer_state(Question& question, Graph& graph) const;
    void answer_liveness(Question& question, Graph& graph, const Limits& limits);
    void answer_deadlock(Question& question, Graph& graph, const Limits& limits);
    void answer_timelock(Question& question, Graph& graph, const Limits& limits);
    void answer_possible(Question& question, Graph& graph, const Limits& limits);
    void tell_lost(const Question& question, Graph& graph, const Limits& limits, Verdict& verdict) const;
    void holds_unless(Question& question, Obstacle obstacle, const std::string& reason) const;
    void holds_if_dense(Question& question, Graph& graph, const std::optional<UncoveredAt>& bound) const;
    void mark_vacuous(Question& question, const Graph& graph) const;
    std::optional<StateSet> states_where(Question& question, Graph& graph, std::uint32_t predicate,
                                         const Limits& limits) const;
    std::string place_of(Graph& graph, const UncoveredAt& at) const;
    std::string inexact_reason() const;

    const Network& network_;
    Machine& machine_;
    Watch& watch_;
    std::optional<std::string> inexact_;
    std::size_t settled_watch_ = none;
    std::vector<Question> questions_ = {};
    Outcomes outcomes_ = {};
};

}  // namespace grafverif::timed
