// SPDX-License-Identifier: MIT
// Determines the processes that an input abstraction can reduce, and the output values that each of them can reach.
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "ir/interval.hpp"
#include "ir/junction.hpp"
#include "ir/network/variables.hpp"
#include "ir/network_clocks.hpp"
#include "ir/network_inputs.hpp"
#include "ir/slots.hpp"
#include "ir/task_cycles.hpp"
#include "ir/variable_users.hpp"

namespace grafverif {

namespace {

constexpr std::size_t most_valuations = 32;
constexpr std::size_t most_states = 4096;  // maximum number of combinations of location and outputs

class Finder {
public:
    Finder(const Network& network, const InputAblations& ablations)
        : network_(network), ablations_(ablations), users_(network) {}

    std::optional<AbstractableProcess> process(Id<Network::Process> id) const {
        const Network::ProcessKind kind = network_.processes[id].kind;
        if (kind == Network::ProcessKind::Controller || kind == Network::ProcessKind::Observer) return {};
        AbstractableProcess made{.process = id};
        const Slots slots(network_, id);
        // True if no other process writes the variables of the process.
        bool alone = kind != Network::ProcessKind::Timer;
        for (const Id<Network::Variable> variable : slots.written()) {
            if (is_flag(variable)) continue;
            if (network_.variables[variable].scratch || users_.writers[variable.index].size() > 1) alone = false;
            else made.outputs.push_back(variable);
        }
        std::set<Id<Network::Process>> readers;
        for (const Id<Network::Variable> variable : made.outputs) {
            const std::set<Id<Network::Process>>& all = users_.readers[variable.index];
            if (all.size() > (all.contains(id) ? 1U : 0U)) made.read_outputs.push_back(variable);
            for (const Id<Network::Process> reader : all)
                if (reader != id && !users_.plcs.contains(reader)) readers.insert(reader);
        }
        add_guards_of_plcs(made.outputs, readers);
        made.readers.assign(readers.begin(), readers.end());
        made.can_rest = ablations_.all_can_rest || can_rest(slots.automaton);
        made.autonomous = alone && !made.outputs.empty() && reads_itself(slots, made.outputs);
        if (!alone || made.outputs.empty() || !sets_flags_only(slots) ||
            !(explore(slots, made) || combine(slots, made)))
            made.valuations = {};
        made.lively = made.lively && made.autonomous && made.can_rest;
        made.returns = made.returns && made.autonomous && made.can_rest;
        return made;
    }

private:
    bool is_flag(Id<Network::Variable> variable) const {
        return network_.variables[variable].role == Network::Role::Flag && variable != network_.race;
    }

    static bool can_rest(const Network::Template& automaton) {
        return std::ranges::all_of(automaton.locations, [](const auto& at) { return at.invariant.empty(); }) &&
               std::ranges::none_of(automaton.edges, &Network::Edge::urgent);
    }

    static bool reads_only(const Exprs& exprs, Id<Expr> term, const std::vector<Id<Network::Variable>>& variables) {
        bool only = true;
        each_variable(exprs, term, [&](Id<Network::Variable> variable) {
            only = only && std::ranges::find(variables, variable) != variables.end();
        });
        return only;
    }

    bool reads_itself(const Slots& slots, const std::vector<Id<Network::Variable>>& outputs) const {
        return std::ranges::all_of(slots.automaton.edges, [&](const Network::Edge& edge) {
            const auto value_is_own = [&](const Network::Assignment& assignment) {
                return reads_only(network_.exprs, assignment.value, outputs);
            };
            return reads_only(network_.exprs, edge.guard, outputs) &&
                   std::ranges::all_of(edge.assignments, value_is_own);
        });
    }

    bool sets_flags_only(const Slots& slots) const {
        return std::ranges::all_of(slots.automaton.edges, [&](const Network::Edge& edge) {
            const auto sets = [&](const Network::Assignment& assignment) {
                return !is_flag(variable_of(network_.exprs, assignment.target)) ||
                       is_true(network_.exprs, assignment.value);
            };
            return edge.calls.empty() && std::ranges::all_of(edge.assignments, sets);
        });
    }

