// SPDX-License-Identifier: MIT
#include "check/timed/layout.hpp"

#include <algorithm>
#include <utility>

#include "ir/interval.hpp"
#include "ir/network/variables.hpp"
#include "ir/network_subsystems.hpp"
#include "ir/variable_users.hpp"

namespace grafverif::timed {

namespace {

/// Allocates the bits of the fields, one field after another. Each field is placed in the first open word with enough
/// free bits. Callers allocate related fields consecutively.
class Bits {
public:
    Field take(std::uint64_t values, std::int64_t low) {
        const auto width = static_cast<std::uint8_t>(values <= 1 ? 0 : std::bit_width(values - 1));
        while (first_ < used_.size() && used_[first_] == 64) ++first_;
        std::size_t word = first_;
        while (word < used_.size() && used_[word] + width > 64) ++word;
        if (word == used_.size()) used_.push_back(0);
        const Field field{static_cast<std::uint16_t>(base_ + word), static_cast<std::uint8_t>(used_[word] % 64), width,
                          low};
        used_[word] += width;
        return field;
    }

    /// Ends the current 32-bit unit, so that later fields begin in a new unit. Returns the number of the new unit.
    std::size_t seam() {
        first_ = std::max<std::size_t>(used_.size(), 1) - 1;
        if (last() > 0) used_.back() = last() <= 32 ? 32 : 64;
        return 2 * used_.size() - (last() == 32 ? 1 : 0);
    }

    /// Starts new words for later fields.
    void close() {
        base_ = size();
        first_ = 0;
        used_.clear();
    }

