// SPDX-License-Identifier: MIT
#include "check/inputs/required_states.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "ir/network/variables.hpp"

namespace grafverif {

using timed::Layout;
using timed::Word;

namespace {

using VariableId = Id<Network::Variable>;

constexpr std::size_t most_flags = 4;   // maximum number of flags that Chosen instances may set
constexpr std::size_t most_length = 8;  // maximum number of moves of a homing sequence

/// Evaluates a guard in a packed state; the variables in `set` have the value true.
bool holds(const Network& network, Id<Expr> guard, const Layout& layout, const Word* words,
           const std::set<VariableId>& set = {}) {
    const auto value = evaluate(network.exprs, guard, [&](const Expr& leaf) -> std::int64_t {
        if (leaf.op == Op::At)
            return layout.locations[at_process(leaf)].get(words) == static_cast<std::int64_t>(at_location(leaf));
        const VariableId variable{static_cast<std::uint32_t>(leaf.value)};
        return set.contains(variable) ? 1 : layout.variables[variable.index].get(words);
    });
    return value.value_or(0) != 0;
}

}  // namespace

RequiredStates::RequiredStates(const Network& loop, const std::vector<AbstractableProcess>& instances,
                               const std::vector<InputLevel>& panel_levels, bool with_sequence,
                               const InputAblations& ablations)
    : loop_(loop),
      instances_(instances),
      ablations_(ablations),
      users_(loop),
      clocks_(analyse_clocks(loop)),
      with_sequence_(with_sequence),
      levels_(with_sequence ? levels_with_plant(loop, instances, panel_levels) : panel_levels),
      states_(loop, instances, levels_) {
    assert(!with_sequence || loop.controllers.size() == 1);
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (levels_[i] != InputLevel::Chosen) continue;
        const Id<Network::Process> id = instances[i].process;
        for (const VariableId variable : Slots(loop, id).written())
            if (std::ranges::find(instances[i].outputs, variable) == instances[i].outputs.end() &&
                std::ranges::find(flags_, variable) == flags_.end())
                flags_.push_back(variable);
        if (with_sequence)
            chosen_.push_back({.local = ProcessStates(loop, users_, clocks_[id.index], id, unlimited_),
                               .is_panel = panel_levels[i] == InputLevel::Chosen});
    }
}

std::optional<bool> RequiredStates::find(const FollowLimits& limits) {
    if (!is_supported_)
        is_supported_ = flags_.size() <= most_flags &&
                        std::ranges::all_of(chosen_, [](Chosen& instance) { return instance.local.explore(); });
    if (!*is_supported_) return false;
    if (!found_.empty()) return true;
    if (const std::optional<bool> complete = states_.run(limits); !complete || !*complete) return complete;
    found_.resize(states_.size());
    std::iota(found_.begin(), found_.end(), 0U);
    if (!with_sequence_) return true;
    if (!find_sequence(limits)) {
        found_.clear();
        return {};
    }
    find_late_states();
    return true;
}

/// Extends the homing sequence by one move as long as fewer waiting states become possible. Returns false if a limit is
/// reached.
bool RequiredStates::find_sequence(const FollowLimits& limits) {
    for (Chosen& instance : chosen_) instance.now = 0;
    sequence_.clear();
    std::size_t least = waiting(found_);
    for (std::size_t length = 0; length < most_length; ++length) {
        std::optional<PanelMove> best;
        Numbers after_best;
        for (std::size_t i = 0; i < chosen_.size(); ++i) {
            if (!chosen_[i].is_panel) continue;
            const ProcessStates& local = chosen_[i].local;
            for (const ProcessStates::Move& move : local.moves()) {
                if (move.from != chosen_[i].now || !waits_only(local.automaton().edges[{move.edge}])) continue;
                if (!begins_cycle(local, move.edge)) continue;
                std::optional<Numbers> states = after({i, move.to}, least, limits);
                if (!states) return false;
                const std::size_t size = waiting(*states);
                if (size == 0 || size >= least) continue;
                least = size;
                after_best = std::move(*states);
                best = {i, move.to};
            }
        }
        if (!best) break;
        sequence_.push_back(text_of(*best));
        chosen_[best->instance].now = best->to;
        found_ = std::move(after_best);
    }
    return true;
}

