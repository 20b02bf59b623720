// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cassert>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "ir/junction.hpp"
#include "ir/network/dead_values.hpp"
#include "ir/network/variables.hpp"
#include "ir/network_inputs.hpp"
#include "ir/slots.hpp"

namespace grafverif {

namespace {

class Abstracter {
public:
    Abstracter(const Network& network, const std::vector<AbstractableProcess>& instances,
               const std::vector<InputLevel>& levels, const InputAblations& ablations, ChoiceLifetime lifetime)
        : instances_(instances), levels_(levels), ablations_(ablations), lifetime_(lifetime) {
        made_.network = network;
    }

    InputAbstraction build() {
        for (std::size_t i = 0; i < instances_.size(); ++i) {
            if (levels_[i] == InputLevel::Untimed) make_untimed(instances_[i].process);
            if (levels_[i] == InputLevel::Paced) made_.paced.push_back(instances_[i].process);
            if (levels_[i] == InputLevel::Chosen) remove(i);
        }
        for (const Id<Network::Controller> id : made_.network.controllers.ids()) choose_in(id);
        if (!ablations_.keep_quiescence) weaken_quiescence();
        return std::move(made_);
    }

private:
    Network::Template& automaton(Id<Network::Process> id) {
        return made_.network.templates[made_.network.processes[id].automaton];
    }

    void make_untimed(Id<Network::Process> id) {
        const bool is_timer = made_.network.processes[id].kind == Network::ProcessKind::Timer;
        for (Network::Edge& edge : automaton(id).edges) {
            if (lifetime_ == ChoiceLifetime::Evolution && !is_timer) edge.urgent = false;
            if (ablations_.urgent_on_clocks && !edge.constraint.empty()) edge.urgent = true;
        }
        if (is_timer && lifetime_ == ChoiceLifetime::Cycle) defer(id);
        ignore_clocks(automaton(id));
    }

    /// Adds the timer to InputAbstraction::deferred. A cycle of the PLC may begin as if the timer had set EVOL_TI, the
    /// request of a cycle.
    void defer(Id<Network::Process> timer) {
        made_.deferred.push_back(timer);
        for (const Network::Edge& edge : automaton(timer).edges) {
            if (edge.urgent) continue;
            for (const Network::Assignment& assignment : edge.assignments)
                woken_.insert(variable_of(made_.network.exprs, assignment.target));
        }
    }

    void remove(std::size_t instance) {
        Network::Template& removed = automaton(instances_[instance].process);
        for (const Network::Edge& edge : removed.edges)
            for (const Network::Assignment& assignment : edge.assignments)
                woken_.insert(variable_of(made_.network.exprs, assignment.target));
        ignore_clocks(removed);
        removed.edges = {};
        removed_.push_back(instances_[instance].process);
        for (const Id<Network::Variable> variable : instances_[instance].outputs) chosen_.emplace(variable, instance);
    }

    /// Removes the conjuncts that read Chosen instances from the condition of quiescence.
    void weaken_quiescence() {
        if (!made_.network.settled.valid()) return;
        const auto is_chosen = [&](Id<Expr> leaf) {
            const Expr& node = made_.network.exprs[leaf];
            if (node.op == Op::Variable) return chosen_.contains(variable_of(made_.network.exprs, leaf));
            return node.op == Op::At && std::ranges::any_of(removed_, [&](Id<Network::Process> process) {
                       return process.index == at_process(node);
                   });
        };
        std::vector<Id<Expr>> kept;
        for (const Id<Expr> conjunct : operands_of(made_.network.exprs, made_.network.settled, Op::And))
            if (std::ranges::none_of(leaves(made_.network.exprs, conjunct), is_chosen)) kept.push_back(conjunct);
        made_.network.settled = made_.network.exprs.conjunction(kept);
    }

    void choose_in(Id<Network::Controller> id) {
        const Network::Controller& controller = made_.network.controllers[id];
        Network::Template& plc = automaton(controller.process);
        read_inputs_for_samples(plc);
        if (lifetime_ == ChoiceLifetime::Cycle) clear_dead_values(made_.network, id, ablations_.ignore_readings);
        const std::size_t first = made_.choices.size();
        std::set<std::size_t> read;  // instances that the edges of the PLC read
        for (const Network::Edge& edge : plc.edges)
            each_read(controller.process, edge, [&](std::size_t instance) {
                if (!read.insert(instance).second) return;
                made_.choices.push_back(
                    {instance, controller.process, instances_[instance].read_outputs, valuations(instance)});
            });
        for (std::size_t choice = first; choice < made_.choices.size(); ++choice)
            keep(controller, made_.choices[choice]);
        if (lifetime_ != ChoiceLifetime::Cycle) move_instances(controller, plc);
        if (!ablations_.no_cycle_on_change) begin_cycles(controller, plc);
    }

