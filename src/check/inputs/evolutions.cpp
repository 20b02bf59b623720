// SPDX-License-Identifier: MIT
#include "check/inputs/evolutions.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "check/inputs/plc_cycle.hpp"
#include "check/inputs/resting.hpp"
#include "ir/network/variables.hpp"
#include "ir/slots.hpp"

namespace grafverif {

namespace {

using pdr::Literal;
using VariableId = Id<Network::Variable>;
using Bits = PlcCycle::Bits;
using Valuation = std::vector<bool>;

constexpr std::size_t most_gates = 1U << 20U;  // maximum size of the circuit that represents the changes of one group
constexpr std::size_t most_edges = 1024;       // maximum number of changes of a group; also its maximum number of
                                               // valuations

/// A group of variables: the proof considers the joint values (valuations) of these variables.
struct Group {
    struct Change {
        std::size_t from = 0, to = 0;  // indices of valuations
    };

    std::vector<VariableId> variables = {};
    Bits before = {}, next = {}, first = {};
    std::vector<Valuation> valuations = {};  // the reachable valuations; empty if there are more than `most_edges`
    std::vector<Change> changes = {};
    bool is_steady = false;
};

bool is_request(const std::vector<TimerRequest>& requests, VariableId variable) {
    return std::ranges::find(requests, variable, &TimerRequest::request) != requests.end();
}

/// Returns the condition that the bits have the values of `valuation`.
Literal have_values(Gates& gates, const Bits& bits, const Valuation& valuation) {
    Literal result = Gates::yes;
    for (std::size_t i = 0; i < bits.size(); ++i) result = gates.both(result, bits[i] ^ (valuation[i] ? 0U : 1U));
    return result;
}

class EvolutionProof {
public:
    EvolutionProof(const Network& network, const Network::Controller& controller,
                   const std::vector<AbstractableProcess>& instances, const std::vector<TimerRequest>& requests,
                   const std::set<VariableId>& shared, pdr::LimitMonitor& monitor)
        : network_(network),
          controller_(controller),
          instances_(instances),
          requests_(requests),
          shared_(shared),
          monitor_(monitor),
          cycle_(network, controller, shared) {}

    /// Returns true if the evolutions of the PLC end. `constant` contains the variables that, from some time on, no
    /// process except for the PLC assigns.
    bool run(const std::set<VariableId>& constant, bool errors_are_excluded) {
        if (!cycle_.build()) return false;
        for (const auto& [variable, bits] : cycle_.before)
            if (constant.contains(variable)) (cycle_.next.contains(variable) ? kept_ : steady_).insert(variable);
        for (const TimerRequest& request : requests_)
            if (waits_for(request.request)) awaited_.push_back(&request);
        find_groups();
        if (!errors_are_excluded && may_have_error()) return false;
        for (bool grows = true; std::exchange(grows, false);)
            for (Group& group : groups_) {
                if (group.is_steady || group.valuations.empty() || has_cycle(group)) continue;
                steady_.insert(group.variables.begin(), group.variables.end());
                group.is_steady = grows = true;
            }
        return !has_cycle({.valuations = {{}}, .changes = {{0, 0}}});
    }

private:
    /// Finds the groups of the variables on which the beginning of a cycle depends.
    void find_groups() {
        std::set<VariableId> relevant;
        std::deque<VariableId> open;
        std::map<std::uint32_t, VariableId> variable_of_node;
        for (const auto& [variable, bits] : cycle_.before)
            for (const Literal bit : bits) variable_of_node[node_of(bit)] = variable;
        const auto take = [&](const Bits& roots) {
            for (const std::uint32_t node : cone(cycle_.circuit.gates, roots))
                if (const auto at = variable_of_node.find(node);
                    at != variable_of_node.end() && relevant.insert(at->second).second)
                    open.push_back(at->second);
        };
        take({cycle_.enabled});
        while (!open.empty()) {
            const auto next = cycle_.next.find(open.front());
            open.pop_front();
            if (next != cycle_.next.end()) take(next->second);
        }
        std::map<VariableId, Group> groups;  // the key is a representative of the group
        const std::map<VariableId, VariableId> joined = joined_steps();
        for (const VariableId variable : relevant) {
            if (!kept_.contains(variable)) continue;
            const auto of = joined.find(variable);
            Group& group = groups[of == joined.end() ? variable : of->second];
            group.variables.push_back(variable);
            const auto append = [](Bits& to, const Bits& from) { to.insert(to.end(), from.begin(), from.end()); };
            append(group.before, cycle_.before.at(variable));
            append(group.next, cycle_.next.at(variable));
            append(group.first, cycle_.first.at(variable));
        }
        for (auto& [representative, group] : groups) {
            find_changes(group);
            groups_.push_back(std::move(group));
        }
    }

