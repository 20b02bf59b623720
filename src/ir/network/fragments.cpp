// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "ir/network_fragments.hpp"
#include "ir/slots.hpp"

namespace grafverif {

namespace {

/// Determines when the urgent edges of a process stop time, if these edges read only a few Boolean variables.
class StoppingTime {
public:
    StoppingTime(const Network& network, Id<Network::Process> id)
        : network_(network), guards_(Slots(network, id).automaton.locations.size()) {
        constexpr std::size_t most_read = 6;
        std::set<Id<Network::Variable>> read;
        bool booleans = true;
        for (const Network::Edge& edge : Slots(network, id).automaton.edges) {
            if (!edge.urgent) continue;
            guards_[edge.from.index].push_back(edge.guard);
            for (const Id<Expr> leaf : leaves(network.exprs, edge.guard)) {
                const Id<Network::Variable> variable{static_cast<std::uint32_t>(network.exprs[leaf].value)};
                read.insert(variable);
                booleans = booleans && network.variables[variable].type.boolean;
            }
        }
        const bool everywhere = std::ranges::none_of(guards_, [](const auto& guards) { return guards.empty(); });
        if (everywhere && booleans && read.size() <= most_read) read_.assign(read.begin(), read.end());
    }

    const std::vector<Id<Network::Variable>>& read() const { return read_; }

    /// True if each location has an enabled urgent edge for all values of the other variables while `variable` has the
    /// value `value`.
    bool while_it_is(Id<Network::Variable> variable, bool value) const {
        const auto at = std::ranges::find(read_, variable) - read_.begin();
        for (std::size_t values = 0; values < (std::size_t{1} << read_.size()); ++values) {
            if (((values >> at) & 1U) != (value ? 1U : 0U)) continue;
            const bool stopped = std::ranges::all_of(guards_, [&](const std::vector<Id<Expr>>& guards) {
                return std::ranges::any_of(guards, [&](Id<Expr> guard) { return holds(guard, values); });
            });
            if (!stopped) return false;
        }
        return true;
    }

private:
    bool holds(Id<Expr> guard, std::size_t values) const {
        return evaluate(network_.exprs, guard, [&](const Expr& leaf) {
                   const Id<Network::Variable> variable{static_cast<std::uint32_t>(leaf.value)};
                   return static_cast<std::int64_t>((values >> (std::ranges::find(read_, variable) - read_.begin())) &
                                                    1U);
               }).value_or(0) != 0;
    }

    const Network& network_;
    std::vector<std::vector<Id<Expr>>> guards_;  // guards of the urgent edges, per location
    std::vector<Id<Network::Variable>> read_ = {};
};

/// Computes the fragments. First, each chart forms a fragment with its steps, the variables that are computed from the
/// steps, and the variables from which the steps are computed. Then the instances are assigned to fragments. An
/// instance that communicates with exactly one chart is added to the fragment of that chart; an instance that
/// communicates with several charts forms a separate fragment. An instance that communicates only with other instances
/// is added to the fragment of one of these instances.
class FragmentFinder {
public:
    explicit FragmentFinder(const Network& network)
        : network_(network), writers_(network.variables.size()), controls_(network.processes.size(), false) {
        for (const Network::Controller& controller : network.controllers) controls_[controller.process.index] = true;
        cells_.of_process.assign(network.processes.size(), none);
        cells_.of_variable.assign(network.variables.size(), none);
        for (const Id<Network::Process> id : network.processes.ids())
            for (const Id<Network::Variable> variable : Slots(network, id).written())
                writers_[variable.index].push_back(id.index);
    }

