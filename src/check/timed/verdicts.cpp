// SPDX-License-Identifier: MIT
// Computes the verdicts from the results of an exploration. One run of integer time, which is also a run of dense time,
// suffices to show that a property is violated. A proof that a property holds must consider all runs. Therefore, a
// proof requires a complete exploration, a model without errors, and that integer time gives the same verdict as dense
// time.
#include <algorithm>
#include <atomic>
#include <new>

#include "check/timed/components.hpp"
#include "check/timed/dead_transitions.hpp"
#include "check/timed/property_queries.hpp"
#include "ir/network_run.hpp"
#include "ir/patterns.hpp"
#include "run/network_walk.hpp"
#include "support/overloaded.hpp"

namespace grafverif::timed {

namespace {

void violated(Verdict& verdict, Run run) {
    verdict.outcome = Outcome::Violated;
    verdict.run = std::move(run);
}

std::string text_of(UnknownReason ended, const Graph& graph, const Limits& limits) {
    const std::string states = std::to_string(graph.states()) + " states";
    if (ended == UnknownReason::Bound) return "state limit reached: " + states;
    if (ended == UnknownReason::Memory && !limits.allowed_used()) return "out of memory after " + states;
    if (ended == UnknownReason::Memory) return memory_limit_reached(limits.max_memory()) + " after " + states;
    return graph.states() > 1 ? "stopped after " + states : "stopped before the exploration";
}

/// Returns the expanded states for which `is(kind)` is true.
template <class Is>
StateSet states_of_kind(const Graph& graph, const Limits& limits, const Is& is) {
    StateSet set(graph.states());
    limits.share_states(graph.explored, [&](std::size_t begin, std::size_t end) {
        for (auto state = static_cast<std::uint32_t>(begin); state != end; ++state)
            if (is(graph.kind(state))) set.add(state);
    });
    return set;
}

/// Returns a run to `state`, which continues by edges without delay. Requires that time cannot pass in any state that
/// is reachable from `state`. The continuation uses only edges of processes that block the delay (see
/// continue_without_delay), because edges of other processes do not explain the timelock.
Run without_time(Graph& graph, std::uint32_t state) {
    Run run = graph.run_to(state);
    if (auto states = replay(graph.machine.network(), run))
        continue_without_delay(graph.machine.network(), run, *states);
    return run;
}

}  // namespace

std::vector<Verdict> PropertyQueries::answers(Graph& graph, UnknownReason ended, const std::vector<ModelError>& errors,
                                              const Limits& limits) {
    if (ended == UnknownReason::Unsupported)
        outcomes_ = {ended, "the states of this model are too large for the timed engine"};
    else if (ended != UnknownReason::None) outcomes_ = {ended, text_of(ended, graph, limits)};
    else if (!errors.empty()) outcomes_ = {UnknownReason::Faulty, "model error: " + text_of(network_, errors.front())};
    else if (inexact_) outcomes_ = {UnknownReason::Inexact, inexact_reason()};
    std::vector<Verdict> verdicts;
    for (PropertyQuery& query : queries_) {
        try {
            if (query.verdict.obstacle == UnknownReason::None && graph.states() == 0)
                set_unknown(query.verdict, ended, outcomes_.reason);
            if (query.verdict.obstacle == UnknownReason::None) answer(query, graph, limits);
        } catch (const Limits::Stop&) {
            set_unknown(query.verdict, UnknownReason::Stopped, "stopped");
        } catch (const std::bad_alloc&) {
            set_unknown(query.verdict, UnknownReason::Memory, "no memory is left to evaluate the explored states");
        }
        if (query.verdict.outcome == Outcome::Holds) mark_vacuous(query, graph);
        verdicts.push_back(std::move(query.verdict));
    }
    // Explanations are computed after all verdicts, because an explanation may need time or memory that a verdict also
    // needs.
    for (std::size_t k = 0; k < queries_.size(); ++k) report_never_again(queries_[k], graph, limits, verdicts[k]);
    return verdicts;
}

std::vector<std::vector<AbstractState>> PropertyQueries::paths(Graph& graph) const {
    std::vector<std::vector<AbstractState>> found;
    for (const PropertyQuery& query : queries_) {
        const Pattern pattern = query.property->pattern;
        const bool single = is_about_states(pattern);
        const std::uint32_t state =
            single && query.search != none ? monitor_.found(query.search) : PropertyMonitor::none;
        found.push_back(state == PropertyMonitor::none ? std::vector<AbstractState>{}
                                                       : graph.states_along(graph.path_to(state)));
    }
    return found;
}

std::string PropertyQueries::inexact_reason() const { return "integer time is not exact for " + inexact_.value_or(""); }

void PropertyQueries::answer(PropertyQuery& query, Graph& graph, const Limits& limits) {
    switch (query.property->pattern) {
    case Pattern::Always:
    case Pattern::Never:
    case Pattern::ExactlyOneOf:
    case Pattern::Reachable:
    case Pattern::ReachableAllSteps: return result_state(query, graph);
    case Pattern::Inevitable:
    case Pattern::LeadsTo: return decide_liveness(query, graph, limits);
    case Pattern::NoDeadlock: return decide_deadlock(query, graph, limits);
    case Pattern::NoTimelock: return decide_timelock(query, graph, limits);
    case Pattern::AlwaysPossible: return decide_possible(query, graph, limits);
    case Pattern::RawUppaal:
    case Pattern::RawCtl:
    case Pattern::Watched:
    case Pattern::RawLtl: break;
    }
    unreachable();
}

void PropertyQueries::holds_unless(PropertyQuery& query, UnknownReason obstacle, const std::string& reason) const {
    if (obstacle == UnknownReason::None) query.verdict.outcome = Outcome::Holds;
    else set_unknown(query.verdict, obstacle, reason);
}

void PropertyQueries::result_state(PropertyQuery& query, Graph& graph) const {
    const std::uint32_t state = monitor_.found(query.search);
    const Pattern pattern = query.property->pattern;
    const bool wanted = is_about_existence(pattern);
    if (state != PropertyMonitor::none) {
        violated(query.verdict, graph.run_to(state));
        if (wanted) query.verdict.outcome = Outcome::Holds;
        return;
    }
    if (monitor_.broken(query.search))
        return set_unknown(query.verdict, UnknownReason::Faulty,
                           "an operand of the property divides by zero in some reachable state");
    holds_unless(query, outcomes_.obstacle, outcomes_.reason);
    if (wanted && query.verdict.outcome == Outcome::Holds) query.verdict.outcome = Outcome::Violated;
}

/// Returns the states that satisfy `predicate`. If `predicate` is undefined in some state, returns nullopt and makes
/// the verdict unknown.
std::optional<StateSet> PropertyQueries::states_where(PropertyQuery& query, Graph& graph, std::uint32_t predicate,
                                                      const Limits& limits) const {
    StateSet set(graph.states());
    std::atomic<bool> broken = false;
    limits.share_states(graph.states(), [&](std::size_t begin, std::size_t end) {
        Unfolded now;
        std::vector<std::int64_t> registers;
        for (std::size_t i = begin; i != end && !broken; ++i) {
            if (i % Limits::poll_interval == 0 && limits.stopped()) throw Limits::Stop{};
            const auto state = static_cast<std::uint32_t>(i);
            graph.store.load(state, now);
            const End found = graph.machine.holds(predicate, now.words.data(), registers);
            if (found == End::Yes) set.add(state);
            if (found == End::NoValue) broken = true;
        }
    });
    if (!broken) return set;
    set_unknown(query.verdict, UnknownReason::Faulty,
                "an operand of the property divides by zero in some reachable state");
    return {};
}

void PropertyQueries::decide_liveness(PropertyQuery& query, Graph& graph, const Limits& limits) {
    if (outcomes_.obstacle == UnknownReason::Stopped)
        return set_unknown(query.verdict, UnknownReason::Stopped, outcomes_.reason);
    std::optional<StateSet> met = states_where(query, graph, query.q, limits);
    if (!met) return;
    std::vector<std::uint32_t> roots;
    if (query.property->pattern == Pattern::Inevitable) {
        if (!met->has(0)) roots.push_back(0);
    } else {
        const std::optional<StateSet> requested = states_where(query, graph, query.p, limits);
        if (!requested) return;
        for (std::uint32_t state = 0; state < graph.states(); ++state)
            if (!met->has(state) && requested->has(state)) roots.push_back(state);
    }
    const std::optional<bool> holds = unavoidable(graph, *met, roots, limits);
    if (!holds) return set_unknown(query.verdict, UnknownReason::Stopped, "stopped");
    if (*holds) return holds_if_dense(query, graph, graph.stuck_bound);
    std::erase_if(roots, [&](std::uint32_t root) { return met->has(root); });
    // If integer time is inexact, a state without successors is not a counterexample: although a strict bound prevents
    // a delay of one unit, a shorter delay may be possible in dense time.
    const Lasso lasso = avoiding(graph, *met, roots, inexact_.has_value(), limits);
    if (lasso.path.empty()) return set_unknown(query.verdict, UnknownReason::Inexact, inexact_reason());
    violated(query.verdict, graph.run_along(lasso.path, lasso.loop));
}

void PropertyQueries::decide_deadlock(PropertyQuery& query, Graph& graph, const Limits& limits) {
    const auto considered = [&](std::uint32_t state) { return graph.holds(query.p, state) == End::Yes; };
    const std::optional<std::uint32_t> state = first_deadlock(graph, considered, limits);
    if (state && inexact_) return set_unknown(query.verdict, UnknownReason::Inexact, inexact_reason());
    if (state) return violated(query.verdict, graph.run_to(*state));
    holds_if_dense(query, graph, graph.stuck_bound);
}

/// Decides `no timelock` for an input abstraction. For all choices of input values, each sequence of urgent edges must
/// lead to a state in which time passes (ir/network_inputs.hpp). It is not sufficient that a state in which time passes
/// is reachable for some choices.
void PropertyQueries::decide_timelock_of_abstraction(PropertyQuery& query, Graph& graph, const Limits& limits) const {
    holds_if_dense(query, graph, graph.locked_bound);
    if (query.verdict.outcome != Outcome::Holds) return;
    std::vector<std::uint32_t> successors;
    Components components(graph.states(), limits, [&](std::uint32_t state, const auto& take) {
        if (graph.kind(state) != StateKind::Urgent) return;
        graph.urgent_successors(state, successors);
        for (const std::uint32_t next : successors) take(next);
    });
    for (std::uint32_t state = 0; state < graph.states(); ++state) components.visit(state);
    if (components.any_cycle()) set_unknown(query.verdict, UnknownReason::Inexact, endless_instants);
}

void PropertyQueries::decide_timelock(PropertyQuery& query, Graph& graph, const Limits& limits) {
    if (outcomes_.obstacle == UnknownReason::Stopped)
        return set_unknown(query.verdict, UnknownReason::Stopped, outcomes_.reason);
    if (abstracted_) return decide_timelock_of_abstraction(query, graph, limits);
    StateSet passes = states_of_kind(
        graph, limits, [](StateKind kind) { return kind == StateKind::Passes || kind == StateKind::PassesOrActs; });
    auto locked = out_of_reach(graph, passes, Transitions::Actions, limits);
    if (!locked) return set_unknown(query.verdict, UnknownReason::Stopped, "stopped");
    std::erase_if(*locked, [&](std::uint32_t state) { return graph.holds(query.p, state) != End::Yes; });
    if (!locked->empty()) {
        if (inexact_) return set_unknown(query.verdict, UnknownReason::Inexact, inexact_reason());
        return violated(query.verdict, without_time(graph, locked->front()));
    }
    holds_if_dense(query, graph, graph.locked_bound);
    if (query.verdict.outcome != Outcome::Holds) return;
    StateSet calm = states_of_kind(graph, limits, [](StateKind kind) { return kind != StateKind::Urgent; });
    const auto restless = out_of_reach(graph, calm, Transitions::UrgentActions, limits);
    if (!restless) return set_unknown(query.verdict, UnknownReason::Stopped, "stopped");
    if (!restless->empty())
        set_unknown(query.verdict, UnknownReason::Inexact,
                    "from some state, urgent edges alone do not lead to a state in which time may pass");
}

void PropertyQueries::decide_possible(PropertyQuery& query, Graph& graph, const Limits& limits) {
    if (outcomes_.obstacle == UnknownReason::Stopped)
        return set_unknown(query.verdict, UnknownReason::Stopped, outcomes_.reason);
    std::optional<StateSet> goal = states_where(query, graph, query.p, limits);
    if (!goal) return;
    const auto dead_states = out_of_reach(graph, *goal, Transitions::All, limits);
    if (!dead_states) return set_unknown(query.verdict, UnknownReason::Stopped, "stopped");
    if (!dead_states->empty() && inexact_) return set_unknown(query.verdict, UnknownReason::Inexact, inexact_reason());
    if (!dead_states->empty()) {
        query.dead_state = dead_states->front();
        return violated(query.verdict, graph.run_to(dead_states->front()));
    }
    holds_unless(query, outcomes_.obstacle, outcomes_.reason);
    if (query.verdict.outcome == Outcome::Holds && machine_.timed())
        set_unknown(query.verdict, UnknownReason::Inexact,
                    "integer time does not cover the states between two ticks; use `--untimed` to decide the property "
                    "for the untimed model");
}

/// Adds the note on dead transitions to a violated property. Omits the note if its computation exceeds the time or
/// memory limit.
void PropertyQueries::report_never_again(const PropertyQuery& query, Graph& graph, const Limits& limits,
                                         Verdict& verdict) const {
    if (!query.dead_state || verdict.outcome != Outcome::Violated || outcomes_.obstacle != UnknownReason::None) return;
    try {
        if (std::string words = dead_transitions_note(graph, *query.dead_state, limits); !words.empty())
            verdict.notes.push_back(std::move(words));
    } catch (const Limits::Stop&) {
        return;
    } catch (const std::bad_alloc&) {
        return;
    }
}

void PropertyQueries::holds_if_dense(PropertyQuery& query, Graph& graph,
                                     const std::optional<UncoveredAt>& bound) const {
    if (outcomes_.obstacle != UnknownReason::None || !bound)
        return holds_unless(query, outcomes_.obstacle, outcomes_.reason);
    set_unknown(query.verdict, UnknownReason::Inexact,
                "a timelock is possible between two ticks at " + place_of(graph, *bound));
}

std::string PropertyQueries::place_of(Graph& graph, const UncoveredAt& at) const {
    const Network::Process& process = network_.processes[{at.bound.process}];
    const Network::Template& automaton = network_.templates[process.automaton];
    const auto location = machine_.layout().locations[at.bound.process].get(graph.load(at.state));
    const Network::Location& place = automaton.locations[{static_cast<std::uint32_t>(location)}];
    const Network::ClockConstraint& bound = place.invariant[at.bound.bound];
    const std::string clock = automaton.clocks[bound.clock].name;
    return "`" + process.name + "." + place.name + "`: no edge that waits only for `" + clock +
           "` can leave the location at `" + clock + " == " + std::to_string(admitted(network_, bound).high) + "`";
}

void PropertyQueries::mark_vacuous(PropertyQuery& query, const Graph& graph) const {
    Verdict& verdict = query.verdict;
    const Pattern pattern = query.property->pattern;
    const auto vacuous = [&](const char* why) {
        verdict.vacuous = true;
        verdict.notes.emplace_back(why);
    };
    if (is_about_existence(pattern) || pattern == Pattern::NoTimelock) return;
    if (!graph.time_passes) vacuous("time does not pass in this model");
    if (is_declared_response(*query.property) && monitor_.found(query.search) == PropertyMonitor::none)
        vacuous("the premise is never true");
    if (is_about_all_states(pattern) && query.at_stable && monitor_.found(quiescent_search_) == PropertyMonitor::none)
        vacuous("no state is quiescent");
}

}  // namespace grafverif::timed