    /// Returns, for each step, a representative of the steps that depend on the same firing conditions.
    std::map<VariableId, VariableId> joined_steps() const {
        std::map<VariableId, VariableId> parent;
        const auto find = [&](VariableId variable) {
            while (parent.try_emplace(variable, variable).first->second != variable) variable = parent[variable];
            return variable;
        };
        const auto role = [&](VariableId variable) { return network_.variables[variable].role; };
        const Slots slots(network_, controller_.process);
        for (const Network::Edge& edge : slots.automaton.edges)
            for (const Network::Assignment& assignment : slots.assignments(edge)) {
                const VariableId target = slots.variable(network_.exprs[assignment.target]);
                if (role(target) != Network::Role::Step) continue;
                each_variable(network_.exprs, assignment.value, [&](VariableId read) {
                    if (role(read) == Network::Role::FiringCondition) parent[find(read)] = find(target);
                });
            }
        std::map<VariableId, VariableId> steps;
        for (const auto& [variable, next] : std::map(parent))
            if (role(variable) == Network::Role::Step) steps[variable] = find(variable);
        return steps;
    }

    /// Finds the reachable valuations of the group and the changes between them, for arbitrary
    /// values of all other variables.
    void find_changes(Group& group) {
        // Values that other processes assign are taken into account only in a group of one variable. A larger group
        // with such a variable has no valuations and is never steady.
        if (group.variables.size() > 1 &&
            std::ranges::any_of(group.variables, [&](VariableId variable) { return shared_.contains(variable); }))
            return;
        std::vector<Valuation> valuations;
        std::map<Valuation, std::size_t> numbers;
        const auto number_of = [&](const Valuation& valuation) {
            const auto [at, is_new] = numbers.emplace(valuation, valuations.size());
            if (is_new) valuations.push_back(valuation);
            return at->second;
        };
        pdr::Solver solver(cycle_.circuit, monitor_);
        add_ranges(solver);
        for (const Valuation& valuation : values_of(solver, {solver.of(cycle_.starts)}, group.first))
            number_of(valuation);
        for (std::size_t from = 0; from < valuations.size(); ++from) {
            std::vector<int> assumptions{solver.of(cycle_.enabled)};
            for (std::size_t i = 0; i < group.before.size(); ++i) {
                const int bit = solver.of(group.before[i]);
                assumptions.push_back(valuations[from][i] ? bit : -bit);
            }
            for (const Valuation& valuation : values_of(solver, assumptions, group.next)) {
                const std::size_t to = number_of(valuation);
                if (from != to) group.changes.push_back({from, to});
                if (group.changes.size() > most_edges || valuations.size() > most_edges) return;
            }
        }
        group.valuations = std::move(valuations);
    }

    /// Adds two assumptions to the solver: each variable is in its range, and the outputs of each instance have a
    /// reachable valuation.
    void add_ranges(pdr::Solver& solver) {
        Gates& gates = cycle_.circuit.gates;
        for (const auto& [variable, bits] : cycle_.before)
            solver.add(std::array{solver.of(is_possible(gates, variable, bits))});
        for (const AbstractableProcess& instance : instances_)
            solver.add(std::array{solver.of(is_reachable(gates, instance, cycle_.before))});
    }

    /// True if a cycle may have a model error in a reachable valuation of each group. The reachable valuations include
    /// valuations that only a cycle with a model error reaches.
    bool may_have_error() {
        pdr::Solver solver(cycle_.circuit, monitor_);
        add_ranges(solver);
        for (const Group& group : groups_)
            if (!group.valuations.empty())
                solver.add(std::array{solver.of(is_reachable(cycle_.circuit.gates, group, group.before))});
        return solver.solve(std::array{solver.of(cycle_.error)});
    }

    /// Returns the condition that the bits are a reachable valuation of the group.
    static Literal is_reachable(Gates& gates, const Group& group, const Bits& bits) {
        Literal result = Gates::no;
        for (const Valuation& valuation : group.valuations)
            result = gates.either(result, have_values(gates, bits, valuation));
        return result;
    }