    std::vector<std::vector<std::int64_t>> valuations(std::size_t instance) const {
        if (!ablations_.initial_values) return instances_[instance].valuations;
        std::vector<std::int64_t> initial;
        for (const Id<Network::Variable> variable : instances_[instance].read_outputs)
            initial.push_back(made_.network.variables[variable].initial);
        return {initial};
    }

    template <class Visit>
    void each_read(Id<Network::Process> plc, const Network::Edge& edge, const Visit& visit) {
        for (const Network::Assignment& assignment : Slots(made_.network, plc).assignments(edge))
            each_variable(made_.network.exprs, assignment.value, [&](Id<Network::Variable> variable) {
                if (const auto found = chosen_.find(variable); found != chosen_.end()) visit(found->second);
            });
    }

    /// In edges that read a sample, replaces the sample by the input. The replacement is equivalent, because the set of
    /// possible valuations has the same lifetime as the sample.
    void read_inputs_for_samples(Network::Template& plc) {
        std::map<Id<Network::Variable>, Id<Network::Variable>> input_of;
        const Exprs& exprs = made_.network.exprs;
        const auto each_list = [&](const auto& visit) {
            for (Network::Procedure& procedure : plc.procedures) visit(procedure.assignments);
            for (Network::Edge& edge : plc.edges) visit(edge.assignments);
        };
        each_list([&](std::vector<Network::Assignment>& list) {
            for (const Network::Assignment& assignment : list) {
                const Id<Network::Variable> target = variable_of(exprs, assignment.target);
                if (made_.network.variables[target].role != Network::Role::Sample) continue;
                if (exprs[assignment.value].op != Op::Variable) continue;
                const Id<Network::Variable> input = variable_of(exprs, assignment.value);
                if (chosen_.contains(input)) input_of.emplace(target, input);
            }
        });
        if (input_of.empty()) return;
        const Exprs from = exprs;  // a copy, because the table `exprs` grows
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

    /// Determines the part of the cycle in which the set of possible valuations must be stored: from a sampling to the
    /// last edge that reads one of the variables of `choice`.
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
        if (lifetime_ != ChoiceLifetime::Cycle) {
            live_.push_back(std::move(live));
            choice.kept = true;
            choice.until_delay = lifetime_ == ChoiceLifetime::Instant;
            if (choice.until_delay) return;
            choice.stable = controller.stable;
            choice.waiting = controller.waiting;
            return;
        }
        for (const Id<Network::Edge> id : plc.edges.ids())
            if (!live[plc.edges[id].to.index]) choice.widened.push_back(id);
    }

    /// Adds edges that make all valuations possible again between two cycles, because an instance may move at any time.
    void move_instances(const Network::Controller& controller, Network::Template& plc) {
        for (const Id<Network::Location> location : plc.locations.ids()) {
            std::vector<InputChoice*> free;
            for (std::size_t i = 0; i < made_.choices.size(); ++i)
                if (made_.choices[i].plc == controller.process && !live_[i][location.index])
                    free.push_back(&made_.choices[i]);
            if (free.empty()) continue;
            const Id<Network::Edge> edge =
                plc.edges.add({.from = location, .to = location, .guard = made_.network.exprs.constant(true)});
            for (InputChoice* const choice : free) choice->widened.push_back(edge);
        }
    }

