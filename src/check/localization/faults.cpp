// SPDX-License-Identifier: MIT
#include "check/localization/faults.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "check/inputs/process_states.hpp"
#include "ir/interval.hpp"
#include "ir/junction.hpp"
#include "ir/network/variables.hpp"
#include "ir/slots.hpp"

namespace grafverif {

namespace {

using Variable = Id<Network::Variable>;

constexpr std::int64_t most_combinations = 4096;  // maximum number of value combinations that one analysis enumerates

class Faults {
public:
    explicit Faults(const Network& network) : network_(network) {}

    /// True if the analysis shows that the value of the k-th assignment of an edge is always in the range of its target
    /// variable. The analysis considers the guard of the edge only if no previous assignment changes a variable that
    /// the value reads.
    bool stays_in_range(const Network::Edge& edge, const std::vector<Network::Assignment>& assignments,
                        std::size_t k) const {
        const Type& type = network_.variables[variable_of(assignments[k].target)].type;
        const Id<Expr> value = assignments[k].value;
        const Interval values = interval_of(value);
        if (type.boolean || (type.low <= values.low && values.high <= type.high)) return true;
        std::map<std::int64_t, std::int64_t> now;  // value, in the current combination, of each variable that the
                                                   // assigned value or the guard reads
        std::int64_t combinations = 1;
        const auto read = [&](Id<Expr> term) {
            for (const Id<Expr> leaf : leaves(network_.exprs, term)) {
                const Type& of = network_.variables[variable_of(leaf)].type;
                if (!now.emplace(network_.exprs[leaf].value, of.low).second) continue;
                combinations = std::min(combinations * (of.high - of.low + 1), most_combinations + 1);
            }
        };
        read(value);
        bool guarded = true;
        for (std::size_t before = 0; before < k; ++before)
            guarded = guarded && !now.contains(network_.exprs[assignments[before].target].value);
        std::vector<Id<Expr>> guards;
        if (guarded)
            for (const Id<Expr> conjunct : operands_of(network_.exprs, edge.guard, Op::And))
                if (reads_some(conjunct, now)) guards.push_back(conjunct);
        for (const Id<Expr> guard : guards) read(guard);
        if (combinations > most_combinations) return false;
        do {
            const auto of = [&](const Expr& leaf) { return now.at(leaf.value); };
            const bool enabled = std::ranges::all_of(
                guards, [&](Id<Expr> guard) { return evaluate(network_.exprs, guard, of).value_or(1) != 0; });
            if (!enabled) continue;
            const auto made = evaluate(network_.exprs, value, of);
            if (!made || *made < type.low || *made > type.high) return false;
        } while (next(now));
        return true;
    }

private:
    static Variable variable_of(const Expr& leaf) { return {static_cast<std::uint32_t>(leaf.value)}; }
    Variable variable_of(Id<Expr> leaf) const { return variable_of(network_.exprs[leaf]); }
    Interval interval_of(Id<Expr> term) const {
        return interval(network_.exprs, term, [this](const Expr& leaf) { return type_of(network_, leaf); });
    }
    bool reads_some(Id<Expr> term, const std::map<std::int64_t, std::int64_t>& of) const {
        return std::ranges::any_of(leaves(network_.exprs, term),
                                   [&](Id<Expr> leaf) { return of.contains(network_.exprs[leaf].value); });
    }
    bool next(std::map<std::int64_t, std::int64_t>& now) const {
        for (auto& [variable, value] : now) {
            const Type& type = network_.variables[{static_cast<std::uint32_t>(variable)}].type;
            if (++value <= type.high) return true;
            value = type.low;
        }
        return false;
    }

    const Network& network_;
};

/// Explores each process separately, for all values of the variables of other processes.
class SingleProcesses {
public:
    explicit SingleProcesses(const Network& network)
        : network_(network), users_(network), clocks_(analyse_clocks(network)) {}

    /// True if the exploration shows that the process assigns no value outside the range of a variable. PLCs are not
    /// explored.
    bool stays_in_range(Id<Network::Process> id) {
        const auto [known, is_new] = known_.emplace(id, false);
        if (is_new && !users_.plcs.contains(id))
            known->second = ProcessStates(network_, users_, clocks_[id.index], id, limits_).explore();
        return known->second;
    }

private:
    const Network& network_;
    const VariableUsers users_;
    const std::vector<ProcessClocks> clocks_;
    const TimedOptions options_ = {};
    const timed::Limits limits_{options_};  // default options, without limits
    std::map<Id<Network::Process>, bool> known_ = {};
};

}  // namespace

bool terms_have_values(const Network& network) {
    const std::vector<Interval> values =
        intervals(network.exprs, [&](const Expr& leaf) { return type_of(network, leaf); });
    const std::vector<bool> have_values = terms_with_values(network.exprs, values);
    for (const Id<Network::Process> id : network.processes.ids()) {
        const Slots slots(network, id);
        for (const Network::Edge& edge : slots.automaton.edges) {
            if (!have_values[edge.guard.index]) return false;
            for (const Network::Assignment& assignment : slots.assignments(edge))
                if (!have_values[assignment.value.index]) return false;
        }
    }
    return true;
}

std::set<std::uint32_t> cells_that_may_err(const Network& network, const NetworkFragments& cells) {
    const Faults faults(network);
    SingleProcesses single(network);
    std::set<std::uint32_t> found;
    const auto cell_of = [&](Id<Expr> leaf) {
        return cells.of_variable[static_cast<std::size_t>(network.exprs[leaf].value)];
    };
    for (const Id<Network::Process> id : network.processes.ids()) {
        const Slots slots(network, id);
        for (const Network::Edge& edge : slots.automaton.edges) {
            const std::vector<Network::Assignment> assignments = slots.assignments(edge);
            for (std::size_t k = 0; k < assignments.size(); ++k) {
                const Id<Expr> target = assignments[k].target;
                if (network.race.valid() && network.exprs[target].value == network.race.index) {
                    for (const Id<Expr> reason : operands_of(network.exprs, assignments[k].value, Op::Or))
                        if (reason != target) {
                            // `reason` is the condition of one possible race: a disjunct of the value that is assigned
                            // to the race flag. An abstraction detects this race if it contains one of the fragments
                            // that `reason` reads.
                            std::uint32_t cell = NetworkFragments::none;
                            for (const Id<Expr> leaf : leaves(network.exprs, reason))
                                cell = std::min(cell, cell_of(leaf));
                            if (cell == NetworkFragments::none) cell = cells.of_process[id.index];
                            // If `reason` is a constant, or reads only variables that belong to no fragment, every
                            // abstraction detects the race.
                            if (cell == NetworkFragments::none) cell = 0;
                            found.insert(cell);
                        }
                    continue;
                }
                if (faults.stays_in_range(edge, assignments, k) || single.stays_in_range(id)) continue;
                const std::uint32_t process = cells.of_process[id.index];
                found.insert(process != NetworkFragments::none ? process : cell_of(target));
            }
        }
    }
    return found;
}

}  // namespace grafverif
