// SPDX-License-Identifier: MIT
#include "check/inputs/process_states.hpp"

#include <set>

#include "ir/junction.hpp"
#include "ir/network/variables.hpp"

namespace grafverif {

namespace {

// Maximum number of joint values (valuations) of the variables that a process reads and other processes write.
constexpr std::size_t most_valuations = 4096;
constexpr std::size_t most_moves = 1U << 20U;  // maximum number of moves of a process, summed over all valuations

}  // namespace

ProcessStates::ProcessStates(const Network& network, const VariableUsers& users, const ProcessClocks& clocks,
                             Id<Network::Process> id, const timed::Limits& limits)
    : limits_(limits), network_(network), users_(users), id_(id), slots_(network, id) {
    for (const Id<Network::Variable> variable : slots_.written())
        if (users.writers[variable.index].size() == 1) own_.push_back(variable);
    for (const Id<Network::Variable> variable : slots_.read())
        if (!is_own(variable)) others_.push_back(variable);
    for (const Network::Edge& edge : slots_.automaton.edges) {
        timing_.push_back(timing_of(network, clocks, slots_.automaton, edge));
        accepts_.push_back(accepts_request(edge));
        for (const bool by_plcs : {false, true})
            shows_[by_plcs].push_back(std::ranges::any_of(edge.assignments, [&](const Network::Assignment& assignment) {
                return is_seen(edge, variable_of(network_.exprs, assignment.target), by_plcs);
            }));
    }
}

bool ProcessStates::explore() {
    if (!is_simple() || !enumerate()) return false;
    State initial{slots_.process.initial, {}};
    for (const Id<Network::Variable> variable : own_) initial.values.push_back(network_.variables[variable].initial);
    number_of(initial);
    for (std::uint32_t state = 0; state < states_.size(); ++state)
        for (std::uint32_t valuation = 0; valuation < valuations_.size(); ++valuation)
            if (!expand(state, valuation)) return false;
    return true;
}

bool ProcessStates::shows_finitely(const std::vector<bool>& steady, bool to_plcs) const {
    std::map<Values, std::vector<const Move*>> by_steady;
    for (const Move& move : moves_) {
        if (!edge(move.edge).urgent) continue;
        Values key;
        for (std::size_t i = 0; i < others_.size(); ++i)
            if (steady[others_[i].index]) key.push_back(valuations_[move.valuation][i]);
        by_steady[std::move(key)].push_back(&move);
    }
    return std::ranges::all_of(by_steady, [&](const auto& group) {
        return !repeats(group.second, [&](const Move& move) { return shows_[to_plcs][move.edge]; });
    });
}

bool ProcessStates::moves_finitely() const {
    std::map<std::uint32_t, std::vector<const Move*>> by_valuation;
    for (const Move& move : moves_)
        if (edge(move.edge).urgent && !accepts_[move.edge]) by_valuation[move.valuation].push_back(&move);
    return std::ranges::all_of(
        by_valuation, [&](const auto& group) { return !repeats(group.second, [](const Move&) { return true; }); });
}

bool ProcessStates::repeats_slowly() const {
    std::vector<const Move*> fast;
    std::map<std::size_t, bool> is_slow;  // result of takes_time for each edge
    for (const Move& move : moves_) {
        const auto [known, is_new] = is_slow.emplace(move.edge, false);
        if (is_new) known->second = takes_time(move.edge);
        if (!known->second) fast.push_back(&move);
    }
    return !repeats(fast, [&](const Move& move) { return !edge(move.edge).urgent; });
}

std::vector<TimerRequest> ProcessStates::requests() const {
    std::map<Id<Network::Variable>, std::vector<Values>> after;  // per request: the values of own_ after each edge that
                                                                 // accepts the request
    for (const Move& move : moves_)
        if (const auto request = accepted(edge(move.edge))) after[*request].push_back(states_[move.to].values);
    std::vector<TimerRequest> requests;
    for (const auto& [request, all] : after) {
        TimerRequest& found = requests.emplace_back(TimerRequest{request});
        for (std::size_t i = 0; i < own_.size(); ++i) {
            const auto is_same = [&](const Values& values) { return values[i] == all.front()[i]; };
            if (network_.variables[own_[i]].type.boolean && std::ranges::all_of(all, is_same))
                found.results.emplace_back(own_[i], all.front()[i] != 0);
        }
    }
    return requests;
}

bool ProcessStates::takes_time(std::uint32_t id) const {
    const std::vector<ClockInterval> wanted = admitted(network_, edge(id).constraint, slots_.automaton.clocks.size());
    for (std::uint32_t clock = 0; clock < wanted.size(); ++clock) {
        if (wanted[clock].low < 1) continue;
        std::vector<const Move*> without_reset;
        for (const Move& move : moves_)
            if (!resets(edge(move.edge), {clock})) without_reset.push_back(&move);
        if (!repeats(without_reset, [&](const Move& move) { return move.edge == id; })) return true;
    }
    return false;
}

bool ProcessStates::is_written_by_plcs(Id<Network::Variable> variable) const {
    return std::ranges::all_of(users_.writers[variable.index], [&](Id<Network::Process> writer) {
        return writer == id_ || users_.plcs.contains(writer);
    });
}

std::optional<Id<Network::Variable>> ProcessStates::accepted(const Network::Edge& edge) const {
    if (!is_timer()) return {};
    for (const Id<Expr> conjunct : operands_of(network_.exprs, edge.guard, Op::And)) {
        if (network_.exprs[conjunct].op != Op::Variable) continue;
        const Id<Network::Variable> request = variable_of(network_.exprs, conjunct);
        const bool ends = std::ranges::any_of(edge.assignments, [&](const Network::Assignment& assignment) {
            return variable_of(network_.exprs, assignment.target) == request;
        });
        if (ends && only_ends(request) && is_written_by_plcs(request)) return request;
    }
    return {};
}

bool ProcessStates::only_ends(Id<Network::Variable> request) const {
    return std::ranges::all_of(slots_.automaton.edges, [&](const Network::Edge& edge) {
        return std::ranges::all_of(edge.assignments, [&](const Network::Assignment& assignment) {
            return variable_of(network_.exprs, assignment.target) != request ||
                   is_false(network_.exprs, assignment.value);
        });
    });
}

bool ProcessStates::accepts_only(Id<Network::Variable> variable) const {
    return std::ranges::all_of(slots_.automaton.edges, [&](const Network::Edge& edge) {
        return accepted(edge) == variable ||
               std::ranges::none_of(edge.assignments, [&](const Network::Assignment& assignment) {
                   return variable_of(network_.exprs, assignment.target) == variable;
               });
    });
}

bool ProcessStates::is_seen(const Network::Edge& edge, Id<Network::Variable> variable, bool by_plcs) const {
    if (accepted(edge) == variable) return false;
    return std::ranges::any_of(users_.readers[variable.index], [&](Id<Network::Process> reader) {
        return reader != id_ && (!by_plcs || users_.plcs.contains(reader));
    });
}

bool ProcessStates::is_simple() const {
    const auto is_bound = [&](const Network::ClockConstraint& bound) { return bound.relation == Op::LessEqual; };
    return std::ranges::all_of(slots_.automaton.edges, [](const Network::Edge& edge) { return edge.calls.empty(); }) &&
           std::ranges::all_of(
               others_,
               [&](Id<Network::Variable> id) { return accepts_only(id) && (!is_timer() || is_written_by_plcs(id)); }) &&
           std::ranges::none_of(slots_.used(),
                                [&](Id<Network::Variable> id) { return network_.variables[id].scratch; }) &&
           std::ranges::all_of(slots_.automaton.locations, [&](const Network::Location& location) {
               return location.invariant.size() < 63 && std::ranges::all_of(location.invariant, is_bound);
           });
}

bool ProcessStates::enumerate() {
    valuations_ = {{}};
    for (const Id<Network::Variable> variable : others_) {
        const Type& type = network_.variables[variable].type;
        const auto size = static_cast<std::uint64_t>(type.high - type.low) + 1;
        if (size > most_valuations || size * valuations_.size() > most_valuations) return false;
        std::vector<Values> more;
        for (const Values& values : valuations_)
            for (std::int64_t value = type.low; value <= type.high; ++value) {
                more.push_back(values);
                more.back().push_back(value);
            }
        valuations_ = std::move(more);
    }
    return true;
}

std::uint32_t ProcessStates::number_of(const State& state) {
    const auto [found, is_new] = numbers_.emplace(state, static_cast<std::uint32_t>(states_.size()));
    if (is_new) states_.push_back(state);
    return found->second;
}

std::optional<std::int64_t> ProcessStates::value(Id<Expr> term, const Values& own, const Values& others) const {
    return evaluate(network_.exprs, term, [&](const Expr& leaf) {
        const Id<Network::Variable> variable{static_cast<std::uint32_t>(leaf.value)};
        const auto at = std::ranges::find(own_, variable);
        if (at != own_.end()) return own[static_cast<std::size_t>(at - own_.begin())];
        const auto other = std::ranges::find(others_, variable);
        return others[static_cast<std::size_t>(other - others_.begin())];
    });
}

bool ProcessStates::expand(std::uint32_t from, std::uint32_t valuation) {
    const State now = states_[from];
    std::uint64_t left = 0;
    bool urgent = false;
    for (const Id<Network::Edge> id : slots_.automaton.edges.ids()) {
        const Network::Edge& edge = slots_.automaton.edges[id];
        if (edge.from != now.location) continue;
        const auto holds = value(edge.guard, now.values, valuations_[valuation]);
        if (!holds) return false;
        if (*holds == 0) continue;
        State next{edge.to, now.values};
        for (const Network::Assignment& assignment : edge.assignments) {
            const Id<Network::Variable> target = variable_of(network_.exprs, assignment.target);
            const auto result = value(assignment.value, next.values, valuations_[valuation]);
            const Type& type = network_.variables[target].type;
            if (!result || *result < type.low || *result > type.high) return false;
            const auto at = std::ranges::find(own_, target);
            if (at != own_.end()) next.values[static_cast<std::size_t>(at - own_.begin())] = *result;
        }
        const std::uint32_t to = number_of(next);
        left |= timing_[id.index].frees;
        urgent = urgent || edge.urgent;
        moves_.push_back({from, to, id.index, valuation});
        if (moves_.size() > most_moves || states_.size() * valuations_.size() > most_moves) return false;
    }
    const auto& invariant = slots_.automaton.locations[now.location].invariant;
    for (std::size_t bound = 0; bound < invariant.size() && !urgent; ++bound)
        if ((left >> bound & 1) == 0 || admitted(network_, invariant[bound]).high < 1) bounds_left_ = false;
    return true;
}

std::vector<bool> ProcessStates::late(const std::vector<bool>& possible, const std::vector<bool>& admitted,
                                      bool leave_freely) const {
    const auto valuations = static_cast<std::size_t>(std::ranges::count(admitted, true));
    std::vector<std::vector<std::uint32_t>> next(states_.size());
    std::vector<std::set<std::uint32_t>> urgent(
        states_.size());  // per state: the valuations that enable an urgent edge
    for (const Move& move : moves_) {
        if (!admitted[move.valuation]) continue;
        if (possible[move.from] && possible[move.to]) next[move.from].push_back(move.to);
        if (edge(move.edge).urgent) urgent[move.from].insert(move.valuation);
    }
    timed::Components components(states_.size(), limits_, [&](std::uint32_t state, const auto& take) {
        std::ranges::for_each(next[state], take);
    });
    std::vector<bool> result(states_.size(), false);
    for (std::uint32_t state = 0; state < states_.size(); ++state) {
        if (!possible[state]) continue;
        components.visit(state);
        const bool is_on_cycle = std::ranges::any_of(
            next[state], [&](std::uint32_t to) { return components.of(to) == components.of(state); });
        const bool must_leave = leave_freely || urgent[state].size() == valuations ||
                                !slots_.automaton.locations[states_[state].location].invariant.empty();
        result[state] = is_on_cycle || !must_leave;
    }
    return result;
}

}  // namespace grafverif
