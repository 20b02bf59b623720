// SPDX-License-Identifier: MIT
// The semantics of a network in integer time: values of terms, edges, and delays.
//
// A state of a *fragment* does not contain the values of some variables, locations and clocks: they
// are `unknown`. The state of a fragment represents all states of the network that have the same
// known values. A move of the fragment is a move of the network from one of the represented states:
// each unknown value that the move reads may be any value of its range, and each constraint on an
// unknown clock may hold. Therefore each edge of the network, of any process, is an edge of the
// fragment or leaves its state unchanged. Time stops in the fragment only for urgent edges that the
// network has in all states that the state represents; a certificate can only select the processes
// whose urgent edges are considered.
//
// Some states of a fragment may contain the value of a variable that other states do not contain. Such a variable is
// *open* in a state without its value: its value is chosen when a move reads it. The successor contains the choice,
// unless the edge assigns the variable. A copy of a variable without known or chosen value is open. Locations and clocks
// are never open.
//
// Choices agree with the *bounds*: sets of states of other fragments that contain all reachable states.
//
// Delays may have a *step* of several units if each bound of a known clock is a multiple of the step and not strict. If
// the times of all moves of a run are rounded up to multiples of the step, the clocks satisfy the same bounds of this
// kind. At each multiple in a rounded delay, time also passes in the run. Therefore, an urgent edge stops time only if
// its condition does not depend on clocks.
//
// A *subsystem* is a fragment without moves of processes whose locations are unknown. A subsystem
// must neither read an unknown value nor contain a variable that a process with an unknown location
// writes.
#pragma once

#include "network.hpp"

namespace certify {

/// The successors of a state. If time can pass (`waits`), the last successor is the state after a delay.
struct Moves {
    std::vector<State> next = {};
    bool waits = false;
    std::set<std::string> errors = {};  // the model errors of edges that can be taken
    std::set<Index> exceeded = {};      // variables to which these edges assign a value outside their ranges
};

/// The values and moves that a set of states represents.
struct Fragment {
    State known;                                  // `unknown` for each place whose value no state contains
    std::string kind = {};                        // `states`, `bounds` or `subsystem`; empty for runs
    bool partial = false;                         // true if some state does not contain some value
    Int step = 1;                                 // duration of a delay
    std::set<Index> reacting = {};                // processes with unknown locations whose urgent edges stop time
    std::vector<std::vector<State>> bounds = {};  // sets that contain all reachable states
};

struct Semantics : Fragment {
    Semantics(const Network& of, Fragment fragment) : Fragment(std::move(fragment)), network(of) {
        const auto is_known = [&](Index place) { return known[place] != unknown; };
        const auto changes = [&](const auto& assignment) { return is_known(assignment.first); };
        const auto errs = [&](const auto& assignment) { return !fits(assignment.first, assignment.second); };
        for (Index p = 0; p < of.processes.size(); ++p) {
            std::ranges::for_each(of.processes[p].invariants, [&](const auto& list) { check_step(list); });
            for (const Edge& edge : of.processes[p].edges) {
                check_step(edge.constraint);
                const bool own = is_known(of.processes[p].place);
                bool acts =
                    std::ranges::any_of(edge.assignments, changes) || std::ranges::any_of(edge.resets, is_known);
                if (subsystem && !own && acts) reject("an edge of another subsystem changes a value of this subsystem");
                if (kind == "states" && of.terms[edge.guard].low == unknown) acts = true;
                if (kind == "states" && std::ranges::any_of(edge.assignments, errs)) acts = true;
                if (own || acts) edges_.emplace_back(p, &edge);
                const auto is_reset = [&](const Constraint& one) { return edge.resets.contains(std::get<0>(one)); };
                const bool timed =
                    !edge.constraint.empty() || !std::ranges::all_of(of.processes[p].invariants[edge.to], is_reset);
                if (edge.urgent && (own || reacting.contains(p)) && (step == 1 || !timed))
                    urgent_.emplace_back(p, &edge);
            }
        }
    }

    const Network& network;
    const bool subsystem = kind == "subsystem";