/// Describes the values that `move` changes.
std::string RequiredStates::text_of(const PanelMove& move) const {
    const Chosen& instance = chosen_[move.instance];
    const ProcessStates& local = instance.local;
    const ProcessStates::State &from = local.states()[instance.now], &to = local.states()[move.to];
    std::vector<std::string> changes;
    for (std::size_t i = 0; i < local.own().size(); ++i) {
        const Network::Variable& variable = loop_.variables[local.own()[i]];
        if (from.values[i] == to.values[i]) continue;
        const std::string value =
            variable.type.boolean ? (to.values[i] != 0 ? "true" : "false") : std::to_string(to.values[i]);
        changes.push_back(fmt::format("`{}` becomes {}", variable.name, value));
    }
    return fmt::format("{}", fmt::join(changes, " and "));
}

/// True if a cycle of the PLC begins after the edge, before time passes.
bool RequiredStates::begins_cycle(const ProcessStates& local, std::uint32_t edge) {
    if (ablations_.need_not_begin_cycle) return true;
    std::set<VariableId> flags;
    for (const Network::Assignment& assignment : local.automaton().edges[{edge}].assignments) {
        const VariableId target = variable_of(loop_.exprs, assignment.target);
        if (std::ranges::find(flags_, target) != flags_.end() && is_true(loop_.exprs, assignment.value))
            flags.insert(target);
    }
    const auto [known, is_new] = begins_.emplace(flags, false);
    if (is_new) known->second = begins_cycle(flags);
    return known->second;
}

/// True if, in each waiting state of the abstraction, an urgent edge is enabled if the variables `flags` are true.
bool RequiredStates::begins_cycle(const std::set<VariableId>& flags) {
    const Network::Controller& controller = loop_.controllers[Id<Network::Controller>{0}];
    const Network::Template& plc = loop_.templates[loop_.processes[controller.process].automaton];
    const timed::Machine& machine = states_.machine();
    for (std::uint32_t state = 0; state < states_.size(); ++state) {
        const Word* const words = states_.words(state);
        if (!states_.all_wait(words)) continue;
        const bool begins = std::ranges::any_of(plc.edges, [&](const Network::Edge& edge) {
            return edge.from == controller.waiting && edge.urgent &&
                   holds(loop_, edge.guard, machine.layout(), words, flags);
        });
        if (begins) continue;
        const timed::Moves& moves = states_.expand(state);
        const bool is_urgent = std::ranges::any_of(moves.edges, [&](std::uint32_t edge) {
            return machine.process_of(edge) != controller.process && machine.urgent(edge);
        });
        if (!is_urgent) return false;
    }
    return true;
}

/// Returns, per input choice of the abstraction, the set of valuations that are possible after `move`.
std::vector<Word> RequiredStates::admitted(const PanelMove& move) const {
    std::vector<Word> sets;
    for (const InputChoice& choice : states_.machine().choices()) {
        Word set = ~Word{0};
        for (std::size_t i = 0; i < chosen_.size(); ++i) {
            const ProcessStates& local = chosen_[i].local;
            if (!chosen_[i].is_panel || local.process() != instances_[choice.instance].process) continue;
            const ProcessStates::State& now = local.states()[i == move.instance ? move.to : chosen_[i].now];
            const auto is_output = [&](const std::vector<std::int64_t>& valuation) {
                for (std::size_t k = 0; k < valuation.size(); ++k) {
                    const auto own = std::ranges::find(local.own(), choice.variables[k]) - local.own().begin();
                    if (now.values[static_cast<std::size_t>(own)] != valuation[k]) return false;
                }
                return true;
            };
            set = 0;
            for (std::size_t row = 0; row < choice.valuations.size(); ++row)
                if (is_output(choice.valuations[row])) set |= Word{1} << row;
        }
        sets.push_back(set);
    }
    return sets;
}