    std::size_t size() const { return base_ + used_.size(); }
    unsigned last() const { return used_.empty() ? 0 : used_.back(); }

private:
    std::size_t base_ = 0;
    std::size_t first_ = 0;            // index in used_ of the first word that further fields can use
    std::vector<unsigned> used_ = {};  // number of bits used in each open word
};

std::uint64_t values_of(const Type& type) { return static_cast<std::uint64_t>(type.high - type.low) + 1; }

/// Returns the processes, grouped by independent subsystem.
std::vector<Id<Network::Process>> by_part(const Network& network, const NetworkSubsystems& parts) {
    std::vector<Id<Network::Process>> processes;
    for (const Id<Network::Process> process : network.processes.ids()) processes.push_back(process);
    std::ranges::stable_sort(processes, {}, [&](Id<Network::Process> id) { return parts.of_process[id.index]; });
    return processes;
}

/// Returns, for each process, a list of the variables that this process writes and no previous process writes. The last
/// list contains the variables that no process writes.
std::vector<std::vector<Id<Network::Variable>>> written_by_process(const Network& network) {
    std::vector<std::size_t> writer(network.variables.size(), network.processes.size());
    for (const Id<Network::Process> id : network.processes.ids()) {
        const auto take = [&](const std::vector<Network::Assignment>& assignments) {
            for (const Network::Assignment& assignment : assignments) {
                std::size_t& first = writer[static_cast<std::size_t>(network.exprs[assignment.target].value)];
                first = std::min<std::size_t>(first, id.index);
            }
        };
        const Network::Template& automaton = network.templates[network.processes[id].automaton];
        for (const Network::Edge& edge : automaton.edges) take(edge.assignments);
        for (const Network::Procedure& procedure : automaton.procedures) take(procedure.assignments);
    }
    std::vector<std::vector<Id<Network::Variable>>> written(network.processes.size() + 1);
    for (const Id<Network::Variable> id : network.variables.ids()) written[writer[id.index]].push_back(id);
    return written;
}

}  // namespace

VariableSet unread_variables(const Network& network) {
    const std::vector<grafverif::Interval> values =
        grafverif::intervals(network.exprs, [&](const Expr& leaf) { return type_of(network, leaf); });
    const std::vector<bool> have_values = terms_with_values(network.exprs, values);
    VariableSet read(network.variables.size());
    std::vector<Id<Network::Variable>> open;
    const auto take = [&](Id<Network::Variable> variable) {
        if (read[variable.index]) return;
        read[variable.index] = true;
        open.push_back(variable);
    };
    const auto take_all = [&](Id<Expr> term) { each_variable(network.exprs, term, take); };
    if (network.race.valid()) take(network.race);
    for (const Network::Controller& controller : network.controllers)
        if (controller.stable.valid()) take(controller.stable);
    if (network.settled.valid()) take_all(network.settled);
    for (const Property& property : network.properties) std::ranges::for_each(property.operands, take_all);
    std::vector<std::vector<Id<Expr>>> assigned(network.variables.size());  // per variable: the terms assigned to it
    const auto add = [&](const std::vector<Network::Assignment>& assignments) {
        for (const Network::Assignment& assignment : assignments) {
            const Id<Network::Variable> target = variable_of(network.exprs, assignment.target);
            const Type& range = network.variables[target].type;
            const grafverif::Interval& of_value = values[assignment.value.index];
            assigned[target.index].push_back(assignment.value);
            const bool fits = range.boolean || (range.low <= of_value.low && of_value.high <= range.high);
            if (!fits || !have_values[assignment.value.index]) take_all(assignment.value);
        }
    };
    for (const Network::Template& automaton : network.templates) {
        for (const Network::Procedure& procedure : automaton.procedures) add(procedure.assignments);
        for (const Network::Edge& edge : automaton.edges) {
            take_all(edge.guard);
            add(edge.assignments);
        }
    }
    while (!open.empty()) {
        const Id<Network::Variable> variable = open.back();
        open.pop_back();
        std::ranges::for_each(assigned[variable.index], take_all);
    }
    const VariableUsers users(network);
    VariableSet unread(network.variables.size());
    for (const Id<Network::Variable> id : network.variables.ids()) {
        const Network::Variable& variable = network.variables[id];
        const auto &readers = users.readers[id.index], &writers = users.writers[id.index];
        const bool is_local = readers.empty() || (writers.size() <= 1 && std::ranges::includes(writers, readers));
        unread[id.index] = !read[id.index] && is_local && !variable.scratch && variable.role != Network::Role::Step;
    }
    return unread;
}

Layout layout_of(const Network& network, const std::vector<ProcessClocks>& clocks,
                 const std::vector<InputChoice>& choices, const VariableSet& unread) {
    Layout layout;
    Bits bits;
    layout.locations.resize(network.processes.size());
    layout.clocks.resize(network.processes.size());
    layout.variables.resize(network.variables.size());
    const std::vector<std::vector<Id<Network::Variable>>> written = written_by_process(network);
    const auto is_stored = [&](Id<Network::Variable> id) {
        return !network.variables[id].scratch && (unread.empty() || !unread[id.index]);
    };
    const auto take = [&](Id<Network::Variable> id) {
        const Network::Variable& variable = network.variables[id];
        if (is_stored(id)) layout.variables[id.index] = bits.take(values_of(variable.type), variable.type.low);
    };
    const NetworkSubsystems parts = parts_of(network);
    std::uint32_t part = 0;
    for (const Id<Network::Process> process : by_part(network, parts)) {
        if (std::exchange(part, parts.of_process[process.index]) != part) layout.seams.push_back(bits.seam());
        const Network::Process& made = network.processes[process];
        layout.locations[process.index] = bits.take(network.templates[made.automaton].locations.size(), 0);
        for (const std::int64_t greatest : clocks[process.index].greatest)
            layout.clocks[process.index].push_back(bits.take(static_cast<std::uint64_t>(greatest) + 1, 0));
        std::ranges::for_each(written[process.index], take);
    }
    std::ranges::for_each(written.back(), take);
    for (const InputChoice& choice : choices)
        layout.choices.push_back(choice.kept ? bits.take(std::uint64_t{1} << choice.valuations.size(), 0) : Field{});
    layout.stored = std::max<std::size_t>(1, bits.size());
    layout.halves = 2 * layout.stored - (bits.last() <= 32 ? 1 : 0);
    bits.close();
    for (const Id<Network::Variable> id : network.variables.ids()) {
        const Network::Variable& variable = network.variables[id];
        if (!is_stored(id)) layout.variables[id.index] = bits.take(values_of(variable.type), variable.type.low);
    }
    layout.words = std::max(layout.stored, bits.size());
    return layout;
}

std::vector<Word> packed_initial(const Network& network, const Layout& layout) {
    std::vector<Word> words(layout.words, 0);
    for (const Id<Network::Process> process : network.processes.ids())
        layout.locations[process.index].set(words.data(), network.processes[process].initial.index);
    for (const Id<Network::Variable> variable : network.variables.ids())
        layout.variables[variable.index].set(words.data(), network.variables[variable].initial);
    for (const Field& choice : layout.choices) choice.set(words.data(), static_cast<std::int64_t>(choice.all()));
    return words;
}

namespace {

bool strict(const Network::ClockConstraint& constraint) {
    return constraint.relation == Op::Less || constraint.relation == Op::Greater;
}

}  // namespace

std::optional<std::string> inexact_place(const Network& network) {
    for (const Network::Process& process : network.processes) {
        const Network::Template& automaton = network.templates[process.automaton];
        for (const Network::Location& location : automaton.locations)
            for (const Network::ClockConstraint& bound : location.invariant)
                if (strict(bound))
                    return "the strict bound on clock `" + automaton.clocks[bound.clock].name + "` at `" +
                           process.name + "." + location.name + "`";
        for (const Network::Edge& edge : automaton.edges) {
            const std::string place = "`" + process.name + "`, edge `" + automaton.locations[edge.from].name + " -> " +
                                      automaton.locations[edge.to].name + "`";
            const bool watches =
                // A strict constraint of an observer does not make integer time inexact; see the proof in
                // docs/explanation/timed-engine.md.
                process.kind == Network::ProcessKind::Observer;
            for (const Network::ClockConstraint& constraint : edge.constraint)
                if (strict(constraint) && !watches)
                    return "the strict constraint on clock `" + automaton.clocks[constraint.clock].name + "` of " +
                           place;
            if (edge.urgent && !keeps_target_invariant(network, process, edge))
                return "an urgent edge that the passage of time can disable: " + place;
        }
    }
    return {};
}

}  // namespace grafverif::timed