    /// Returns the values that `bits` can have under the assumptions, at most `most_edges` + 2 values.
    static std::vector<Valuation> values_of(pdr::Solver& solver, std::vector<int> assumptions, const Bits& bits) {
        std::vector<Valuation> found;
        const int others = solver.fresh();  // assumption that excludes the values that are already found
        assumptions.push_back(others);
        for (const Literal bit : bits) solver.of(bit);
        while (found.size() < most_edges + 2 && solver.solve(assumptions)) {
            Valuation valuation;
            std::vector<int> clause{-others};
            for (const Literal bit : bits) {
                valuation.push_back(solver.value(bit));
                clause.push_back(valuation.back() ? -solver.of(bit) : solver.of(bit));
            }
            solver.add(clause);
            found.push_back(std::move(valuation));
        }
        return found;
    }

    /// True if the graph of the changes contains a cycle that is possible for constant values of the steady variables.
    bool has_cycle(const Group& group) {
        if (group.changes.empty()) return false;
        Bits roots{cycle_.enabled};
        roots.insert(roots.end(), group.next.begin(), group.next.end());
        for (const auto& [variable, bits] : cycle_.next)
            if (steady_.contains(variable) || is_request(requests_, variable))
                roots.insert(roots.end(), bits.begin(), bits.end());
        const std::vector<std::uint32_t> nodes = cone(cycle_.circuit.gates, roots);
        Circuit copies;
        Gates& gates = copies.gates;
        std::map<VariableId, Bits> constant;
        std::map<std::uint32_t, Literal> shared;  // maps each node of the cycle to its copy
        for (const VariableId variable : steady_)
            for (const Literal bit : cycle_.before.at(variable)) {
                const Literal copy = gates.source();
                constant[variable].push_back(copy);
                shared[node_of(bit)] = copy;
            }
        Literal possible = Gates::yes;
        for (const auto& [variable, bits] : constant)
            possible = gates.both(possible, is_possible(gates, variable, bits));
        for (const AbstractableProcess& instance : instances_)
            possible = gates.both(possible, is_reachable(gates, instance, constant));
        for (const Group& steady : groups_) {
            if (!steady.is_steady) continue;
            Bits bits;
            for (const Literal bit : steady.before) bits.push_back(shared.at(node_of(bit)));
            possible = gates.both(possible, is_reachable(gates, steady, bits));
        }
        std::vector<Literal> taken;
        for (const Group::Change& change : group.changes) {
            std::map<std::uint32_t, Literal> sources = shared;
            for (std::size_t i = 0; i < group.before.size(); ++i)
                sources[node_of(group.before[i])] = group.valuations[change.from][i] ? Gates::yes : Gates::no;
            taken.push_back(copy_of(gates, nodes, sources, group, group.valuations[change.to]));
            if (gates.size() > most_gates) return true;
        }
        pdr::Solver solver(copies, monitor_);
        solver.add(std::array{solver.of(possible)});
        std::vector<int> chosen;
        for (const Literal edge : taken) {
            chosen.push_back(solver.fresh());
            solver.add(std::array{-chosen.back(), solver.of(edge)});
        }
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            std::vector<int> clause{-chosen[i]};
            for (std::size_t k = 0; k < chosen.size(); ++k)
                if (group.changes[k].from == group.changes[i].to) clause.push_back(chosen[k]);
            solver.add(clause);
        }
        return solver.solve({}, chosen);
    }

    /// Returns the condition that a PLC cycle changes the group to the valuation `to`, while all steady variables are
    /// constant.
    Literal copy_of(Gates& gates, const std::vector<std::uint32_t>& nodes,
                    const std::map<std::uint32_t, Literal>& sources, const Group& group, const Valuation& to) const {
        std::map<std::uint32_t, Literal> copies = sources;
        copies[0] = Gates::no;
        const auto copy = [&](Literal literal) { return copies.at(node_of(literal)) ^ (literal & 1U); };
        for (const std::uint32_t node : nodes) {
            if (copies.contains(node)) continue;
            const Gates::Node gate = cycle_.circuit.gates[node];
            copies[node] =
                cycle_.circuit.gates.is_gate(node) ? gates.both(copy(gate.left), copy(gate.right)) : gates.source();
        }
        Bits next;
        for (const Literal bit : group.next) next.push_back(copy(bit));
        Literal result = gates.both(copy(cycle_.enabled), have_values(gates, next, to));
        for (const auto& [variable, bits] : cycle_.next) {
            if (!steady_.contains(variable)) continue;
            for (std::size_t place = 0; place < bits.size(); ++place)
                result = gates.both(result, equal(gates, copy(bits[place]), copy(cycle_.before.at(variable)[place])));
        }
        for (const TimerRequest* const request : awaited_) {
            const Literal is_requested = copy(cycle_.next.at(request->request).front());
            for (const auto& [output, value] : request->results) {
                const auto at = cycle_.before.find(output);
                if (at == cycle_.before.end() || !steady_.contains(output)) continue;
                const Literal has_value = sources.at(node_of(at->second.front())) ^ (value ? 0U : 1U);
                result = gates.both(result, gates.either(is_requested ^ 1U, has_value));
            }
        }
        return result;
    }