/// Returns the states that are possible after `move` and after the beginning of a cycle. Ends early if more than `most`
/// of these states are waiting states. Returns nullopt if a limit is reached.
std::optional<RequiredStates::Numbers> RequiredStates::after(const PanelMove& move, std::size_t most,
                                                             const FollowLimits& limits) {
    const std::vector<Word> sets = admitted(move);
    const timed::Machine& machine = states_.machine();
    const Id<Network::Process> plc = loop_.controllers[Id<Network::Controller>{0}].process;
    std::vector<bool> seen(states_.size(), false);
    Numbers found;
    std::size_t count = 0, polls = 0;  // `count`: number of waiting states in `found`
    const auto expand = [&](std::uint32_t state, bool begins) {
        const timed::Moves& moves = states_.expand(state, true);
        for (std::size_t taken = 0; taken < moves.edges.size(); ++taken) {
            const bool is_of_plc = machine.process_of(moves.edges[taken]) == plc;
            if (begins && !is_of_plc) continue;
            bool is_possible = true;  // for a move of another process, Moves::chosen has no sets
            for (std::size_t i = 0; i < sets.size() && is_of_plc; ++i)
                is_possible = is_possible && (moves.chosen[taken * sets.size() + i] & sets[i]) != 0;
            if (!is_possible) continue;
            const std::uint32_t next = states_.successor(taken);
            if (seen[next]) continue;
            seen[next] = true;
            found.push_back(next);
            if (states_.all_wait(states_.words(next))) ++count;
        }
        return ++polls % search_poll_interval != 0 || !is_over(limits.deadline, limits.stop);
    };
    for (const std::uint32_t state : found_)
        if (count <= most && states_.all_wait(states_.words(state)) && !expand(state, true)) return {};
    for (std::size_t i = 0; i < found.size() && count <= most; ++i)
        if (!expand(found[i], false)) return {};
    return found;
}

std::size_t RequiredStates::waiting(const Numbers& states) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(states, [&](std::uint32_t state) { return states_.all_wait(states_.words(state)); }));
}

/// Computes `late` of all instances of the plant.
void RequiredStates::find_late_states() {
    for (Chosen& instance : chosen_) {
        instance.late.assign(instance.local.states().size(), !instance.is_panel);
        if (instance.is_panel) instance.late[instance.now] = true;
    }
    for (bool changes = true; changes;) {
        changes = false;
        for (Chosen& instance : chosen_) {
            if (instance.is_panel) continue;
            std::vector<bool> late =
                instance.local.late(instance.late, admitted_valuations(instance.local), ablations_.leave_freely);
            changes = changes || late != instance.late;
            instance.late = std::move(late);
        }
    }
}

/// Returns, for each valuation of the variables that the instance reads and other processes write, true if the
/// valuation is possible in the states found_ and the states `late`.
std::vector<bool> RequiredStates::admitted_valuations(const ProcessStates& local) const {
    std::vector<std::optional<std::set<std::int64_t>>>
        of_instances;  // values of variables that a Chosen instance writes
    for (const VariableId variable : local.others()) {
        of_instances.emplace_back();
        for (const Chosen& other : chosen_) {
            const auto own = std::ranges::find(other.local.own(), variable);
            if (own == other.local.own().end()) continue;
            of_instances.back().emplace();
            for (std::size_t state = 0; state < other.late.size(); ++state)
                if (other.late[state])
                    of_instances.back()->insert(
                        other.local.states()[state].values[static_cast<std::size_t>(own - other.local.own().begin())]);
        }
    }
    const Layout& layout = states_.machine().layout();
    std::set<std::vector<std::int64_t>> stored;  // joint values of the other variables
    for (const std::uint32_t state : found_) {
        std::vector<std::int64_t> values;
        for (std::size_t i = 0; i < of_instances.size(); ++i)
            if (!of_instances[i]) values.push_back(layout.variables[local.others()[i].index].get(states_.words(state)));
        stored.insert(std::move(values));
    }
    std::vector<bool> admitted;
    for (const std::vector<std::int64_t>& valuation : local.valuations()) {
        std::vector<std::int64_t> values;
        bool is_possible = true;
        for (std::size_t i = 0; i < of_instances.size(); ++i)
            if (of_instances[i]) is_possible = is_possible && of_instances[i]->contains(valuation[i]);
            else values.push_back(valuation[i]);
        admitted.push_back(is_possible && stored.contains(values));
    }
    return admitted;
}

