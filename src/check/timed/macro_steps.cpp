// SPDX-License-Identifier: MIT
#include "check/timed/macro_steps.hpp"

#include <algorithm>
#include <utility>

#include "check/timed/cycle_premises.hpp"

namespace grafverif::timed {

MacroSteps::MacroSteps(const Machine& machine, PropertyMonitor monitor, std::vector<Field> races,
                       const MacroStepOptions& options)
    : machine_(&machine), monitor_(std::move(monitor)), races_(std::move(races)), without_(options.without) {
    const Network& network = machine.network();
    deferred_.resize(network.processes.size());
    for (const Id<Network::Process> id : network.processes.ids()) observers_.push_back(is_observer(network, id));
    accepts_.assign(network.processes.size(), none);
    for (const Network::Controller& controller : network.controllers) {
        const CyclePremises premises(network, controller);
        Cycle cycle{.process = controller.process.index, .within = premises.locations_in_cycle()};
        if (without_.timers || !premises.timers_are_observed()) {
            for (const Id<Network::Process> timer : premises.accepting_timers()) accepts_[timer.index] = cycles_.size();
            for (const Network::Timer& timer : controller.timers)
                deferred_[timer.process.index] =
                    std::ranges::find(options.deferred, timer.process) != options.deferred.end();
        }
        cycle.independent = premises.independent_locations();
        for (const Independence& edge : premises.independence()) {
            cycle.edges.push_back({edge.always, edge.if_unchanged, {}});
            for (const Id<Network::Variable> variable : edge.shared)
                if (!without_.changes) cycle.edges.back().shared.push_back(machine.layout().variables[variable.index]);
        }
        cycle.like_waiting.resize(cycle.within.size());
        if (std::ranges::find(options.unprompted, controller.process) != options.unprompted.end())
            cycle.like_waiting = premises.locations_like_waiting();
        cycle.waiting = controller.waiting.index;
        cycle.stable = machine.layout().variables[controller.stable.index];
        for (const Id<Network::Variable> output : premises.dead_outputs())
            cycle.outputs.push_back({machine.layout().variables[output.index], network.variables[output].initial});
        cycles_.push_back(std::move(cycle));
    }
    for (std::uint32_t process = 0; process < observers_.size(); ++process)
        if (observers_[process] || accepts_[process] != none) prompt_.push_back(process);
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

/// Returns the index (in `cycles_`) of a PLC that is within a cycle, or `none` if no PLC is within a cycle.
std::size_t MacroSteps::cycle_of(const Word* words) const {
    for (std::size_t i = 0; i < cycles_.size(); ++i)
        if (cycles_[i].within[location_of(cycles_[i].process, words)]) return i;
    return none;
}

std::size_t MacroSteps::location_of(std::uint32_t process, const Word* words) const {
    return static_cast<std::size_t>(machine_->layout().locations[process].get(words));
}

/// Computes the moves of the state. Returns true if the state is transient (macro_steps.hpp) and has no model error; in
/// this case, `moves` contains only the moves by which macro-steps continue.
bool MacroSteps::is_transient(const Word* words, Moves& moves) const {
    if (std::ranges::any_of(races_, [&](const Field& race) { return race.raw(words) != 0; })) return false;
    const std::size_t index = cycle_of(words);
    // Most states are not transient. To recognize such a state, it usually suffices to test the edges of a few
    // processes.
    if (index == none && std::ranges::none_of(prompt_, [&](std::uint32_t process) {
            return machine_->may_move(process, words, moves.registers);
        }))
        return false;
    machine_->expand(words, moves);
    if (moves.fault || moves.cut) return false;
    const auto process_of = [&](std::uint32_t edge) { return machine_->process_of(edge).index; };
    // If only observers can move, they read the state that the last move has reached.
    const auto is_observer = [&](std::uint32_t edge) { return observers_[process_of(edge)]; };
    if (moves.urgent && std::ranges::all_of(moves.edges, is_observer)) return true;
    // Requests to timers are accepted first, one timer at a time.
    const auto accepts = [&](std::uint32_t edge) {
        return accepts_[process_of(edge)] != none && machine_->urgent(edge);
    };
    if (index == none) {
        const auto first = std::ranges::find_if(moves.edges, accepts);
        if (first == moves.edges.end()) return false;
        keep(moves, [&, process = process_of(*first)](std::uint32_t edge) { return process_of(edge) == process; });
        return true;
    }
    const Cycle& cycle = cycles_[index];
    const std::size_t location = location_of(cycle.process, words), size = machine_->layout().words;
    const auto is_of_plc = [&](std::uint32_t edge) { return process_of(edge) == cycle.process; };
    const auto may_wait = [&](std::uint32_t process) {
        for (std::size_t i = 0; i < moves.edges.size(); ++i) {
            if (!is_of_plc(moves.edges[i])) continue;
            const Cycle::Edge& edge = cycle.edges[machine_->edge_of(moves.edges[i]).index];
            const Word* const next = moves.words.data() + i * size;
            const auto is_unchanged = [&](const Field& field) { return field.raw(next) == field.raw(words); };
            if (!edge.always[process] &&
                !(edge.if_unchanged[process] && std::ranges::all_of(edge.shared, is_unchanged)))
                return false;
        }
        return true;
    };
    for (const std::uint32_t edge : moves.edges) {
        const bool urgent = machine_->urgent(edge);
        if (is_of_plc(edge) ? urgent : without_.processes || cycle.like_waiting[location]) continue;
        const std::uint32_t process = process_of(edge);
        const bool waits = urgent ? cycle.independent[location] && accepts_[process] == index : deferred_[process];
        if (!waits && !may_wait(process)) return false;
    }
    keep(moves, is_of_plc);
    return !moves.edges.empty();
}

/// True if the state need not be stored for properties: `first` or a successor of the state decides each property
/// search that the state decides.
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

/// Replaces the values of dead outputs, which are not relevant in the state, by the initial values of the outputs. Thus
/// equivalent states become equal.
void MacroSteps::normalize(Word* words) const {
    for (const Cycle& cycle : cycles_) {
        const std::size_t location = location_of(cycle.process, words);
        if (!cycle.within[location] && (location != cycle.waiting || cycle.stable.raw(words) != 0)) continue;
        for (const Reset& output : cycle.outputs) output.field.set(words, output.value);
    }
}

/// Continues a macro-step that begins with `edge` and has reached the state `words`. Appends the successors of the
/// macro-step to Buffers::made.
void MacroSteps::append(Word* words, std::uint32_t edge, std::size_t depth, const Word* first, Buffers& buffers) const {
    normalize(words);
    if (!buffers.known->add(words).is_new) return;
    if (buffers.levels.size() <= depth) buffers.levels.push_back(std::make_unique<Moves>());
    Moves& moves = *buffers.levels[depth];
    const std::size_t size = machine_->layout().words;
    if (is_transient(words, moves) && is_covered(words, moves, first, buffers)) {
        buffers.computed += moves.edges.size();
        for (std::size_t i = 0; i < moves.edges.size(); ++i)
            append(moves.words.data() + i * size, edge, depth + 1, first, buffers);
    } else {
        buffers.made.edges.push_back(edge);
        buffers.made.words.insert(buffers.made.words.end(), words, words + size);
    }
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

/// Searches for moves that continue a macro-step from the state `words` to the state `to`. `steps` contains the
/// previous moves of the macro-step. Appends the moves to `steps` and returns true if the search succeeds.
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