    NetworkFragments find() {
        for (const Network::Controller& controller : network_.controllers) find_charts(controller);
        find_neighbours();
        for (const Id<Network::Process> id : network_.processes.ids())
            if (talks_to_[id.index].size() == 1) cells_.of_process[id.index] = *talks_to_[id.index].begin();
        for (const Id<Network::Process> id : network_.processes.ids())
            if (talks_to_[id.index].size() > 1) cells_.of_process[id.index] = add(network_.processes[id].name);
        place_the_rest();
        for (std::uint32_t variable = 0; variable < writers_.size(); ++variable)
            if (writers_[variable].size() == 1 && !controls_[writers_[variable].front()])
                cells_.of_variable[variable] = cells_.of_process[writers_[variable].front()];
        if (network_.race.valid()) cells_.of_variable[network_.race.index] = none;
        find_resting();
        return std::move(cells_);
    }

private:
    std::uint32_t add(std::string name) {
        cells_.names.push_back(std::move(name));
        return cells_.count++;
    }
    std::uint32_t& cell(Id<Network::Variable> variable) { return cells_.of_variable[variable.index]; }

    bool is_of_chart(Id<Network::Variable> variable) const {
        const std::vector<std::uint32_t>& writers = writers_[variable.index];
        if (network_.variables[variable].role == Network::Role::TimerPending) return true;
        return network_.variables[variable].role != Network::Role::Flag && writers.size() == 1 &&
               controls_[writers.front()];
    }

    /// Maps each variable that only a PLC writes, or only a PLC and the timer that it controls, to the variables from
    /// which its values are computed. Flags are excluded.
    using Sources = std::map<Id<Network::Variable>, std::set<Id<Network::Variable>>>;
    Sources sources(Id<Network::Process> controller) const {
        Sources found;
        const Slots slots(network_, controller);
        for (const Network::Edge& edge : slots.automaton.edges)
            for (const Network::Assignment& assignment : slots.assignments(edge)) {
                const Id<Network::Variable> target = slots.variable(network_.exprs[assignment.target]);
                if (!is_of_chart(target)) continue;
                for (const Id<Expr> leaf : leaves(network_.exprs, assignment.value))
                    found[target].insert(slots.variable(network_.exprs[leaf]));
                found.try_emplace(target);
            }
        return found;
    }

    void find_charts(const Network::Controller& controller) {
        const Sources sources = this->sources(controller.process);
        std::map<std::string, std::uint32_t> charts;
        for (const auto& step : controller.words.steps) {
            const auto known = charts.find(step.name.partial);
            cell(step.variable) = known != charts.end()
                                      ? known->second
                                      : charts[step.name.partial] =
                                            add(step.name.partial.empty() ? controller.words.name : step.name.partial);
        }
        if (charts.empty()) charts[""] = add(controller.words.name);
        for (const auto& [target, read] : sources)  // a firing condition belongs to the chart whose steps it changes
            if (network_.variables[target].role == Network::Role::Step && cell(target) != none)
                for (const Id<Network::Variable> variable : read)
                    if (network_.variables[variable].role == Network::Role::FiringCondition && cell(variable) == none)
                        cell(variable) = cell(target);
        for (bool more = true; more;) {
            more = false;
            for (const auto& [target, read] : sources) more = place(target, read) || more;
        }
        for (const auto& [target, read] : sources)
            if (cell(target) == none) cell(target) = charts.begin()->second;
    }

    /// Adds a variable to the fragment of the first variable from which it is computed or which is computed from it.
    bool place(Id<Network::Variable> target, const std::set<Id<Network::Variable>>& read) {
        bool placed = false;
        for (const Id<Network::Variable> variable : read) {
            if (cell(target) == none && cell(variable) != none) {
                cell(target) = cell(variable);
                placed = true;
            }
            if (cell(variable) == none && cell(target) != none && is_of_chart(variable)) {
                cell(variable) = cell(target);
                placed = true;
            }
        }
        return placed;
    }

