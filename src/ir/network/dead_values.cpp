// SPDX-License-Identifier: MIT
#include "ir/network/dead_values.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "ir/network/variables.hpp"
#include "ir/slots.hpp"

namespace grafverif {

namespace {

using Variable = Id<Network::Variable>;
using Variables = std::set<Variable>;
/// A conjunction of activities of steps: the variable of a step, and whether the step is active.
using Situation = std::set<std::pair<Variable, bool>>;
/// The situations in which a variable is read.
using Readings = std::set<Situation>;

/// Adds a situation, unless `readings` contains a weaker situation (a subset). Removes stronger situations (supersets).
void add(Readings& readings, Situation added) {
    if (std::ranges::any_of(readings, [&](const Situation& weaker) { return std::ranges::includes(added, weaker); }))
        return;
    std::erase_if(readings, [&](const Situation& stronger) { return std::ranges::includes(stronger, added); });
    readings.insert(std::move(added));
}

/// Determines where a PLC reads one variable (backward analysis of liveness on the automaton of the PLC).
class Liveness {
public:
    Liveness(const Network& network, const Network::Controller& controller, const Variables& steps, Variable variable)
        : network_(network),
          controller_(controller),
          slots_(network, controller.process),
          steps_(steps),
          variable_(variable),
          readings_(slots_.automaton.locations.size()) {
        for (bool grows = true; std::exchange(grows, false);)
            for (const Network::Edge& edge : slots_.automaton.edges) {
                Readings& known = readings_[edge.from.index];
                const Readings before = known;
                for (const Situation& reading : readings_of(edge)) add(known, reading);
                grows = grows || known != before;
            }
    }

    /// Returns the situations, with the activities after procedure `evolve`, in which the variable is read later.
    Readings after_evolve() {
        Readings found;
        for (const Network::Edge& edge : slots_.automaton.edges) {
            const auto call = std::ranges::find(edge.calls, controller_.evolve);
            if (call == edge.calls.end()) continue;
            std::vector<Network::Assignment> rest;
            for (auto later = call + 1; later != edge.calls.end(); ++later) {
                const auto& body = slots_.automaton.procedures[*later].assignments;
                rest.insert(rest.end(), body.begin(), body.end());
            }
            for (const Situation& reading : readings_in(rest, edge.to)) add(found, reading);
        }
        return found;
    }

private:
    Readings readings_of(const Network::Edge& edge) {
        Readings found = readings_in(slots_.assignments(edge), edge.to);
        for (const Situation& reading : readings_of(edge.guard)) add(found, reading);
        return found;
    }

    /// Returns the situations before the assignments in which the assignments read the variable, or in which it may be
    /// read in location `to`.
    Readings readings_in(const std::vector<Network::Assignment>& assignments, Id<Network::Location> to) {
        Readings found;
        Variables written;
        const auto take = [&](const Readings& readings) {
            for (Situation reading : readings) {
                // An activity that an assignment has changed may have been different before the assignments.
                std::erase_if(reading, [&](const auto& step) { return written.contains(step.first); });
                add(found, std::move(reading));
            }
        };
        for (const Network::Assignment& assignment : assignments) {
            take(readings_of(assignment.value));
            const Variable target = variable_of(network_.exprs, assignment.target);
            if (target == variable_) return found;
            written.insert(target);
        }
        take(readings_[to.index]);
        return found;
    }

    /// Returns the situations in which the value of `term` depends on the variable.
    const Readings& readings_of(Id<Expr> term) {
        if (const auto known = terms_.find(term); known != terms_.end()) return known->second;
        const Expr& node = network_.exprs[term];
        Readings found;
        if (node.op == Op::Variable && variable_of(network_.exprs, term) == variable_) found.insert(Situation{});
        const bool absorbs = node.op == Op::And || node.op == Op::Or;
        // The term depends on its other operands only if no operand that is an activity determines the value of the
        // term.
        Situation others;
        for (const Id<Expr> operand : network_.exprs.operands(term))
            if (const auto step = absorbs ? activity(operand, node.op == Op::And) : std::nullopt) others.insert(*step);
        // A term that may be undefined reads all its operands in all situations.
        const bool is_partial = may_be_undefined(term);
        for (const Id<Expr> operand : network_.exprs.operands(term))
            for (Situation reading : readings_of(operand)) {
                if (is_partial || (!absorbs && node.op != Op::Not)) reading.clear();
                if (!is_partial) reading.insert(others.begin(), others.end());
                add(found, std::move(reading));
            }
        return terms_.emplace(term, std::move(found)).first->second;
    }

    bool may_be_undefined(Id<Expr> term) {
        if (const auto known = partial_.find(term); known != partial_.end()) return known->second;
        bool partial = is_arithmetic(network_.exprs[term].op);
        for (const Id<Expr> operand : network_.exprs.operands(term)) partial = may_be_undefined(operand) || partial;
        return partial_[term] = partial;
    }

