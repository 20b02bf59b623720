// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "ir/network_inputs.hpp"
#include "ir/slots.hpp"

namespace grafverif {

namespace {

constexpr std::size_t most_valuations = 32;
constexpr std::size_t most_states = 4096;  // per instance, clocks ignored

using Variable = Id<Network::Variable>;
using Process = Id<Network::Process>;

Variable variable_of(const Exprs& exprs, Id<Expr> leaf) { return {static_cast<std::uint32_t>(exprs[leaf].value)}; }

/// Calls `visit` for each variable that `term` reads.
template <class Visit>
void each_variable(const Exprs& exprs, Id<Expr> term, const Visit& visit) {
    for (const Id<Expr> leaf : leaves(exprs, term))
        if (exprs[leaf].op == Op::Variable) visit(variable_of(exprs, leaf));
}

/// Writers and readers of each variable.
struct Users {
    std::vector<std::set<Process>> writers, readers;

    explicit Users(const Network& network) : writers(network.variables.size()), readers(network.variables.size()) {
        for (const Process id : network.processes.ids()) {
            const Slots slots(network, id);
            for (const Variable variable : slots.written()) writers[variable.index].insert(id);
            for (const Variable variable : slots.read()) readers[variable.index].insert(id);
        }
    }
};

class Finder {
public:
    explicit Finder(const Network& network) : network_(network), users_(network) {
        for (const Network::Controller& controller : network.controllers) plcs_.insert(controller.process);
        if (!network.settled.valid()) return;
        for (const Id<Expr> leaf : leaves(network.exprs, network.settled))
            if (network.exprs[leaf].op == Op::At) settling_.insert(at_process(network.exprs[leaf]));
    }

    std::optional<AutonomousInstance> instance(Process id) const {
        const Network::ProcessKind kind = network_.processes[id].kind;
        const bool of_plant = kind == Network::ProcessKind::Plant || kind == Network::ProcessKind::Environment;
        if (!of_plant || settling_.contains(id.index)) return {};
        AutonomousInstance made{.process = id};
        const Slots slots(network_, id);
        for (const Variable variable : slots.written()) {
            if (is_flag(variable)) continue;
            if (network_.variables[variable].scratch || users_.writers[variable.index].size() > 1) return {};
            made.outputs.push_back(variable);
        }
        if (made.outputs.empty() || !reads_itself(slots, made.outputs)) return {};
        if (!explore(slots, made)) return {};
        for (const Variable variable : made.outputs)
            for (const Process reader : users_.readers[variable.index])
                made.is_read = made.is_read || (reader != id && !plcs_.contains(reader));
        made.is_read = made.is_read || is_guard_of_plc(made.outputs);
        return made;
    }

private:
    bool is_flag(Variable variable) const {
        return network_.variables[variable].role == Network::Role::Flag && variable != network_.race;
    }

    /// True if the instance reads only its outputs; flags are only set.
    bool reads_itself(const Slots& slots, const std::vector<Variable>& outputs) const {
        bool itself = true;
        const auto check = [&](Id<Expr> term) {
            each_variable(network_.exprs, term, [&](Variable variable) {
                itself = itself && std::ranges::find(outputs, variable) != outputs.end();
            });
        };
        for (const Network::Edge& edge : slots.automaton.edges) {
            if (!edge.calls.empty()) return false;
            check(edge.guard);
            for (const Network::Assignment& assignment : edge.assignments) {
                check(assignment.value);
                if (is_flag(variable_of(network_.exprs, assignment.target)))
                    itself = itself && is_true(network_.exprs, assignment.value);
            }
        }
        return itself;
    }

    /// True if a condition of a PLC cycle is evaluated outside of its sampling.
    bool is_guard_of_plc(const std::vector<Variable>& outputs) const {
        for (const Process plc : plcs_)
            for (const Network::Edge& edge : network_.templates[network_.processes[plc].automaton].edges) {
                bool reads = false;
                each_variable(network_.exprs, edge.guard, [&](Variable variable) {
                    reads = reads || std::ranges::find(outputs, variable) != outputs.end();
                });
                if (reads) return true;
            }
        return false;
    }

