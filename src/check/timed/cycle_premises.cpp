// SPDX-License-Identifier: MIT
#include "check/timed/cycle_premises.hpp"

#include <algorithm>
#include <utility>

#include "ir/network/variables.hpp"

namespace grafverif::timed {

bool is_observer(const Network& network, Id<Network::Process> id) {
    return network.processes[id].kind == Network::ProcessKind::Observer;
}

CyclePremises::CyclePremises(const Network& network, const Network::Controller& controller)
    : network_(network), controller_(controller), plc_(Slots(network, controller.process).automaton) {
    for (const Network::Timer& timer : controller.timers) {
        const Slots slots(network, timer.process);
        for (const Id<Network::Variable> variable : slots.used()) used_.insert(variable);
        for (const Id<Network::Variable> variable : slots.written()) written_.insert(variable);
    }
    for (const Id<Network::Process> id : network.processes.ids()) {
        const Slots slots(network, id);
        const auto read = slots.read(), written = slots.written();
        is_other_.push_back(!is_observer(network, id) && id != controller.process);
        uses_.emplace_back();
        if (is_other_.back()) uses_.back() = {{read.begin(), read.end()}, {written.begin(), written.end()}};
        if (!is_observer(network, id)) continue;
        seen_by_observers_.insert(read.begin(), read.end());
        of_observers_.insert(written.begin(), written.end());
    }
    // The variables that observers write do not count: each move writes such a variable, to request that observers read
    // the state, and reading equal states again does not change an observer.
    for (const Id<Network::Variable> variable : of_observers_) {
        used_.erase(variable);
        written_.erase(variable);
    }
    for (const Network::Timer& timer : controller.timers)
        if (waits_for(Slots(network, timer.process).automaton)) accepting_.push_back(timer.process);
}

bool CyclePremises::timers_are_observed() const {
    const auto is_timer = [&](Id<Network::Process> id) {
        return std::ranges::find(controller_.timers, id, &Network::Timer::process) != controller_.timers.end();
    };
    for (const Id<Network::Process> id : network_.processes.ids())
        if (id != controller_.process && !is_timer(id) &&
            std::ranges::any_of(Slots(network_, id).used(), [&](auto variable) { return written_.contains(variable); }))
            return true;
    return std::ranges::any_of(network_.properties, [&](const Property& property) {
        return std::ranges::any_of(property.operands, [&](Id<Expr> term) {
            return reads(term, written_) || std::ranges::any_of(leaves(network_.exprs, term), [&](Id<Expr> leaf) {
                       const Expr& node = network_.exprs[leaf];
                       return node.op == Op::At && is_timer({at_process(node)});
                   });
        });
    });
}

std::vector<bool> CyclePremises::locations_in_cycle() const {
    std::vector<bool> within(plc_.locations.size(), false);
    for (bool grows = true; grows;) {
        grows = false;
        for (const Id<Network::Location> location : plc_.locations.ids()) {
            if (location == controller_.waiting || within[location.index]) continue;
            const bool passes = std::ranges::all_of(plc_.edges, [&](const Network::Edge& edge) {
                return edge.from != location || edge.to == controller_.waiting || within[edge.to.index];
            });
            if (passes) within[location.index] = grows = true;
        }
    }
    return within;
}

std::vector<bool> CyclePremises::independent_locations() const {
    std::vector<bool> independent(plc_.locations.size(), true);
    const Slots slots(network_, controller_.process);
    for (const Network::Edge& edge : plc_.edges) {
        bool depends = reads(edge.guard, written_);
        for (const Network::Assignment& assignment : slots.assignments(edge))
            depends = depends || reads(assignment.value, written_) || reads(assignment.target, used_);
        if (depends) independent[edge.from.index] = false;
    }
    return independent;
}

std::vector<bool> CyclePremises::locations_like_waiting() const {
    std::vector<bool> like(plc_.locations.size(), false);
    const Variables flags = requests();
    if (is_location_observed() || is_quiescence_observed() || meet(read_by_properties(), flags)) return like;
    for (const Uses& uses : uses_)
        if (meet(uses.read, flags)) return like;
    const auto only_requests = [&](const Network::Edge& edge) {
        return edge.from == controller_.waiting && edge.constraint.empty() && edge.resets.empty() &&
               std::ranges::all_of(uses_of(edge).written, [&](auto variable) {
                   return flags.contains(variable) || of_observers_.contains(variable);
               });
    };
    for (const Id<Network::Location> location : plc_.locations.ids())
        like[location.index] = location != controller_.waiting && is_entered(location) &&
                               std::ranges::all_of(plc_.edges, [&](const Network::Edge& edge) {
                                   return edge.to != location || only_requests(edge);
                               });
    return like;
}

std::vector<Independence> CyclePremises::independence() const {
    const std::size_t count = network_.processes.size();
    Variables visible = read_by_properties();
    visible.insert(seen_by_observers_.begin(), seen_by_observers_.end());
    const bool is_visible = is_location_observed(), is_quiescence_visible = is_quiescence_observed();
    Variables read_elsewhere = visible;
    for (const Uses& uses : uses_) read_elsewhere.insert(uses.read.begin(), uses.read.end());
    std::vector<Independence> result;
    for (const Network::Edge& edge : plc_.edges) {
        Independence made{std::vector<bool>(count), std::vector<bool>(count), {}};
        // The loop can be quiescent only while the PLC is in its waiting location W and stable.
        const bool settles =
            edge.to == controller_.waiting && !has_conjunct(network_.exprs, edge.guard, controller_.stable, true);
        const Uses plc = uses_of(edge);
        for (const Id<Network::Variable> variable : plc.written)
            if (read_elsewhere.contains(variable) && !of_observers_.contains(variable)) made.shared.push_back(variable);
        for (std::size_t i = 0; i < count && !is_visible; ++i) {
            const bool unchanged =
                is_other_[i] && !meet(plc.written, uses_[i].written) && !meet(uses_[i].written, plc.read);
            made.if_unchanged[i] = unchanged && !(settles && is_quiescence_visible);
            made.always[i] = unchanged && !settles && !meet(plc.written, visible) && !meet(plc.written, uses_[i].read);
        }
        made.if_unchanged = closed(std::move(made.if_unchanged));
        made.always = closed(std::move(made.always));
        result.push_back(std::move(made));
    }
    return result;
}

std::vector<Id<Network::Variable>> CyclePremises::dead_outputs() const {
    // True if each cycle that ends in a stable situation writes the outputs. Edges before the first cycle need not
    // write the outputs, because all outputs still have their initial values.
    const bool writes = std::ranges::all_of(plc_.edges, [&](const Network::Edge& edge) {
        return edge.to != controller_.waiting || !is_entered(edge.from) ||
               has_conjunct(network_.exprs, edge.guard, controller_.stable, true) || has_call(edge, controller_.write);
    });
    if (!writes || !controller_.write.valid() || !network_.settled.valid()) return {};
    const Variables read = variables_read();
    std::vector<Id<Network::Variable>> dead;
    for (const Network::Assignment& assignment : plc_.procedures[controller_.write].assignments) {
        const Id<Network::Variable> output{static_cast<std::uint32_t>(network_.exprs[assignment.target].value)};
        if (network_.variables[output].role == Network::Role::Output && !read.contains(output)) dead.push_back(output);
    }
    return dead;
}

/// True if an edge leads to the location. False for the location before the first evolution.
bool CyclePremises::is_entered(Id<Network::Location> location) const {
    return std::ranges::find(plc_.edges, location, &Network::Edge::to) != plc_.edges.end();
}

bool CyclePremises::reads(Id<Expr> term, const Variables& variables) const {
    return std::ranges::any_of(leaves(network_.exprs, term), [&](Id<Expr> leaf) {
        const Expr& node = network_.exprs[leaf];
        return node.op == Op::Variable && variables.contains({static_cast<std::uint32_t>(node.value)});
    });
}

/// True if the two sets have a common variable that no observer writes.
bool CyclePremises::meet(const Variables& left, const Variables& right) const {
    return std::ranges::any_of(
        left, [&](auto variable) { return right.contains(variable) && !of_observers_.contains(variable); });
}

/// Removes processes from the set `processes` until no process of the set writes a variable that a process outside of
/// the set reads.
std::vector<bool> CyclePremises::closed(std::vector<bool> processes) const {
    for (bool shrinks = true; std::exchange(shrinks, false);)
        for (std::size_t i = 0; i < processes.size(); ++i)
            for (std::size_t other = 0; other < processes.size() && processes[i]; ++other)
                if (!processes[other] && meet(uses_[i].written, uses_[other].read)) {
                    processes[i] = false;
                    shrinks = true;
                }
    return processes;
}

/// Returns all variables that processes, the condition of quiescence, or properties without `at stable` read.
CyclePremises::Variables CyclePremises::variables_read() const {
    Variables read = read_by_properties();
    for (const Id<Network::Process> id : network_.processes.ids())
        for (const Id<Network::Variable> variable : Slots(network_, id).read()) read.insert(variable);
    take(network_.settled, read);
    return read;
}

/// Returns the variables that properties without `at stable` read. (A property with `at stable` is evaluated only in
/// quiescent states.)
CyclePremises::Variables CyclePremises::read_by_properties() const {
    Variables read;
    for (const Property& property : network_.properties)
        for (const Id<Expr> operand : property.operands)
            if (!property.at_stable) take(operand, read);
    return read;
}

void CyclePremises::take(Id<Expr> term, Variables& variables) const {
    each_variable(network_.exprs, term, [&](Id<Network::Variable> variable) { variables.insert(variable); });
}

/// True if a property without `at stable` reads the location of the PLC.
bool CyclePremises::is_location_observed() const {
    return std::ranges::any_of(network_.properties, [&](const Property& property) {
        return !property.at_stable && std::ranges::any_of(property.operands, [&](Id<Expr> term) {
            return std::ranges::any_of(leaves(network_.exprs, term), [&](Id<Expr> leaf) {
                const Expr& node = network_.exprs[leaf];
                return node.op == Op::At && at_process(node) == controller_.process.index;
            });
        });
    });
}

/// True if an observer reads a flag of the PLC and therefore depends on whether the loop is quiescent. The condition of
/// quiescence consists of these flags.
bool CyclePremises::is_quiescence_observed() const {
    Variables flags = requests();
    flags.insert(controller_.stable);
    return meet(flags, seen_by_observers_);
}

/// Returns the flags EVOL_PL and EVOL_TI, by which the plant and the timers request a cycle of the PLC.
CyclePremises::Variables CyclePremises::requests() const {
    Variables flags;
    for (const Network::Edge& edge : plc_.edges)
        if (edge.from == controller_.waiting)
            each_variable(network_.exprs, edge.guard, [&](Id<Network::Variable> variable) {
                if (network_.variables[variable].role == Network::Role::Flag && variable != controller_.stable &&
                    variable != network_.race)
                    flags.insert(variable);
            });
    return flags;
}

/// Returns the variables that an edge of the PLC reads and writes. The result also contains the variables that the
/// guards of other edges with the same source location read.
CyclePremises::Uses CyclePremises::uses_of(const Network::Edge& edge) const {
    Uses uses;
    for (const Network::Edge& other : plc_.edges)
        if (other.from == edge.from) take(other.guard, uses.read);
    for (const Network::Assignment& assignment : Slots(network_, controller_.process).assignments(edge)) {
        take(assignment.value, uses.read);
        take(assignment.target, uses.written);
    }
    return uses;
}

/// True if a request variable of the timer exists: the variable enables all urgent edges of the timer, and disables the
/// other edges of the timer and the edges by which the PLC leaves its waiting location W.
bool CyclePremises::waits_for(const Network::Template& timer) const {
    const auto has = [&](const Network::Edge& edge, Id<Network::Variable> variable, bool negated) {
        return has_conjunct(network_.exprs, edge.guard, variable, negated);
    };
    return std::ranges::any_of(network_.variables.ids(), [&](Id<Network::Variable> request) {
        return std::ranges::all_of(timer.edges,
                                   [&](const Network::Edge& edge) { return has(edge, request, !edge.urgent); }) &&
               std::ranges::all_of(plc_.edges, [&](const Network::Edge& edge) {
                   return edge.from != controller_.waiting || has(edge, request, true);
               });
    });
}

}  // namespace grafverif::timed
