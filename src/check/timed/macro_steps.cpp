// SPDX-License-Identifier: MIT
#include "check/timed/macro_steps.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "ir/network/variables.hpp"
#include "ir/slots.hpp"

namespace grafverif::timed {

namespace {

bool is_observer(const Network& network, Id<Network::Process> id) {
    return network.processes[id].kind == Network::ProcessKind::Observer;
}

/// Determines the static premises of macro-steps for a PLC and its timers.
class CyclePremises {
public:
    CyclePremises(const Network& network, const Network::Controller& controller)
        : network_(network), controller_(controller), plc_(Slots(network, controller.process).automaton) {
        for (const Network::Timer& timer : controller.timers) {
            const Slots slots(network, timer.process);
            for (const Id<Network::Variable> variable : slots.used()) used_.insert(variable);
            for (const Id<Network::Variable> variable : slots.written()) written_.insert(variable);
        }
        // Each move requests that observers read the state. Reading equal states again does not change an observer.
        for (const Id<Network::Process> id : network.processes.ids()) {
            if (!is_observer(network, id)) continue;
            for (const Id<Network::Variable> variable : Slots(network, id).written()) {
                used_.erase(variable);
                written_.erase(variable);
            }
        }
        for (const Network::Timer& timer : controller.timers)
            if (waits_for(Slots(network, timer.process).automaton)) accepting_.push_back(timer.process);
    }

    /// Returns the timers for which the PLC waits in W until they have accepted its request.
    const std::vector<Id<Network::Process>>& accepting_timers() const { return accepting_; }