    /// Enumerates the reachable combinations of locations and outputs, clocks ignored. False if there are too many or a
    /// value is out of range.
    bool explore(const Slots& slots, AutonomousInstance& made) const {
        struct State {
            Id<Network::Location> location = {};
            std::vector<std::int64_t> values = {};
            auto operator<=>(const State&) const = default;
        };
        State initial{slots.process.initial, {}};
        std::map<Variable, std::size_t> column;
        for (const Variable variable : made.outputs) {
            column.emplace(variable, initial.values.size());
            initial.values.push_back(network_.variables[variable].initial);
        }
        std::set<State> seen{initial};
        std::vector<State> open{initial};
        while (!open.empty()) {
            const State now = std::move(open.back());
            open.pop_back();
            for (const Network::Edge& edge : slots.automaton.edges) {
                if (edge.from != now.location) continue;
                State next{edge.to, now.values};
                const auto value = [&](Id<Expr> term) {
                    return evaluate(network_.exprs, term, [&](const Expr& leaf) {
                        return next.values[column.at({static_cast<std::uint32_t>(leaf.value)})];
                    });
                };
                const std::optional<std::int64_t> guard = value(edge.guard);
                if (!guard) return false;
                if (*guard == 0) continue;
                for (const Network::Assignment& assignment : edge.assignments) {
                    const Variable target = variable_of(network_.exprs, assignment.target);
                    if (is_flag(target)) continue;
                    const std::optional<std::int64_t> result = value(assignment.value);
                    const Type& type = network_.variables[target].type;
                    if (!result || *result < type.low || *result > type.high) return false;
                    next.values[column.at(target)] = *result;
                }
                if (!seen.insert(next).second) continue;
                if (seen.size() > most_states) return false;
                open.push_back(std::move(next));
            }
        }
        std::set<std::vector<std::int64_t>> valuations;
        for (const State& state : seen) valuations.insert(state.values);
        made.valuations.assign(valuations.begin(), valuations.end());
        return made.valuations.size() <= most_valuations;
    }

    const Network& network_;
    Users users_;
    std::set<Process> plcs_ = {};
    std::set<std::uint32_t> settling_ = {};  // processes whose location determines if the loop is quiescent
};

class Abstracter {
public:
    Abstracter(const Network& network, const std::vector<AutonomousInstance>& instances,
               const std::vector<InputLevel>& levels, const InputAblations& ablations)
        : instances_(instances), levels_(levels), ablations_(ablations) {
        made_.network = network;
    }

    InputAbstraction build() {
        for (std::size_t i = 0; i < instances_.size(); ++i) {
            if (levels_[i] == InputLevel::Untimed) ignore_clocks(automaton(instances_[i].process));
            if (levels_[i] == InputLevel::Paced) made_.paced.push_back(instances_[i].process);
            if (levels_[i] == InputLevel::Chosen) remove(i);
        }
        for (const Id<Network::Controller> id : made_.network.controllers.ids()) choose_in(id);
        return std::move(made_);
    }

private:
    Network::Template& automaton(Process id) { return made_.network.templates[made_.network.processes[id].automaton]; }

    static void ignore_clocks(Network::Template& automaton) {
        for (Network::Location& location : automaton.locations) location.invariant.clear();
        for (Network::Edge& edge : automaton.edges) {
            edge.urgent = false;
            edge.constraint.clear();
            edge.resets.clear();
        }
    }

    void remove(std::size_t instance) {
        Network::Template& removed = automaton(instances_[instance].process);
        for (const Network::Edge& edge : removed.edges)
            for (const Network::Assignment& assignment : edge.assignments)
                woken_.insert(variable_of(made_.network.exprs, assignment.target));
        ignore_clocks(removed);
        removed.edges = {};
        for (const Variable variable : instances_[instance].outputs) chosen_.emplace(variable, instance);
    }

    void choose_in(Id<Network::Controller> id) {
        const Network::Controller& controller = made_.network.controllers[id];
        Network::Template& plc = automaton(controller.process);
        read_inputs_for_samples(plc);
        std::map<std::size_t, std::size_t> choice_of;  // per instance
        for (const Network::Edge& edge : plc.edges)
            each_read(controller.process, edge, [&](std::size_t instance) {
                if (!choice_of.emplace(instance, made_.choices.size()).second) return;
                made_.choices.push_back(
                    {instance, controller.process, instances_[instance].outputs, valuations(instance)});
            });
        for (const auto& [instance, choice] : choice_of) keep(controller, made_.choices[choice]);
        if (!ablations_.no_cycle_on_change) begin_cycles(controller, plc);
    }