    bool truth(Index term, const State& state) try { return value(term, state) != 0; } catch (const NoValue&) {
        reject("a term of a property or `settled` has no value in some state");
    }
    /// True if `property` concerns the state: a property `at stable` concerns only quiescent states.
    bool concerns(const Property& one, const State& state) { return !one.stable || truth(network.settled, state); }
    /// True if the property concerns the state, and its operand `k` is true.
    bool holds(Index k, const Property& property, const State& state) {
        return concerns(property, state) && truth(property.operands[k], state);
    }
    /// True if `state` is a goal, that is, a state to which the property requires a path. `has_edge`: the state has an
    /// enabled edge. `waits`: time can pass.
    bool is_goal(const Property& property, const State& state, bool has_edge, bool waits) {
        if (property.pattern >= Pattern::NoDeadlock) return property.pattern == Pattern::NoDeadlock ? has_edge : waits;
        return property.pattern > Pattern::ExactlyOne && holds(property.operands.size() - 1, property, state);
    }
    /// True if the state, or a state that it represents, violates the property or, for `reachable`, satisfies it.
    bool decides(const Property& property, const State& state) {
        // Two true operands decide `exactly one of`, even if a later operand has no value.
        const auto is_true = [&, found = 0](Index k) mutable { return found < 2 && truth(k, state) && ++found != 0; };
        return property.pattern <= Pattern::ExactlyOne && any_choice([&] {
                   if (!concerns(property, state)) return false;
                   const auto count = std::ranges::count_if(property.operands, is_true);
                   const bool one = property.pattern == Pattern::ExactlyOne ? count == 1 : count == 0;
                   return one == (property.pattern == Pattern::Always) && is_possible({});
               });
    }

    Moves moves(const State& now) {
        Moves made;
        for (const Move& move : edges_) any_choice([&] { return take(move, now, made), false; });
        // Time can pass if, for some unknown values, no urgent edge is enabled.
        State next = now;
        const auto is_urgent = [&](const Move& move) {
            try {
                return is_enabled(move, now, next, false);
            } catch (const NoValue&) {
                return !partial;
            }
        };
        made.waits = any_choice([&] { return std::ranges::none_of(urgent_, is_urgent) && is_possible({}); });
        next = now;
        for (const Process& process : network.processes) {
            for (const auto& [clock, cap] : process.caps[0])
                if (now[clock] != unknown) next[clock] += step;
            if (now[process.place] == unknown) continue;
            made.waits = made.waits && satisfied(process.invariants[location(process, now)], next, true);
            reduce(process, next);
        }
        if (made.waits) made.next.push_back(std::move(next));
        return made;
    }

private:
    using Move = std::pair<Index, const Edge*>;  // a process, and an edge of the process

    /// Rejects a step if a delay could pass over a bound of a known clock.
    void check_step(const std::vector<Constraint>& list) const {
        for (const auto& [clock, relation, bound] : list)
            if (step != 1 && known[clock] != unknown && (bound % step != 0 || relation == Op::Lt || relation == Op::Gt))
                reject("a bound is strict, or is not a multiple of the step");
    }
    /// True if the choices agree with a state of each set in `bounds`. Choices of variables in `assigned` are ignored,
    /// because they may be later values.
    bool is_possible(const Assignments& assigned) const {
        const auto agrees = [&](const State& state) {
            return std::ranges::all_of(std::span(choices_).first(next_choice_), [&](const auto& choice) {
                const auto& [place, value] = choice;
                return state[place] == unknown || state[place] == value ||
                       std::ranges::count(assigned, place, &Assignments::value_type::first) != 0;
            });
        };
        return std::ranges::all_of(bounds, [&](const auto& states) { return std::ranges::any_of(states, agrees); });
    }
    /// True if the term is a variable without known or chosen value.
    bool is_open(Index index, const State& state) const {
        const Term& term = network.terms[index];
        return !subsystem && term.op == Op::Value && state[term.place] == unknown && free_[term.place] == unknown;
    }

    /// True if all values of the term are in the range of the variable.
    bool fits(Index target, Index term) const {
        const auto& [low, high] = network.ranges[target];
        return low <= network.terms[term].low && network.terms[term].high <= high;
    }
    static Index location(const Process& of, const State& state) { return static_cast<Index>(state[of.place]); }
    /// Replaces the clocks of a process by their caps.
    static void reduce(const Process& of, State& state) {
        if (state[of.place] == unknown) return;
        for (const auto& [clock, cap] : of.caps[location(of, state)]) state[clock] = std::min(state[clock], cap);
    }

    bool is_enabled(const Move& move, const State& now, State& next, bool if_unknown) {
        const auto& [p, edge] = move;
        if (read(network.processes[p].place, now) != static_cast<Int>(edge->from)) return false;
        if (!satisfied(edge->constraint, now, if_unknown) || value(edge->guard, now) == 0) return false;
        next = now;
        for (const Index clock : edge->resets) next[clock] = 0;
        return satisfied(network.processes[p].invariants[edge->to], next, if_unknown);
    }
    /// If the edge can be taken, adds the successor or the model error.
    void take(const Move& move, const State& now, Moves& made) {
        const auto& [p, edge] = move;
        const Process& process = network.processes[p];
        Index k = 0;
        try {
            State next;
            if (!is_enabled(move, now, next, true)) return;
            for (; k < edge->assignments.size(); ++k) {
                const auto& [target, term] = edge->assignments[k];
                const auto& [low, high] = network.ranges[target];
                Int& variable = (known[target] == unknown ? free_ : next)[target];
                if (fits(target, term) && (known[target] == unknown || is_open(term, next)))
                    free_[target] = variable = unknown;
                else if (variable = value(term, next); variable < low || variable > high) {
                    made.exceeded.insert(target);
                    throw NoValue();
                }
            }
            if (now[process.place] != unknown) next[process.place] = static_cast<Int>(edge->to);
            for (const Index clock : edge->resets)
                if (now[clock] == unknown) next[clock] = unknown;
            for (Index i = 0; i < next_choice_; ++i)
                if (Int& open = next[choices_[i].first]; open == unknown && known[choices_[i].first] != unknown)
                    open = free_[choices_[i].first];
            reduce(process, next);
            if (is_possible(edge->assignments)) made.next.push_back(std::move(next));
        } catch (const NoValue&) {
            if (!is_possible(edge->assignments)) return;
            const auto number = std::to_string(edge - process.edges.data()) + " (" + std::to_string(k) + ')';
            made.errors.insert("edge " + number + " of `" + process.name + "` causes a model error");
        }
    }