    /// Adds each PLC that reads an output in a guard, because a guard reads the output itself, not the sampled input.
    void add_guards_of_plcs(const std::vector<Id<Network::Variable>>& outputs,
                            std::set<Id<Network::Process>>& readers) const {
        for (const Id<Network::Process> plc : users_.plcs)
            for (const Network::Edge& edge : network_.templates[network_.processes[plc].automaton].edges)
                each_variable(network_.exprs, edge.guard, [&](Id<Network::Variable> variable) {
                    if (std::ranges::find(outputs, variable) != outputs.end()) readers.insert(plc);
                });
    }

    /// Returns the conjuncts of a guard that read only `outputs`; the other conjuncts are assumed to be satisfiable.
    /// The result is empty if one of the other conjuncts can be undefined.
    std::optional<std::vector<Id<Expr>>> own_conjuncts(Id<Expr> guard,
                                                       const std::vector<Id<Network::Variable>>& outputs) const {
        std::vector<Id<Expr>> own;
        for (const Id<Expr> operand : operands_of(network_.exprs, guard, Op::And)) {
            if (ablations_.own_guards_only || reads_only(network_.exprs, operand, outputs)) own.push_back(operand);
            else if (std::vector<bool> seen(network_.exprs.size()); may_divide(network_.exprs, operand, seen))
                return {};
        }
        return own;
    }

    /// True if `moves` lead to `initial` from every state. `states` is the number of reachable states.
    template <class State>
    static bool all_return(const std::vector<std::pair<State, State>>& moves, const State& initial,
                           std::size_t states) {
        std::set<State> returning{initial};
        for (bool grows = true; grows;) {
            grows = false;
            for (const auto& [from, to] : moves)
                if (returning.contains(to)) grows = returning.insert(from).second || grows;
        }
        return returning.size() == states;
    }

    struct State {
        Id<Network::Location> location = {};
        std::vector<std::int64_t> values = {};  // one value per output
        auto operator<=>(const State&) const = default;
    };
    using Columns = std::map<Id<Network::Variable>, std::size_t>;  // per output: its index in State::values

    std::optional<std::int64_t> value_in(const State& state, const Columns& columns, Id<Expr> term) const {
        return evaluate(network_.exprs, term, [&](const Expr& leaf) {
            const Id<Network::Variable> variable{static_cast<std::uint32_t>(leaf.value)};
            const auto found = columns.find(variable);
            return found == columns.end() ? network_.variables[variable].initial : state.values[found->second];
        });
    }

    /// Returns all values of the term for arbitrary values of its variables. Returns nullopt if the term can be
    /// undefined, can be out of the range of `type`, or may have too many values.
    std::optional<Interval> any_value(Id<Expr> term, const Type& type) const {
        if (std::vector<bool> seen(network_.exprs.size()); may_divide(network_.exprs, term, seen)) return {};
        const Interval values = interval(network_.exprs, term, [&](const Expr& leaf) {
            return network_.variables[Id<Network::Variable>{static_cast<std::uint32_t>(leaf.value)}].type;
        });
        const bool is_in_range = values.low >= type.low && values.high <= type.high;
        if (is_clipped(values) || !is_in_range || values.high - values.low >= std::int64_t{most_valuations}) return {};
        return values;
    }

    /// Executes the assignments of the edge from number `first` on, and appends the results to `successors`. A value
    /// that depends on another process may be any value of its interval. Returns false if a value may be out of range,
    /// undefined, or one of too many values, or if there are too many results.
    bool assign(const Network::Edge& edge, std::size_t first, State state, const Columns& columns,
                const std::vector<Id<Network::Variable>>& outputs, std::vector<State>& successors) const {
        for (std::size_t i = first; i < edge.assignments.size(); ++i) {
            const Network::Assignment& assignment = edge.assignments[i];
            const Id<Network::Variable> target = variable_of(network_.exprs, assignment.target);
            if (is_flag(target)) continue;
            const Type& type = network_.variables[target].type;
            std::int64_t& assigned = state.values[columns.at(target)];
            if (ablations_.own_guards_only || reads_only(network_.exprs, assignment.value, outputs)) {
                const std::optional<std::int64_t> result = value_in(state, columns, assignment.value);
                if (!result || *result < type.low || *result > type.high) return false;
                assigned = *result;
                continue;
            }
            const std::optional<Interval> values = any_value(assignment.value, type);
            if (!values) return false;
            for (assigned = values->low; assigned <= values->high; ++assigned)
                if (!assign(edge, i + 1, state, columns, outputs, successors)) return false;
            return true;
        }
        successors.push_back(std::move(state));
        return successors.size() <= most_states;
    }