    /// Returns the activity with which `term`, the variable of a step or its negation, has the value `value`.
    std::optional<std::pair<Variable, bool>> activity(Id<Expr> term, bool value) const {
        const bool negated = network_.exprs[term].op == Op::Not;
        const Id<Expr> leaf = negated ? network_.exprs.operands(term)[0] : term;
        if (network_.exprs[leaf].op != Op::Variable) return {};
        const Variable variable = variable_of(network_.exprs, leaf);
        if (!steps_.contains(variable)) return {};
        return std::pair(variable, value != negated);
    }

    const Network& network_;
    const Network::Controller& controller_;
    const Slots slots_;
    const Variables& steps_;
    const Variable variable_;
    std::vector<Readings> readings_;  // per location: situations of reads from this location on
    std::map<Id<Expr>, Readings> terms_ = {};
    std::map<Id<Expr>, bool> partial_ = {};
};

/// Clears dead values in one procedure `evolve`.
class Clearing {
public:
    Clearing(Network& network, Id<Network::Controller> controller)
        : network_(network), controller_(network.controllers[controller]) {
        for (const auto& step : controller_.words.steps) steps_.insert(step.variable);
        for (const Variable variable : Slots(network, controller_.process).written())
            if (network.variables[variable].role == Network::Role::Previous && network.variables[variable].type.boolean)
                candidates_.insert(variable);
        for (const Id<Network::Process> id : network.processes.ids()) {
            if (id == controller_.process) continue;
            for (const Variable variable : Slots(network, id).used()) candidates_.erase(variable);
            for (const Variable variable : Slots(network, id).written()) steps_.erase(variable);
        }
        for (const Property& property : network.properties)
            for (const Id<Expr> operand : property.operands) exclude(operand);
        if (network.settled.valid()) exclude(network.settled);
    }

    void clear(bool ignore_readings) {
        std::vector<std::pair<Variable, Readings>> found;
        for (const Variable variable : candidates_)
            found.emplace_back(variable, ignore_readings
                                             ? Readings{}
                                             : Liveness(network_, controller_, steps_, variable).after_evolve());
        for (const auto& [variable, readings] : found)
            if (!readings.contains(Situation{})) clear(variable, readings);
    }

private:
    void exclude(Id<Expr> term) {
        each_variable(network_.exprs, term, [&](Variable variable) { candidates_.erase(variable); });
    }
    Variable target(const Network::Assignment& assignment) const {
        return variable_of(network_.exprs, assignment.target);
    }
    bool reads(Id<Expr> term, Variable variable) const {
        bool found = false;
        each_variable(network_.exprs, term, [&](Variable other) { found = found || other == variable; });
        return found;
    }

    /// Moves the assignment of the variable after the assignments of steps, and restricts it to `readings`. Has no
    /// effect if an assignment between these two places reads the variable, or writes a variable that the assigned term
    /// reads.
    void clear(Variable variable, const Readings& readings) {
        auto& list = automaton().procedures[controller_.evolve].assignments;
        const auto is_target = [&](const Network::Assignment& assignment) { return target(assignment) == variable; };
        const auto stored = std::ranges::find_if(list, is_target);
        if (stored == list.end() || std::ranges::count_if(list, is_target) != 1) return;
        auto end = stored + 1;
        for (auto it = end; it != list.end(); ++it)
            if (steps_.contains(target(*it))) end = it + 1;
        const bool is_movable = std::none_of(stored + 1, end, [&](const Network::Assignment& between) {
            return reads(between.value, variable) || reads(stored->value, target(between));
        });
        if (!is_movable) return;
        stored->value = network_.exprs.conjunction(condition(readings), stored->value);
        std::rotate(stored, stored + 1, end);
    }

    Id<Expr> condition(const Readings& readings) {
        std::vector<Id<Expr>> situations;
        for (const Situation& situation : readings) {
            std::vector<Id<Expr>> activities;
            for (const auto& [step, active] : situation) {
                const Id<Expr> leaf = network_.exprs.leaf(Op::Variable, step.index);
                activities.push_back(active ? leaf : network_.exprs.negation(leaf));
            }
            situations.push_back(network_.exprs.conjunction(activities));
        }
        return network_.exprs.disjunction(situations);
    }

    Network::Template& automaton() { return network_.templates[network_.processes[controller_.process].automaton]; }

    Network& network_;
    const Network::Controller& controller_;
    Variables candidates_ = {}, steps_ = {};
};

}  // namespace

void clear_dead_values(Network& network, Id<Network::Controller> controller, bool ignore_readings) {
    if (network.controllers[controller].evolve.valid()) Clearing(network, controller).clear(ignore_readings);
}

}  // namespace grafverif