    /// True if a property reads the location of a timer or a variable that the timers write. Also true if a process
    /// except the PLC and its timers uses such a variable.
    bool are_observed() const {
        const auto is_timer = [&](Id<Network::Process> id) {
            return std::ranges::find(controller_.timers, id, &Network::Timer::process) != controller_.timers.end();
        };
        for (const Id<Network::Process> id : network_.processes.ids())
            if (id != controller_.process && !is_timer(id) &&
                std::ranges::any_of(Slots(network_, id).used(),
                                    [&](auto variable) { return written_.contains(variable); }))
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

    /// Returns, per location of the PLC, whether its edges neither read a variable that the timers write, nor write a
    /// variable that the timers read or write.
    std::vector<bool> independent_locations() const {
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

    /// Returns, per edge of the PLC and per process, whether the process may move after the edge instead of before it.
    /// This requires that the edges of both are independent, and that the process cannot enable or disable another edge
    /// of the PLC. The edge of the PLC must change nothing that an observer or a property reads. The process must not
    /// enable an edge of another process for which the result is false.
    std::vector<std::vector<bool>> movable_processes() const {
        const std::size_t count = network_.processes.size();
        std::vector<Uses> uses(count);
        std::vector<bool> is_other(count);  // true for processes except observers and the PLC
        Variables visible = read_by_properties(), of_observers;
        for (const Id<Network::Process> id : network_.processes.ids()) {
            const Slots slots(network_, id);
            const auto read = slots.read(), written = slots.written();
            is_other[id.index] = !is_observer(network_, id) && id != controller_.process;
            if (is_other[id.index]) uses[id.index] = {{read.begin(), read.end()}, {written.begin(), written.end()}};
            if (!is_observer(network_, id)) continue;
            visible.insert(read.begin(), read.end());
            of_observers.insert(written.begin(), written.end());
        }
        const auto meet = [&](const Variables& left, const Variables& right) {
            return std::ranges::any_of(
                left, [&](auto variable) { return right.contains(variable) && !of_observers.contains(variable); });
        };
        const bool is_visible = is_location_observed();
        std::vector<std::vector<bool>> movable;
        for (const Network::Edge& edge : plc_.edges) {
            std::vector<bool>& may_move = movable.emplace_back(count);
            // The loop is not quiescent while the PLC is not in W or not stable.
            const bool settles = edge.to == controller_.waiting && !has_conjunct(edge.guard, controller_.stable, true);
            const Uses plc = uses_of(edge);
            if (settles || is_visible || meet(plc.written, visible)) continue;
            for (std::size_t i = 0; i < count; ++i)
                may_move[i] = is_other[i] && !meet(plc.written, uses[i].read) && !meet(plc.written, uses[i].written) &&
                              !meet(uses[i].written, plc.read);
            for (bool shrinks = true; std::exchange(shrinks, false);)
                for (std::size_t i = 0; i < count; ++i)
                    for (std::size_t other = 0; other < count && may_move[i]; ++other)
                        if (!may_move[other] && meet(uses[i].written, uses[other].read)) {
                            may_move[i] = false;
                            shrinks = true;
                        }
        }
        return movable;
    }

    /// Returns the outputs that no edge and no property reads while the PLC is within a cycle or not stable.
    std::vector<Id<Network::Variable>> dead_outputs() const {
        const auto is_entered = [&](Id<Network::Location> location) {
            return std::ranges::find(plc_.edges, location, &Network::Edge::to) != plc_.edges.end();
        };
        // Before the first cycle, all outputs have their initial values.
        const bool writes = std::ranges::all_of(plc_.edges, [&](const Network::Edge& edge) {
            return edge.to != controller_.waiting || !is_entered(edge.from) ||
                   has_conjunct(edge.guard, controller_.stable, true) || has_call(edge, controller_.write);
        });
        if (!writes || !controller_.write.valid() || !network_.settled.valid()) return {};
        const Variables read = variables_read();
        std::vector<Id<Network::Variable>> dead;
        for (const Network::Assignment& assignment : plc_.procedures[controller_.write].assignments) {
            const Id<Network::Variable> output{static_cast<std::uint32_t>(network_.exprs[assignment.target].value)};
            if (network_.variables[output].role == Network::Role::Output && !read.contains(output))
                dead.push_back(output);
        }
        return dead;
    }

private:
    using Variables = std::set<Id<Network::Variable>>;
    struct Uses {
        Variables read = {}, written = {};
    };

    bool reads(Id<Expr> term, const Variables& variables) const {
        return std::ranges::any_of(leaves(network_.exprs, term), [&](Id<Expr> leaf) {
            const Expr& node = network_.exprs[leaf];
            return node.op == Op::Variable && variables.contains({static_cast<std::uint32_t>(node.value)});
        });
    }

    bool has_conjunct(Id<Expr> guard, Id<Network::Variable> variable, bool negated) const {
        return grafverif::has_conjunct(network_.exprs, guard, variable, negated);
    }

    /// Returns the variables that a process, the condition of quiescence, or a property that is not only evaluated in
    /// quiescent states reads.
    Variables variables_read() const {
        Variables read = read_by_properties();
        for (const Id<Network::Process> id : network_.processes.ids())
            for (const Id<Network::Variable> variable : Slots(network_, id).read()) read.insert(variable);
        take(network_.settled, read);
        return read;
    }

    /// Returns the variables that properties read, except for properties that are only evaluated in quiescent states.
    Variables read_by_properties() const {
        Variables read;
        for (const Property& property : network_.properties)
            for (const Id<Expr> operand : property.operands)
                if (!property.at_stable) take(operand, read);
        return read;
    }

    void take(Id<Expr> term, Variables& variables) const {
        each_variable(network_.exprs, term, [&](Id<Network::Variable> variable) { variables.insert(variable); });
    }

    /// True if a property that is not only evaluated in quiescent states reads the location of the PLC.
    bool is_location_observed() const {
        return std::ranges::any_of(network_.properties, [&](const Property& property) {
            return !property.at_stable && std::ranges::any_of(property.operands, [&](Id<Expr> term) {
                return std::ranges::any_of(leaves(network_.exprs, term), [&](Id<Expr> leaf) {
                    const Expr& node = network_.exprs[leaf];
                    return node.op == Op::At && at_process(node) == controller_.process.index;
                });
            });
        });
    }

    /// Returns the variables that an edge of the PLC reads and writes, and those that the guards in its location read.
    Uses uses_of(const Network::Edge& edge) const {
        Uses uses;
        for (const Network::Edge& other : plc_.edges)
            if (other.from == edge.from) take(other.guard, uses.read);
        for (const Network::Assignment& assignment : Slots(network_, controller_.process).assignments(edge)) {
            take(assignment.value, uses.read);
            take(assignment.target, uses.written);
        }
        return uses;
    }

    /// True if some variable, the request, enables all urgent edges of the timer, and disables its other edges and the
    /// edges by which the PLC leaves W.
    bool waits_for(const Network::Template& timer) const {
        return std::ranges::any_of(network_.variables.ids(), [&](Id<Network::Variable> request) {
            return std::ranges::all_of(
                       timer.edges,
                       [&](const Network::Edge& edge) { return has_conjunct(edge.guard, request, !edge.urgent); }) &&
                   std::ranges::all_of(plc_.edges, [&](const Network::Edge& edge) {
                       return edge.from != controller_.waiting || has_conjunct(edge.guard, request, true);
                   });
        });
    }

    const Network& network_;
    const Network::Controller& controller_;
    const Network::Template& plc_;
    std::vector<Id<Network::Process>> accepting_ = {};
    Variables used_ = {}, written_ = {};  // variables of the timers
};

/// Returns, per location of the automaton, whether each infinite path from the location passes `waiting`.
std::vector<bool> locations_in_cycle(const Network::Template& automaton, Id<Network::Location> waiting) {
    std::vector<bool> within(automaton.locations.size(), false);
    for (bool grows = true; grows;) {
        grows = false;
        for (const Id<Network::Location> location : automaton.locations.ids()) {
            if (location == waiting || within[location.index]) continue;
            const bool passes = std::ranges::all_of(automaton.edges, [&](const Network::Edge& edge) {
                return edge.from != location || edge.to == waiting || within[edge.to.index];
            });
            if (passes) within[location.index] = grows = true;
        }
    }
    return within;
}

}  // namespace

MacroSteps::MacroSteps(const Machine& machine, PropertyMonitor monitor, std::vector<Field> races,
                       const MacroStepOptions& options)
    : machine_(&machine), monitor_(std::move(monitor)), races_(std::move(races)), without_(options.without) {
    const Network& network = machine.network();
    deferred_.resize(network.processes.size());
    for (const Id<Network::Process> id : network.processes.ids()) observers_.push_back(is_observer(network, id));
    accepts_.assign(network.processes.size(), none);
    for (const Network::Controller& controller : network.controllers) {
        Cycle cycle{.process = controller.process.index,
                    .within = locations_in_cycle(Slots(network, controller.process).automaton, controller.waiting)};
        const CyclePremises premises(network, controller);
        if (without_.timers || !premises.are_observed()) {
            for (const Id<Network::Process> timer : premises.accepting_timers()) accepts_[timer.index] = cycles_.size();
            for (const Network::Timer& timer : controller.timers)
                deferred_[timer.process.index] =
                    std::ranges::find(options.deferred, timer.process) != options.deferred.end();
        }
        cycle.independent = premises.independent_locations();
        cycle.movable = premises.movable_processes();
        cycle.waiting = controller.waiting.index;
        cycle.stable = machine.layout().variables[controller.stable.index];
        for (const Id<Network::Variable> output : premises.dead_outputs())
            cycle.outputs.push_back({machine.layout().variables[output.index], network.variables[output].initial});
        cycles_.push_back(std::move(cycle));
    }
}

/// Keeps only the moves for which `keeps(edge)` is true.
template <class Keeps>
void MacroSteps::keep(Moves& moves, const Keeps& keeps) const {
    const std::size_t size = machine_->layout().words, choices = machine_->choices().size();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < moves.edges.size(); ++i) {
        if (!keeps(moves.edges[i])) continue;
        moves.edges[kept] = moves.edges[i];
        if (kept != i) std::copy_n(moves.words.data() + i * size, size, moves.words.data() + kept * size);
        if (kept != i && moves.record_choices)
            std::copy_n(moves.chosen.data() + i * choices, choices, moves.chosen.data() + kept * choices);
        ++kept;
    }
    moves.edges.resize(kept);
}

/// Returns the index of the PLC that is within a cycle, or `none`.
std::size_t MacroSteps::cycle_of(const Word* words) const {
    for (std::size_t i = 0; i < cycles_.size(); ++i)
        if (cycles_[i].within[location_of(cycles_[i].process, words)]) return i;
    return none;
}

std::size_t MacroSteps::location_of(std::uint32_t process, const Word* words) const {
    return static_cast<std::size_t>(machine_->layout().locations[process].get(words));
}

/// Computes the moves of the state. Returns true if it is transient and has no model error; `moves` then contains only
/// the moves by which macro-steps continue.
bool MacroSteps::is_transient(const Word* words, Moves& moves) const {
    if (std::ranges::any_of(races_, [&](const Field& race) { return race.raw(words) != 0; })) return false;
    machine_->expand(words, moves);
    if (moves.fault || moves.cut) return false;
    const auto process_of = [&](std::uint32_t edge) { return machine_->process_of(edge).index; };
    // Only observers can move: they read the state that the last move has reached.
    const auto is_observer = [&](std::uint32_t edge) { return observers_[process_of(edge)]; };
    if (moves.urgent && std::ranges::all_of(moves.edges, is_observer)) return true;
    // Requests to timers are accepted first, one timer at a time.
    const auto accepts = [&](std::uint32_t edge) {
        return accepts_[process_of(edge)] != none && machine_->urgent(edge);
    };
    const std::size_t index = cycle_of(words);
    if (index == none) {
        const auto first = std::ranges::find_if(moves.edges, accepts);
        if (first == moves.edges.end()) return false;
        keep(moves, [&, process = process_of(*first)](std::uint32_t edge) { return process_of(edge) == process; });
        return true;
    }
    const Cycle& cycle = cycles_[index];
    const bool independent = cycle.independent[location_of(cycle.process, words)];
    const auto is_of_plc = [&](std::uint32_t edge) { return process_of(edge) == cycle.process; };
    const auto may_wait = [&](std::uint32_t process) {
        return std::ranges::all_of(moves.edges, [&](std::uint32_t edge) {
            return !is_of_plc(edge) || cycle.movable[machine_->edge_of(edge).index][process];
        });
    };
    for (const std::uint32_t edge : moves.edges) {
        const bool urgent = machine_->urgent(edge);
        if (is_of_plc(edge) ? urgent : without_.processes) continue;
        const std::uint32_t process = process_of(edge);
        const bool waits = urgent ? independent && accepts_[process] == index : deferred_[process];
        if (!waits && !may_wait(process)) return false;
    }
    keep(moves, is_of_plc);
    return !moves.edges.empty();
}

/// True if each search that the state decides is also decided by `first` or by a successor of the state.
bool MacroSteps::is_covered(const Word* words, const Moves& moves, const Word* first, Buffers& buffers) const {
    if (without_.properties || !monitor_.needs(*machine_, words, buffers.made.registers)) return true;
    if (!monitor_.mark(*machine_, words, buffers.made.registers, buffers.marks)) return false;
    const auto remove = [&](const Word* other) {
        monitor_.mark(*machine_, other, buffers.made.registers, buffers.others);
        bool rest = false;
        for (std::size_t i = 0; i < buffers.marks.size(); ++i)
            rest = (buffers.marks[i] &= ~buffers.others[i]) != 0 || rest;
        return !rest;
    };
    if (remove(first)) return true;
    for (std::size_t i = 0; i < moves.edges.size(); ++i)
        if (remove(moves.words.data() + i * machine_->layout().words)) return true;
    return false;
}

/// Gives outputs whose values are not relevant in the state their initial values, so that equivalent states are equal.
void MacroSteps::normalize(Word* words) const {
    for (const Cycle& cycle : cycles_) {
        const std::size_t location = location_of(cycle.process, words);
        if (!cycle.within[location] && (location != cycle.waiting || cycle.stable.raw(words) != 0)) continue;
        for (const Reset& output : cycle.outputs) output.field.set(words, output.value);
    }
}

/// Appends the successors of a macro-step that begins with `edge` and has reached the state `words`.
void MacroSteps::append(Word* words, std::uint32_t edge, std::size_t depth, const Word* first, Buffers& buffers) const {
    normalize(words);
    if (!buffers.known->add(words).is_new) return;
    if (buffers.levels.size() <= depth) buffers.levels.resize(depth + 1);
    Moves moves = std::move(buffers.levels[depth]);
    const std::size_t size = machine_->layout().words;
    if (is_transient(words, moves) && is_covered(words, moves, first, buffers)) {
        buffers.computed += moves.edges.size();
        for (std::size_t i = 0; i < moves.edges.size(); ++i)
            append(moves.words.data() + i * size, edge, depth + 1, first, buffers);
    } else {
        buffers.made.edges.push_back(edge);
        buffers.made.words.insert(buffers.made.words.end(), words, words + size);
    }
    buffers.levels[depth] = std::move(moves);
}

std::size_t MacroSteps::expand(const Word* words, Moves& moves, Buffers& buffers) const {
    machine_->expand(words, moves);
    buffers.computed = moves.edges.size();
    const std::size_t size = machine_->layout().words;
    buffers.made.registers.resize(std::max(buffers.made.registers.size(), moves.registers.size()));
    buffers.made.edges.clear();
    buffers.made.words.clear();
    if (buffers.known) buffers.known->clear();
    else buffers.known.emplace(machine_->layout().stored);
    for (std::size_t i = 0; i < moves.edges.size(); ++i)
        append(moves.words.data() + i * size, moves.edges[i], 0, words, buffers);
    std::swap(moves.edges, buffers.made.edges);
    std::swap(moves.words, buffers.made.words);
    return buffers.computed;
}

bool MacroSteps::are_equivalent(const Word* words, const Word* stored) const {
    std::vector<Word> normal(words, words + machine_->layout().words);
    normalize(normal.data());
    return std::equal(stored, stored + machine_->layout().stored, normal.begin());
}

/// Searches for the moves of a macro-step from `words`, a state after `steps`, to `to`. Appends the moves to `steps`.
bool MacroSteps::find(const Word* words, const Word* to, PackedStates& visited, std::vector<Step>& steps) const {
    const Layout& layout = machine_->layout();
    Moves moves;
    moves.record_choices = true;
    if (steps.empty()) machine_->expand(words, moves);
    else if (!visited.add(words).is_new || !is_transient(words, moves)) return false;
    const std::size_t choices = machine_->choices().size();
    for (const bool last : {true, false}) {
        for (std::size_t i = 0; i < moves.edges.size(); ++i) {
            const Word* const next = moves.words.data() + i * layout.words;
            if (last && !are_equivalent(next, to)) continue;
            const auto chosen = moves.chosen.begin() + static_cast<std::ptrdiff_t>(i * choices);
            steps.push_back({.edge = moves.edges[i],
                             .words = {next, next + layout.words},
                             .chosen = {chosen, chosen + static_cast<std::ptrdiff_t>(choices)}});
            if (last || find(next, to, visited, steps)) return true;
            steps.pop_back();
        }
    }
    return false;
}

std::vector<MacroSteps::Step> MacroSteps::between(const Word* from, const Word* to) const {
    std::vector<Step> steps;
    PackedStates visited(machine_->layout().stored);
    find(from, to, visited, steps);
    return steps;
}

}  // namespace grafverif::timed