    /// Allows a cycle to begin in W even if no other process requests a cycle, because events that set EVOL_PL may
    /// occur at any time.
    void begin_cycles(const Network::Controller& controller, Network::Template& plc) {
        Exprs& exprs = made_.network.exprs;
        std::vector<Network::Edge> more;
        for (const Network::Edge& edge : plc.edges) {
            if (edge.from != controller.waiting || !edge.urgent) continue;
            const Exprs from = exprs;  // a copy, because the table `exprs` grows
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
        if (!more.empty()) made_.unprompted.push_back(controller.process);
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

    const std::vector<AbstractableProcess>& instances_;
    const std::vector<InputLevel>& levels_;
    const InputAblations& ablations_;
    const ChoiceLifetime lifetime_;
    std::vector<Id<Network::Process>> removed_ = {};
    std::set<Id<Network::Variable>> woken_ = {};  // flags of PLCs that Chosen instances set

    // Outputs of Chosen instances, with the index of their choice.
    std::map<Id<Network::Variable>, std::size_t> chosen_ = {};
    // Per choice and per location of its PLC: true if the cycle reads a variable of the choice after this location.
    std::vector<std::vector<bool>> live_ = {};
    InputAbstraction made_ = {};
};

/// Calls `visit` for each clock constraint of the network.
template <class Of, class Visit>
void each_constraint(Of& network, const Visit& visit) {
    for (const Id<Network::Process> id : network.processes.ids()) {
        auto& automaton = network.templates[network.processes[id].automaton];
        for (auto& location : automaton.locations)
            for (auto& constraint : location.invariant) visit(id, constraint);
        for (auto& edge : automaton.edges)
            for (auto& constraint : edge.constraint) visit(id, constraint);
    }
}

/// Implements in_longest_unit and, if `inward` is true, in_longer_unit.
Network in_unit(Network network, const std::vector<Id<Network::Process>>& paced,
                const std::vector<Id<Network::Process>>& rounded, bool inward) {
    const auto is_in = [](const std::vector<Id<Network::Process>>& list, Id<Network::Process> id) {
        return std::ranges::find(list, id) != list.end();
    };
    std::int64_t others = 0, not_paced = 0, all = 0;
    each_constraint(network, [&](Id<Network::Process> id, const Network::ClockConstraint& constraint) {
        const std::int64_t bound = bound_value(network, network.processes[id], constraint.bound);
        all = std::gcd(all, bound);
        if (is_in(paced, id)) return;
        not_paced = std::gcd(not_paced, bound);
        if (!is_in(rounded, id)) others = std::gcd(others, bound);
    });
    const std::int64_t unit = std::max<std::int64_t>(others != 0 ? others : not_paced != 0 ? not_paced : all, 1);
    for (const Id<Network::Process> id : paced) {
        const Network::Process process = network.processes[id];
        Network::Template automaton = network.templates[process.automaton];
        pace(network, process, automaton, unit, network.exprs);
        network.templates[process.automaton] = std::move(automaton);
    }
    if (unit == 1) return network;
    each_constraint(network, [&](Id<Network::Process> id, Network::ClockConstraint& constraint) {
        const std::int64_t bound = bound_value(network, network.processes[id], constraint.bound);
        const bool upper = constraint.relation == Op::Less || constraint.relation == Op::LessEqual;
        assert(bound % unit == 0 || (is_in(rounded, id) && constraint.relation != Op::Equal));
        constraint.bound = network.exprs.integer(upper == inward ? bound / unit : (bound + unit - 1) / unit);
    });
    network.time_unit_ms *= unit;
    return network;
}

}  // namespace

InputLevel next_level(const AbstractableProcess& process, InputLevel level) {
    if (level == InputLevel::Chosen) return InputLevel::Untimed;
    return level == InputLevel::Untimed && process.autonomous ? InputLevel::Paced : InputLevel::Complete;
}

void store_what_is_read(const std::vector<AbstractableProcess>& processes, std::vector<InputLevel>& levels) {
    const auto is_stored = [&](Id<Network::Process> reader) {
        const auto found = std::ranges::find(processes, reader, &AbstractableProcess::process);
        return found == processes.end() ||
               levels[static_cast<std::size_t>(found - processes.begin())] != InputLevel::Chosen;
    };
    for (bool changes = true; changes;) {
        changes = false;
        for (std::size_t i = 0; i < processes.size(); ++i) {
            if (levels[i] != InputLevel::Chosen || std::ranges::none_of(processes[i].readers, is_stored)) continue;
            levels[i] = InputLevel::Untimed;
            changes = true;
        }
    }
}

InputAbstraction abstract_inputs(const Network& network, const std::vector<AbstractableProcess>& instances,
                                 const std::vector<InputLevel>& levels, const InputAblations& ablations,
                                 ChoiceLifetime lifetime) {
    return Abstracter(network, instances, levels, ablations, lifetime).build();
}

void ignore_clocks(Network::Template& automaton) {
    for (Network::Location& location : automaton.locations) location.invariant.clear();
    for (Network::Edge& edge : automaton.edges) {
        edge.constraint.clear();
        edge.resets.clear();
    }
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

Network in_longest_unit(Network network, const std::vector<Id<Network::Process>>& paced,
                        const std::vector<Id<Network::Process>>& rounded, const InputAblations& ablations) {
    return in_unit(std::move(network), paced, rounded, ablations.round_inward);
}

Network in_longer_unit(Network network, const std::vector<AbstractableProcess>& instances) {
    std::set<Id<Network::Process>> exact;
    each_constraint(network, [&](Id<Network::Process> id, const Network::ClockConstraint& constraint) {
        if (constraint.relation == Op::Equal) exact.insert(id);
    });
    std::vector<Id<Network::Process>> rounded;
    for (const AbstractableProcess& instance : instances)
        if (instance.autonomous && !exact.contains(instance.process)) rounded.push_back(instance.process);
    return in_unit(std::move(network), {}, rounded, true);
}

}  // namespace grafverif