    std::vector<std::vector<std::int64_t>> valuations(std::size_t instance) const {
        if (!ablations_.initial_values) return instances_[instance].valuations;
        std::vector<std::int64_t> initial;
        for (const Variable variable : instances_[instance].outputs)
            initial.push_back(made_.network.variables[variable].initial);
        return {initial};
    }

    template <class Visit>
    void each_read(Process plc, const Network::Edge& edge, const Visit& visit) {
        for (const Network::Assignment& assignment : Slots(made_.network, plc).assignments(edge))
            each_variable(made_.network.exprs, assignment.value, [&](Variable variable) {
                if (const auto found = chosen_.find(variable); found != chosen_.end()) visit(found->second);
            });
    }

    /// The set of possible valuations lives as long as a sample: readers of the sample read the input instead.
    void read_inputs_for_samples(Network::Template& plc) {
        std::map<Variable, Variable> input_of;
        const Exprs& exprs = made_.network.exprs;
        const auto each_list = [&](const auto& visit) {
            for (Network::Procedure& procedure : plc.procedures) visit(procedure.assignments);
            for (Network::Edge& edge : plc.edges) visit(edge.assignments);
        };
        each_list([&](std::vector<Network::Assignment>& list) {
            for (const Network::Assignment& assignment : list) {
                const Variable target = variable_of(exprs, assignment.target);
                if (made_.network.variables[target].role != Network::Role::Sample) continue;
                if (exprs[assignment.value].op != Op::Variable) continue;
                const Variable input = variable_of(exprs, assignment.value);
                if (chosen_.contains(input)) input_of.emplace(target, input);
            }
        });
        if (input_of.empty()) return;
        const Exprs from = exprs;  // a copy, because the table grows
        TermCopier copy(from, made_.network.exprs, [&](const Expr& leaf) {
            const auto found =
                leaf.op == Op::Variable ? input_of.find({static_cast<std::uint32_t>(leaf.value)}) : input_of.end();
            if (leaf.op == Op::At) return made_.network.exprs.at(at_process(leaf), at_location(leaf));
            return made_.network.exprs.leaf(
                leaf.op, found == input_of.end() ? static_cast<std::uint32_t>(leaf.value) : found->second.index);
        });
        each_list([&](std::vector<Network::Assignment>& list) {
            std::erase_if(list, [&](const Network::Assignment& assignment) {
                return input_of.contains(variable_of(made_.network.exprs, assignment.target));
            });
            for (Network::Assignment& assignment : list) assignment.value = copy(assignment.value);
        });
    }

    /// Determines between which edges the set must be stored: from a sampling to the last edge that reads it.
    void keep(const Network::Controller& controller, InputChoice& choice) {
        const Network::Template& plc = automaton(controller.process);
        const auto samples = [&](const Network::Edge& edge) {
            return std::ranges::any_of(edge.calls, [&](Id<Network::Procedure> call) {
                return call == controller.fire || call == controller.start;
            });
        };
        const auto reads = [&](const Network::Edge& edge) {
            bool found = false;
            each_read(controller.process, edge,
                      [&](std::size_t instance) { found = found || instance == choice.instance; });
            return found;
        };
        std::vector<bool> live(plc.locations.size(), false);
        for (bool grows = true; grows;) {
            grows = false;
            for (const Network::Edge& edge : plc.edges) {
                if (live[edge.from.index] || samples(edge) || !(reads(edge) || live[edge.to.index])) continue;
                live[edge.from.index] = grows = true;
            }
        }
        choice.kept = std::ranges::find(live, true) != live.end();
        for (const Id<Network::Edge> id : plc.edges.ids())
            if (!live[plc.edges[id].to.index]) choice.widened.push_back(id);
    }