    /// Finds the communication partners of each instance: charts and other instances.
    void find_neighbours() {
        talks_to_.resize(network_.processes.size());
        neighbours_.resize(network_.processes.size());
        std::vector<std::set<std::uint32_t>> readers(network_.variables.size());  // readers of each variable

        // For each variable: the charts that read or write it.
        std::vector<std::set<std::uint32_t>> chart_of(network_.variables.size());
        for (const Id<Network::Process> id : network_.processes.ids()) {
            if (!controls_[id.index]) {
                for (const Id<Network::Variable> variable : Slots(network_, id).used())
                    readers[variable.index].insert(id.index);
                continue;
            }
            for (const auto& [target, read] : sources(id)) {
                chart_of[target.index].insert(cell(target));
                for (const Id<Network::Variable> variable : read) chart_of[variable.index].insert(cell(target));
            }
        }
        for (const Id<Network::Variable> variable : network_.variables.ids()) {
            if (network_.variables[variable].role == Network::Role::Flag) continue;
            for (const std::uint32_t process : readers[variable.index]) {
                talks_to_[process].insert(chart_of[variable.index].begin(), chart_of[variable.index].end());
                neighbours_[process].insert(readers[variable.index].begin(), readers[variable.index].end());
            }
        }
    }

    /// Assigns the instances that do not communicate with a chart: each is added to the fragment of the first instance
    /// that has a fragment and communicates with it. The remaining instances form separate fragments.
    void place_the_rest() {
        for (bool more = !network_.controllers.empty(); more;) {
            more = false;
            for (const Id<Network::Process> id : network_.processes.ids()) {
                if (controls_[id.index] || cells_.of_process[id.index] != none) continue;
                for (const std::uint32_t other : neighbours_[id.index])
                    if (cells_.of_process[id.index] == none) cells_.of_process[id.index] = cells_.of_process[other];
                more = more || cells_.of_process[id.index] != none;
            }
        }
        for (const Id<Network::Process> id : network_.processes.ids())
            if (!controls_[id.index] && cells_.of_process[id.index] == none)
                cells_.of_process[id.index] = add(network_.processes[id].name);
    }

    /// Finds the variables that have a fixed value in all states in which time can pass.
    void find_resting() {
        cells_.resting.resize(network_.variables.size());
        for (const Id<Network::Process> id : network_.processes.ids()) {
            const StoppingTime stopping(network_, id);
            for (const Id<Network::Variable> variable : stopping.read())
                for (const bool value : {false, true})
                    if (stopping.while_it_is(variable, value)) cells_.resting[variable.index] = {!value, id.index};
        }
    }

    static constexpr std::uint32_t none = NetworkFragments::none;

    const Network& network_;
    std::vector<std::vector<std::uint32_t>> writers_;  // for each variable: the processes that write it
    std::vector<bool> controls_;                       // for each process: true if it is a PLC
    NetworkFragments cells_ = {};
    std::vector<std::set<std::uint32_t>> talks_to_ = {};    // for each process: the charts with which it communicates
    std::vector<std::set<std::uint32_t>> neighbours_ = {};  // for each process: neighbouring instances
};

}  // namespace

NetworkFragments cells_of(const Network& network) { return FragmentFinder(network).find(); }

std::vector<std::uint32_t> cells_read(const Network& network, const NetworkFragments& cells, const Property& property) {
    std::set<std::uint32_t> read;
    for (const Id<Expr> operand : property.operands)
        for (const Id<Expr> leaf : leaves(network.exprs, operand)) {
            const Expr& node = network.exprs[leaf];
            const Id<Network::Variable> variable{static_cast<std::uint32_t>(node.value)};
            if (node.op == Op::At && cells.of_process[at_process(node)] == NetworkFragments::none) return {};
            if (node.op != Op::At && (variable == network.race || network.variables[variable].scratch)) return {};
            const std::uint32_t cell =
                node.op == Op::At ? cells.of_process[at_process(node)] : cells.of_variable[variable.index];
            if (cell != NetworkFragments::none) read.insert(cell);
        }
    return {read.begin(), read.end()};
}

}  // namespace grafverif
