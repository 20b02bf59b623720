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

/// `no timelock` for models that do not declare it; timed checks decide it by default.
Property undeclared_timelock(const Network& network);
/// True if `property` is `no timelock` of all states.
bool about_time(const Property& property);
/// True if `options` select `property`.
bool asked(const TimedOptions& options, const Property& property);

class Questions {
public:
    Questions(const Network& network, Machine& machine, Watch& watch);

    void ask(Id<Property> about, const Property& property);
    /// True if some selected property needs the edges of many states.
    bool follow_edges() const;
    /// The verdicts, after a search that `ended`.
    std::vector<Verdict> answers(Graph& graph, Obstacle ended, const std::vector<ModelError>& errors,
                                 const Limits& limits);
    /// True if the search has found the state that decides a property about single states; in the order of the
    /// verdicts.
    bool shown(std::size_t verdict) const { return watch_.found(questions_[verdict].watch) != Watch::none; }
    /// Per verdict the content of TimedResult::paths.
    std::vector<std::vector<AbstractState>> paths(Graph& graph) const;

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    /// One verdict to give.
    struct Question {
        Verdict verdict = {};
        const Property* property = nullptr;
        std::size_t watch = none;  // the state that decides it, or that shows that it is not vacuous
        std::uint32_t p = Program::no, q = Program::no;
        bool at_stable = false;
        std::optional<std::uint32_t> lost = {};  // a state from which the required states are unreachable
    };

    std::uint32_t settled_and(const Property& property, Id<Expr> operand);
    std::uint32_t settled_but_not(const Property& property, Id<Expr> operand);
    std::uint32_t not_exactly_one(const Property& property);
    void ask_steps(const Property& property, const Question& prototype);
    void compile(Question& question);

    /// Data shared by all verdicts of one search.
    struct Outcomes {
        Obstacle obstacle = Obstacle::None;  // prevents `holds` of properties about all states
        std::string reason = {};
    };
    void answer(Question& question, Graph& graph, const Limits& limits);
    void answer_state(Question& question, Graph& graph) const;
    void answer_liveness(Question& question, Graph& graph, const Limits& limits);
    void answer_deadlock(Question& question, Graph& graph, const Limits& limits);
    void answer_timelock(Question& question, Graph& graph, const Limits& limits);
    void answer_timelock_of_choices(Question& question, Graph& graph, const Limits& limits) const;
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