    /// Events that set EVOL_PL may occur at any time: a cycle may begin in W even if the rest of the loop does not
    /// request it.
    void begin_cycles(const Network::Controller& controller, Network::Template& plc) {
        Exprs& exprs = made_.network.exprs;
        std::vector<Network::Edge> more;
        for (const Network::Edge& edge : plc.edges) {
            if (edge.from != controller.waiting || !edge.urgent) continue;
            const Exprs from = exprs;  // a copy, because the table grows
            const Id<Expr> woken = translate(from, edge.guard, exprs, [&](const Expr& leaf) {
                if (leaf.op == Op::Variable && woken_.contains({static_cast<std::uint32_t>(leaf.value)}))
                    return exprs.constant(true);
                return exprs.leaf(leaf.op, static_cast<std::uint32_t>(leaf.value));
            });
            if (woken == edge.guard) continue;
            Network::Edge copy = edge;
            copy.urgent = false;
            copy.guard = exprs.conjunction(woken, exprs.negation(edge.guard));
            more.push_back(std::move(copy));
        }
        for (Network::Edge& edge : more) {
            const Id<Network::Edge> id = plc.edges.add(std::move(edge));
            for (InputChoice& choice : made_.choices) {
                const bool same = choice.plc == controller.process;
                const auto to = plc.edges[id].to;
                const auto widens = [&](Id<Network::Edge> other) { return plc.edges[other].to == to; };
                if (same && std::ranges::any_of(choice.widened, widens)) choice.widened.push_back(id);
            }
        }
    }

    const std::vector<AutonomousInstance>& instances_;
    const std::vector<InputLevel>& levels_;
    const InputAblations& ablations_;
    std::set<Variable> woken_ = {};                // flags that removed instances set
    std::map<Variable, std::size_t> chosen_ = {};  // outputs of removed instances
    InputAbstraction made_ = {};
};

/// Calls `visit` for each clock constraint of the network.
template <class Of, class Visit>
void each_constraint(Of& network, const Visit& visit) {
    for (const Process id : network.processes.ids()) {
        auto& automaton = network.templates[network.processes[id].automaton];
        for (auto& location : automaton.locations)
            for (auto& constraint : location.invariant) visit(id, constraint);
        for (auto& edge : automaton.edges)
            for (auto& constraint : edge.constraint) visit(id, constraint);
    }
}

}  // namespace

std::vector<AutonomousInstance> autonomous_instances(const Network& network) {
    const Finder finder(network);
    std::vector<AutonomousInstance> found;
    for (const Process id : network.processes.ids())
        if (std::optional<AutonomousInstance> instance = finder.instance(id)) found.push_back(std::move(*instance));
    return found;
}

InputAbstraction abstract_inputs(const Network& network, const std::vector<AutonomousInstance>& instances,
                                 const std::vector<InputLevel>& levels, const InputAblations& ablations) {
    return Abstracter(network, instances, levels, ablations).build();
}

void pace(const Network& network, const Network::Process& process, Network::Template& automaton, std::int64_t unit,
          Exprs& exprs) {
    for (Network::Location& location : automaton.locations) location.invariant.clear();
    for (Network::Edge& edge : automaton.edges) {
        edge.urgent = false;
        std::erase_if(edge.constraint, [](const Network::ClockConstraint& constraint) {
            return constraint.relation == Op::Less || constraint.relation == Op::LessEqual;
        });
        for (Network::ClockConstraint& constraint : edge.constraint) {
            const std::int64_t bound = bound_value(network, process, constraint.bound);
            constraint.relation = Op::GreaterEqual;
            constraint.bound = exprs.integer(bound >= unit ? unit : 0);
        }
    }
}

Network in_longest_unit(Network network, const std::vector<Process>& paced) {
    const auto is_paced = [&](Process id) { return std::ranges::find(paced, id) != paced.end(); };
    std::int64_t others = 0, all = 0;
    each_constraint(network, [&](Process id, const Network::ClockConstraint& constraint) {
        const std::int64_t bound = bound_value(network, network.processes[id], constraint.bound);
        all = std::gcd(all, bound);
        if (!is_paced(id)) others = std::gcd(others, bound);
    });
    const std::int64_t unit = std::max<std::int64_t>(others != 0 ? others : all, 1);
    for (const Process id : paced) {
        const Network::Process process = network.processes[id];
        Network::Template automaton = network.templates[process.automaton];
        pace(network, process, automaton, unit, network.exprs);
        network.templates[process.automaton] = std::move(automaton);
    }
    if (unit == 1) return network;
    each_constraint(network, [&](Process id, Network::ClockConstraint& constraint) {
        constraint.bound = network.exprs.integer(bound_value(network, network.processes[id], constraint.bound) / unit);
    });
    network.time_unit_ms *= unit;
    return network;
}

}  // namespace grafverif
