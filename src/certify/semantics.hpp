// SPDX-License-Identifier: MIT
// Implements the semantics of a network in integer time: values of terms, edges, delays, and the caps of the clocks.
#pragma once

#include "network.hpp"

namespace certify {

class Semantics {
public:
    explicit Semantics(const Network& of) : network(of), memory_(of.terms.size()) {}

    const Network& network;
    std::string error = {};  // the model error that `take` or `moves` has found, or empty

    bool truth(std::size_t term, const State& state) try { return value(term, state) != 0; } catch (const NoValue&) {
        reject("a term of a property, `settled` or `race` has no value in some state");
    }
    /// True if the state has a race, which ends a run.
    bool races(const State& state) { return network.race != 0 && truth(network.race, state); }
    /// True if `property` concerns the state: a property `at stable` concerns only quiescent states.
    bool concerns(const Property& property, const State& state) {
        return !property.stable || truth(network.settled, state);
    }
    bool last_operand(const Property& property, const State& state) {
        return concerns(property, state) && truth(property.operands.back(), state);
    }
    /// True if `state` is a goal, that is, a state to which the property requires a path. `has_edge`: the state has an
    /// enabled edge. `waits`: time can pass.
    bool is_goal(const Property& property, const State& state, bool has_edge, bool waits) {
        if (property.pattern >= Pattern::NoDeadlock) return property.pattern == Pattern::NoDeadlock ? has_edge : waits;
        return property.pattern > Pattern::ExactlyOne && last_operand(property, state);
    }
    /// True if the state alone violates the property or, for `reachable`, satisfies it.
    bool decides(const Property& property, const State& state) {
        if (property.pattern > Pattern::ExactlyOne || !concerns(property, state)) return false;
        const auto count = std::ranges::count_if(property.operands, [&](auto term) { return truth(term, state); });
        if (property.pattern == Pattern::ExactlyOne) return count != 1;
        return (count != 0) != (property.pattern == Pattern::Always);
    }

    /// True if the edge is enabled in `now`. If so, sets `next` to the successor or, after a model error, sets `error`.
    bool take(std::size_t p, const Edge& edge, const State& now, State& next) try {
        if (now[network.processes[p].place] != static_cast<Int>(edge.from)) return false;
        if (!satisfied(edge.constraint, now) || value(edge.guard, now) == 0) return false;
        next = now;
        for (const std::size_t clock : edge.resets) next[clock] = 0;
        if (!satisfied(network.processes[p].locations[edge.to].invariant, next)) return false;
        for (const auto& [target, term] : edge.assignments) {
            next[target] = value(term, next);
            if (!network.admits(target, next[target])) throw NoValue();
        }
        next[network.processes[p].place] = static_cast<Int>(edge.to);
        reduce(p, next);
        return true;
    } catch (const NoValue&) {
        error = "an edge of `" + network.processes[p].name + "` causes a model error";
        return true;
    }

    /// Calls `visit(next)` for the successor by each edge that can be taken. Returns true if one unit of time can pass;
    /// in this case, `next` is the successor by this delay.
    template <class Visit>
    bool moves(const State& now, State& next, const Visit& visit) {
        bool urgent = false;
        error = races(now) ? "a race of stored actions" : "";
        for (std::size_t p = 0; p < network.processes.size(); ++p)
            for (const Edge& edge : network.processes[p].edges) {
                if (!take(p, edge, now, next)) continue;
                urgent = urgent || edge.urgent;
                if (error.empty()) visit(next);
            }
        next = now;
        for (std::size_t p = 0; p < network.processes.size() && !urgent; ++p) {
            for (const Clock& clock : network.processes[p].clocks) ++next[clock.place];
            if (!satisfied(location(p, now).invariant, next)) return false;
            reduce(p, next);
        }
        return !urgent;
    }

    /// Checks that no constraint distinguishes values that one cap represents: the cap of a clock in a location is not
    /// less than the caps of the constraints in this location. For each edge that does not reset the clock, the cap is
    /// also not less than the cap of the clock in the target location.
    void check_caps() const {
        for (const Process& process : network.processes) {
            const auto require = [&](const Location& at, std::size_t clock, Int least) {
                if (at.caps.at(clock) < least) reject("a cap of a clock of `" + process.name + "` is too small");
            };
            for (const Location& at : process.locations)
                for (const Constraint& one : at.invariant) require(at, one.clock, one.cap());
            for (const Edge& edge : process.edges) {
                const Location &from = process.locations[edge.from], &to = process.locations[edge.to];
                for (const Constraint& one : edge.constraint) require(from, one.clock, one.cap());
                for (const auto& [clock, cap] : to.caps)
                    if (!edge.resets.contains(clock)) require(from, clock, cap);
            }
        }
    }

    /// Replaces the clock values of process `p` that exceed their caps by the caps.
    void reduce(std::size_t p, State& state) const {
        for (const auto& [clock, cap] : location(p, state).caps) state[clock] = std::min(state[clock], cap);
    }

private:
    const Location& location(std::size_t p, const State& state) const {
        return network.processes[p].locations[static_cast<std::size_t>(state[network.processes[p].place])];
    }
    static bool satisfied(const std::vector<Constraint>& list, const State& state) {
        return std::ranges::all_of(
            list, [&](const Constraint& one) { return combined(one.relation, state[one.clock], one.bound) != 0; });
    }
    Int value(std::size_t term, const State& state) {
        ++round_;  // a new round invalidates all values in memory_
        return evaluate(term, state);
    }
    Int evaluate(std::size_t index, const State& state) {
        const Term& term = network.terms[index];
        if (term.op == Op::Constant) return term.value;
        if (term.op == Op::Value) return state[term.place];
        if (memory_[index].first != round_) memory_[index] = {round_, compute(term, state)};
        return memory_[index].second;
    }
    Int compute(const Term& term, const State& state) {
        const auto operand = [&](std::size_t i) { return evaluate(term.operands[i], state); };
        const auto decides = [&](std::size_t each) { return (evaluate(each, state) != 0) == (term.op == Op::Or); };
        if (term.op == Op::And || term.op == Op::Or)
            return std::ranges::any_of(term.operands, decides) == (term.op == Op::Or);
        if (term.op == Op::If) return operand(operand(0) != 0 ? 1 : 2);
        if (term.op == Op::Not) return operand(0) == 0;
        return term.op == Op::Neg ? combined(Op::Sub, 0, operand(0)) : combined(term.op, operand(0), operand(1));
    }
    static Int combined(Op op, Int left, Int right) {
        Int result = 0;
        bool fails = false;
        if (op == Op::Eq || op == Op::Ne) return (left == right) == (op == Op::Eq);
        if (op == Op::Lt || op == Op::Ge) return (left < right) == (op == Op::Lt);
        if (op == Op::Gt || op == Op::Le) return (left > right) == (op == Op::Gt);
        if (op == Op::Add) fails = __builtin_add_overflow(left, right, &result);
        else if (op == Op::Sub) fails = __builtin_sub_overflow(left, right, &result);
        else if (op == Op::Mul) fails = __builtin_mul_overflow(left, right, &result);
        else if (right == 0 || (left == INT64_MIN && right == -1)) fails = true;
        else result = op == Op::Div ? left / right : left % right;
        return fails ? throw NoValue() : result;
    }

    std::vector<std::pair<std::uint64_t, Int>> memory_;  // values of terms, with the rounds in which they were computed
    std::uint64_t round_ = 0;
};

}  // namespace certify
