// SPDX-License-Identifier: MIT
// PropertyQueries: decides the properties of a network in a timed check. Before the exploration, the properties are
// compiled to code and to searches of a PropertyMonitor (property_queries.cpp). After the exploration, verdicts.cpp
// computes the verdicts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/timed/explore.hpp"
#include "check/timed/fixpoints.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif::timed {

/// Returns the property `no timelock` for a model that does not declare it. Timed checks also decide this property by
/// default.
Property undeclared_timelock(const Network& network);
/// True if `property` is `no timelock` without `at stable`.
bool about_time(const Property& property);
/// True if `property` states that no race is possible: it is `never` of the flag Network::race, without `at stable`.
bool about_race(const Network& network, const Property& property);

/// Reason of the unknown verdict on `no timelock` if an input abstraction has a cycle of urgent edges.
inline constexpr const char* endless_instants = "the abstraction has a cycle of urgent edges, in which no time passes";
/// True if `options` select `property`.
bool is_selected(const TimedOptions& options, const Property& property);

class PropertyQueries {
public:
    /// `abstracted` is true if the network is an input abstraction.
    PropertyQueries(const Network& network, Machine& machine, PropertyMonitor& monitor, bool abstracted = false);

    void add_query(Id<Property> about, const Property& property);
    /// True if some selected property is `inevitable`, `leads to` or `always possible`; the verdicts on these
    /// properties depend on the edges of the graph, not only on single states.
    bool follow_edges() const;
    /// Returns the verdicts after the exploration. `ended` is the reason why the exploration ended early, or None.
    std::vector<Verdict> answers(Graph& graph, UnknownReason ended, const std::vector<ModelError>& errors,
                                 const Limits& limits);
    /// Returns a state that decides the property of verdict number `verdict`, or nullopt if no such state was found.
    /// The property must be about single states.
    std::optional<std::size_t> state_found(std::size_t verdict) const {
        const std::uint32_t state = monitor_.found(queries_[verdict].search);
        return state == PropertyMonitor::none ? std::nullopt : std::optional<std::size_t>(state);
    }
    /// Returns the value of TimedResult::paths: the path of each verdict.
    std::vector<std::vector<AbstractState>> paths(Graph& graph) const;

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    /// A property for which a verdict is computed.
    struct PropertyQuery {
        Verdict verdict = {};
        const Property* property = nullptr;
        std::size_t search = none;  // index of the monitor search for a state that decides the property or its vacuity
        std::uint32_t p = Program::no, q = Program::no;
        bool at_stable = false;
        std::optional<std::uint32_t> dead_state = {};  // a state from which the states that the property requires are
                                                       // unreachable
    };

    std::uint32_t quiescent_and(const Property& property, Id<Expr> operand);
    std::uint32_t quiescent_but_not(const Property& property, Id<Expr> operand);
    std::uint32_t not_exactly_one(const Property& property);
    void query_step_states(const Property& property, const PropertyQuery& prototype);
    void compile(PropertyQuery& query);

    /// Data that all verdicts of one exploration share.
    struct Outcomes {
        // Reason why no property about all states can get the verdict `holds`; None if the exploration is complete.
        UnknownReason obstacle = UnknownReason::None;
        std::string reason = {};
    };
    void answer(PropertyQuery& query, Graph& graph, const Limits& limits);
    void result_state(PropertyQuery& query, Graph& graph) const;
    void decide_liveness(PropertyQuery& query, Graph& graph, const Limits& limits);
    void decide_deadlock(PropertyQuery& query, Graph& graph, const Limits& limits);
    void decide_timelock(PropertyQuery& query, Graph& graph, const Limits& limits);
    void decide_timelock_of_abstraction(PropertyQuery& query, Graph& graph, const Limits& limits) const;
    void decide_possible(PropertyQuery& query, Graph& graph, const Limits& limits);
    void report_never_again(const PropertyQuery& query, Graph& graph, const Limits& limits, Verdict& verdict) const;
    void holds_unless(PropertyQuery& query, UnknownReason obstacle, const std::string& reason) const;
    void holds_if_dense(PropertyQuery& query, Graph& graph, const std::optional<UncoveredAt>& bound) const;
    void mark_vacuous(PropertyQuery& query, const Graph& graph) const;
    std::optional<StateSet> states_where(PropertyQuery& query, Graph& graph, std::uint32_t predicate,
                                         const Limits& limits) const;
    std::string place_of(Graph& graph, const UncoveredAt& at) const;
    std::string inexact_reason() const;

    const Network& network_;
    Machine& machine_;
    PropertyMonitor& monitor_;
    const bool abstracted_;
    std::optional<std::string> inexact_;
    std::size_t quiescent_search_ = none;
    std::vector<PropertyQuery> queries_ = {};
    Outcomes outcomes_ = {};
};

}  // namespace grafverif::timed