    /// Enumerates the reachable combinations of locations and outputs for arbitrary values of other variables and
    /// clocks. Returns false if there are too many combinations, or if a value may be out of range or undefined.
    bool explore(const Slots& slots, AbstractableProcess& made) const {
        State initial{slots.process.initial, {}};
        Columns columns;
        for (const Id<Network::Variable> variable : made.outputs) {
            columns.emplace(variable, initial.values.size());
            initial.values.push_back(network_.variables[variable].initial);
        }
        std::set<State> seen{initial};
        std::vector<State> open{initial};
        std::vector<std::pair<State, State>> waiting;  // moves whose clock constraints are only lower bounds
        bool is_lively = true;
        while (!open.empty()) {
            const State now = std::move(open.back());
            open.pop_back();
            bool moves = false;
            for (const Network::Edge& edge : slots.automaton.edges) {
                if (edge.from != now.location) continue;
                const auto own = own_conjuncts(edge.guard, made.outputs);
                if (!own) return false;
                bool enabled = true;
                for (const Id<Expr> conjunct : *own) {
                    const std::optional<std::int64_t> holds = value_in(now, columns, conjunct);
                    if (!holds) return false;
                    enabled = enabled && *holds != 0;
                }
                if (!enabled) continue;
                moves = moves || waits_only(edge);
                std::vector<State> successors;
                if (!assign(edge, 0, {edge.to, now.values}, columns, made.outputs, successors)) return false;
                for (State& next : successors) {
                    if (waits_only(edge)) waiting.emplace_back(now, next);
                    if (!seen.insert(next).second) continue;
                    if (seen.size() > most_states) return false;
                    open.push_back(std::move(next));
                }
            }
            is_lively = is_lively && moves;
        }
        made.lively = is_lively;  // known only after all states have been explored
        made.returns = all_return(waiting, initial, seen.size());
        std::set<std::vector<std::int64_t>> valuations;
        for (const State& state : seen) {
            std::vector<std::int64_t> row;
            for (const Id<Network::Variable> variable : made.read_outputs)
                row.push_back(state.values[columns.at(variable)]);
            valuations.insert(std::move(row));
        }
        made.valuations.assign(valuations.begin(), valuations.end());
        return made.valuations.size() <= most_valuations;
    }

    /// Combines all values that the edges of an instance can assign to its outputs, for arbitrary values of all
    /// variables. Returns false if there are too many combinations, or if an edge may have a model error.
    bool combine(const Slots& slots, AbstractableProcess& made) const {
        std::map<Id<Network::Variable>, std::set<std::int64_t>> values;
        for (const Id<Network::Variable> variable : made.outputs)
            values[variable].insert(network_.variables[variable].initial);
        for (const Network::Edge& edge : slots.automaton.edges) {
            if (std::vector<bool> seen(network_.exprs.size()); may_divide(network_.exprs, edge.guard, seen))
                return false;
            for (const Network::Assignment& assignment : edge.assignments) {
                const Id<Network::Variable> target = variable_of(network_.exprs, assignment.target);
                if (is_flag(target)) continue;
                const std::optional<Interval> assigned = any_value(assignment.value, network_.variables[target].type);
                if (!assigned) return false;
                for (std::int64_t value = assigned->low; value <= assigned->high; ++value) values[target].insert(value);
            }
        }
        made.lively = made.returns = false;
        made.valuations = {{}};
        for (const Id<Network::Variable> variable : made.read_outputs) {
            std::vector<std::vector<std::int64_t>> longer;
            for (const std::vector<std::int64_t>& row : made.valuations)
                for (const std::int64_t value : values[variable]) {
                    longer.push_back(row);
                    longer.back().push_back(value);
                }
            if (longer.size() > most_valuations) return false;
            made.valuations = std::move(longer);
        }
        return true;
    }

    const Network& network_;
    const InputAblations& ablations_;
    const VariableUsers users_;
};

}  // namespace

std::vector<AbstractableProcess> abstractable_processes(const Network& network, const InputAblations& ablations) {
    if (has_task_cycle(network)) return {};
    const Finder finder(network, ablations);
    std::vector<AbstractableProcess> found;
    for (const Id<Network::Process> id : network.processes.ids())
        if (std::optional<AbstractableProcess> process = finder.process(id)) found.push_back(std::move(*process));
    return found;
}

}  // namespace grafverif