/// A state of the loop that is composed of a state of the abstraction and of states of the Chosen instances.
struct RequiredStates::Combination {
    const Layout& layout;
    const FollowLimits& limits;
    const std::function<void(const Word*)>& visit;
    /// Per Chosen instance: the instances all of whose variables have values if this instance and all instances with
    /// smaller indices have values.
    std::vector<std::vector<const ProcessStates*>> complete = {};
    std::vector<Word> words = {};
    std::size_t visited = 0, polls = 0;

    bool is_over_limits() {
        return visited > limits.states ||
               (++polls % search_poll_interval == 0 && is_over(limits.deadline, limits.stop));
    }
    bool has_urgent_edge(const Network& network, const ProcessStates& local) const {
        const auto at = layout.locations[local.process().index].get(words.data());
        return std::ranges::any_of(local.automaton().edges, [&](const Network::Edge& edge) {
            return edge.urgent && edge.from.index == at && holds(network, edge.guard, layout, words.data());
        });
    }
};

/// Visits the combinations of the current values with the states `late` of the Chosen instances from index `first` on.
/// Omits combinations in which one of these instances has an enabled urgent edge. Returns false if a limit is reached.
bool RequiredStates::combine(std::size_t first, Combination& combination) const {
    if (combination.is_over_limits()) return false;
    if (first == chosen_.size()) {
        ++combination.visited;
        combination.visit(combination.words.data());
        return true;
    }
    const ProcessStates& local = chosen_[first].local;
    for (std::size_t state = 0; state < local.states().size(); ++state) {
        if (!chosen_[first].late[state]) continue;
        local.place(local.states()[state], combination.layout, combination.words.data());
        const bool is_urgent = std::ranges::any_of(combination.complete[first], [&](const ProcessStates* instance) {
            return combination.has_urgent_edge(loop_, *instance);
        });
        if (!is_urgent && !combine(first + 1, combination)) return false;
    }
    return true;
}

bool RequiredStates::each(const Layout& to, const FollowLimits& limits,
                          const std::function<void(const Word*)>& visit) const {
    Combination combination{.layout = to, .limits = limits, .visit = visit};
    combination.complete.resize(chosen_.size());
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
        std::size_t last = i;  // index of the last instance whose variables instance i reads
        for (std::size_t other = i + 1; other < chosen_.size(); ++other)
            if (std::ranges::find_first_of(chosen_[i].local.others(), chosen_[other].local.own()) !=
                chosen_[i].local.others().end())
                last = other;
        combination.complete[last].push_back(&chosen_[i].local);
    }
    combination.words.resize(to.words, 0);
    Word* const words = combination.words.data();
    for (const std::uint32_t state : found_) {
        const Word* const now = states_.words(state);
        if (!states_.all_wait(now)) continue;
        states_.copy(now, to, words);
        for (std::size_t subset = 0; subset < std::size_t{1} << flags_.size(); ++subset) {
            for (std::size_t i = 0; i < flags_.size(); ++i)
                to.variables[flags_[i].index].set(words, static_cast<std::int64_t>(subset >> i & 1));
            if (!combine(0, combination)) return false;
        }
    }
    return true;
}

}  // namespace grafverif