    static Literal equal(Gates& gates, Literal left, Literal right) { return gates.choice(left, right, right ^ 1U); }

    /// True if the PLC assigns the request, and no cycle of the PLC begins while the request is pending.
    bool waits_for(VariableId request) const {
        const Slots slots(network_, controller_.process);
        return cycle_.next.contains(request) &&
               std::ranges::all_of(slots.automaton.edges, [&](const Network::Edge& edge) {
                   return edge.from != controller_.waiting || has_conjunct(network_.exprs, edge.guard, request, true);
               });
    }

    /// Returns the condition that the bits represent a value of the variable's type.
    Literal is_possible(Gates& gates, VariableId variable, const Bits& bits) const {
        const Type type = network_.variables[variable].type;
        if (type.boolean) return Gates::yes;
        bits::Integer<Gate> number;
        for (const Literal bit : bits) number.push_back({&gates, bit});
        number.emplace_back();
        return (~bits::less(bits::constant<Gate>(type.high - type.low), number)).literal;
    }
    /// Returns the condition that the outputs of the instance have one of its reachable valuations.
    Literal is_reachable(Gates& gates, const AbstractableProcess& instance,
                         const std::map<VariableId, Bits>& values) const {
        if (instance.valuations.empty()) return Gates::yes;
        Literal result = Gates::no;
        for (const std::vector<std::int64_t>& valuation : instance.valuations) {
            Literal row = Gates::yes;
            for (std::size_t i = 0; i < instance.read_outputs.size(); ++i) {
                const auto at = values.find(instance.read_outputs[i]);
                if (at == values.end()) continue;
                const Type type = network_.variables[at->first].type;
                const auto value = static_cast<std::uint64_t>(valuation[i]) -
                                   (type.boolean ? 0 : static_cast<std::uint64_t>(type.low));
                for (std::size_t place = 0; place < at->second.size(); ++place)
                    row = gates.both(row, at->second[place] ^ (value >> place & 1U ? 0U : 1U));
            }
            result = gates.either(result, row);
        }
        return result;
    }

    const Network& network_;
    const Network::Controller& controller_;
    const std::vector<AbstractableProcess>& instances_;
    const std::vector<TimerRequest>& requests_;
    const std::set<VariableId>& shared_;
    pdr::LimitMonitor& monitor_;
    PlcCycle cycle_;
    std::set<VariableId> kept_ = {};  // variables that only the PLC assigns from some time on
    std::set<VariableId> steady_ = {};
    std::vector<const TimerRequest*> awaited_ = {};  // requests that timers accept before the next cycle
    std::vector<Group> groups_ = {};
};

}  // namespace

std::optional<bool> evolutions_end(const Network& network, const std::vector<AbstractableProcess>& instances,
                                   const pdr::SolverLimits& limits, bool errors_are_excluded) {
    const std::vector<TimerRequest> requests = requests_of(network);
    std::set<Id<Network::Process>> open;  // PLCs for which it is not yet proved that evolutions end
    for (const Network::Controller& controller : network.controllers) open.insert(controller.process);
    pdr::LimitMonitor monitor(limits);
    const auto ends = [&](const Network::Controller& controller) {
        std::set<VariableId> shared, constant;
        for (const VariableId variable : network.variables.ids())
            if (!is_request(requests, variable)) constant.insert(variable);
        for (const Id<Network::Process> id : network.processes.ids()) {
            if (id == controller.process) continue;
            for (const VariableId variable : Slots(network, id).written()) {
                shared.insert(variable);
                if (open.contains(id)) constant.erase(variable);
            }
        }
        return EvolutionProof(network, controller, instances, requests, shared, monitor)
            .run(constant, errors_are_excluded);
    };
    try {
        for (bool grows = true; grows && !open.empty();) {
            grows = false;
            for (const Network::Controller& controller : network.controllers)
                if (open.contains(controller.process) && ends(controller)) grows = open.erase(controller.process) > 0;
        }
    } catch (const pdr::Exhausted&) {
        return {};
    }
    return open.empty();
}

}  // namespace grafverif