    /// Calls `run` for each combination of the unknown values that `run` reads, until `run` returns
    /// true.
    template <class Run>
    bool any_choice(const Run& run) {
        choices_.clear();
        for (Index runs = 0; runs < most_choices; ++runs) {
            if (partial) std::ranges::fill(free_, unknown);
            next_choice_ = 0;
            if (run()) return true;
            while (!choices_.empty() && choices_.back().second == network.ranges[choices_.back().first].second)
                choices_.pop_back();
            if (choices_.empty()) return false;
            ++choices_.back().second;
        }
        reject("a move of a fragment reads too many unknown values");
    }
    /// Returns the value of a variable or location. An unknown value is chosen when it is first read, and again if an
    /// assignment makes it unknown again.
    Int read(Index place, const State& state) {
        if (state[place] != unknown) return state[place];
        if (subsystem) reject("a subsystem reads a value of another subsystem");
        if (free_[place] != unknown) return free_[place];
        if (next_choice_ == choices_.size()) choices_.emplace_back(place, network.ranges[place].first);
        return free_[place] = choices_[next_choice_++].second;
    }
    bool satisfied(const std::vector<Constraint>& list, const State& state, bool if_unknown) const {
        return std::ranges::all_of(list, [&](const Constraint& one) {
            const auto& [clock, relation, bound] = one;
            if (subsystem && state[clock] == unknown) reject("a subsystem reads a value of another subsystem");
            return state[clock] == unknown ? if_unknown : combined(relation, state[clock], bound) != 0;
        });
    }
    /// A new round forgets all values in memory_.
    Int value(Index term, const State& state) { return ++round_, evaluate(term, state); }
    Int evaluate(Index index, const State& state) {
        const Term& term = network.terms[index];
        if (term.op == Op::Constant) return term.value;
        if (term.op == Op::Value) return read(term.place, state);
        if (memory_[index].first != round_) memory_[index] = {round_, compute(term, state)};
        return memory_[index].second;
    }
    Int compute(const Term& term, const State& state) {
        const auto operand = [&](Index i) { return evaluate(term.operands[i], state); };
        const auto decides = [&](Index each) { return (evaluate(each, state) != 0) == (term.op == Op::Or); };
        if (term.op == Op::And || term.op == Op::Or)
            return std::ranges::any_of(term.operands, decides) == (term.op == Op::Or);
        if (term.op == Op::If) return operand(operand(0) != 0 ? 1 : 2);
        if (term.op == Op::Not) return operand(0) == 0;
        return term.op == Op::Neg ? combined(Op::Sub, 0, operand(0)) : combined(term.op, operand(0), operand(1));
    }
    static Int combined(Op op, Int left, Int right) {
        if (op <= Op::Ne) return (left == right) == (op == Op::Eq);
        if (op == Op::Lt || op == Op::Ge) return (left < right) == (op == Op::Lt);
        if (op == Op::Gt || op == Op::Le) return (left > right) == (op == Op::Gt);
        Int result = 0;
        const bool fails = op == Op::Add   ? __builtin_add_overflow(left, right, &result)
                           : op == Op::Sub ? __builtin_sub_overflow(left, right, &result)
                           : op == Op::Mul ? __builtin_mul_overflow(left, right, &result)
                                           : right == 0 || (left == INT64_MIN && right == -1);
        if (fails) throw NoValue();
        return op == Op::Div ? left / right : op == Op::Mod ? left % right : result;
    }

    std::vector<Move> edges_ = {}, urgent_ = {};
    std::vector<std::pair<Index, Int>> choices_ = {};  // places and their values
    Index next_choice_ = 0;
    State free_ = State(network.initial.size(), unknown);  // the chosen and assigned values of unknown places
    std::vector<std::pair<Index, Int>> memory_{network.terms.size()};  // values of terms, with their rounds
    Index round_ = 0;
};

}  // namespace certify
