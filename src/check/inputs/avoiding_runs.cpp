// SPDX-License-Identifier: MIT
#include "check/inputs/avoiding_runs.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <unordered_map>

namespace grafverif {

namespace {

constexpr std::size_t most_flags = 4;  // maximum number of flags that the processes of a refinement may set
constexpr std::size_t most_predecessors = std::size_t{1} << 24U;  // maximum number of stored predecessors

}  // namespace

using timed::End;
using timed::Word;

Situations Situations::restricted_to(const std::vector<std::uint32_t>& kept) const {
    Situations made;
    std::ranges::set_intersection(columns, kept, std::back_inserter(made.columns));
    if (made.columns == columns) return *this;
    for (const std::vector<std::int64_t>& all : values) {
        std::vector<std::int64_t> row;
        for (std::size_t i = 0; i < columns.size(); ++i)
            if (std::ranges::binary_search(made.columns, columns[i])) row.push_back(all[i]);
        made.values.insert(std::move(row));
    }
    return made;
}

AvoidingRuns::AvoidingRuns(const Network& loop, const std::vector<AbstractableProcess>& instances,
                           const Property& property, const Levels& levels, const Remainder* within)
    : loop_(loop),
      levels_(levels),
      within_(within),
      states_(
          loop, instances, levels, property.name,
          within == nullptr
              ? AbstractStates::Admits()
              : [this](const Word* from, std::uint32_t edge, const Word* to) { return admits(from, edge, to); }),
      property_(*std::ranges::find(states_.network().properties, property.name, &Property::name)),
      is_inevitable_(property.pattern == Pattern::Inevitable),
      p_(is_inevitable_ ? timed::Program::yes : compiled(property_.operands.front())),
      q_(compiled(property_.operands.back())),
      is_stored_(loop.processes.size(), true),
      starts_(states_.machine().layout().stored) {
    for (std::size_t i = 0; i < instances.size(); ++i)
        is_stored_[instances[i].process.index] = levels[i] != InputLevel::Chosen;
    for (const Id<Network::Variable> id : signature_variables(loop))
        if (!states_.unstored()[id.index]) columns_.push_back(id.index);
    for (std::uint32_t process = 0; process < loop.processes.size(); ++process)
        if (is_stored_[process] && loop.processes[{process}].kind != Network::ProcessKind::Controller)
            columns_.push_back(static_cast<std::uint32_t>(loop.variables.size()) + process);
}

namespace {

/// Calls `work` with the time limit. Returns nullopt if the limit is reached.
template <class Work>
auto within_limits(const FollowLimits& limits, const Work& work) -> decltype(work(std::declval<timed::Limits&>())) {
    TimedOptions options;
    options.deadline = limits.deadline;
    options.stop = limits.stop;
    timed::Limits polled(options);
    try {
        return work(polled);
    } catch (const timed::Limits::Stop&) {
        return {};
    }
}

}  // namespace

std::optional<bool> AvoidingRuns::explore(const FollowLimits& limits) {
    if (const std::optional<bool> found = states_.run(limits); !found || !*found) return found;
    return within_limits(limits, [&](const timed::Limits& polled) -> std::optional<bool> {
        find_awaiting(polled);
        return true;
    });
}

std::optional<bool> AvoidingRuns::explore(const AvoidingRuns& coarser, const std::vector<const ProcessStates*>& stored,
                                          const FollowLimits& limits, const InputAblations& ablations) {
    const timed::Machine& machine = states_.machine();
    const timed::Layout& to = machine.layout();
    // Flags that the additional processes set. The coarser abstraction does not contain their values.
    std::set<std::uint32_t> set_flags;
    for (const ProcessStates* const local : stored)
        for (const Id<Network::Variable> variable : Slots(loop_, local->process()).written())
            if (loop_.variables[variable].role == Network::Role::Flag) set_flags.insert(variable.index);
    const std::vector<std::uint32_t> flags(set_flags.begin(), set_flags.end());
    if (flags.size() > most_flags) return false;
    passed_.emplace(*this, within_->passed);
    Situations last = within_->last;
    if (ablations.one_situation) last.values = {*last.values.begin()};
    last_.emplace(*this, last);
    std::vector<Word> words(to.words);
    for (const timed::Field& choice : to.choices) choice.set(words.data(), static_cast<std::int64_t>(choice.all()));
    timed::Moves moves;
    std::size_t polls = 0;
    const auto is_limited = [&] {
        return states_.size() >= limits.states || bytes() > limits.bytes ||
               (polls++ % search_poll_interval == 0 && is_over(limits.deadline, limits.stop));
    };
    bool fails = false;
    const auto begin = [&] {
        const std::uint32_t start = starts_.add(words.data()).state;
        machine.expand(words.data(), moves);
        fails = fails || moves.cut || moves.fault;
        for (std::size_t move = 0; move < moves.edges.size(); ++move)
            if (const Word* const next = moves.words.data() + move * to.words;
                begins_cycle(moves.edges[move]) && passed_->contain(next))
                starts_of_.emplace(states_.add(next), start);
    };
    // Combines the current values with all states of the additional processes from index `first` on. Returns false if a
    // limit is reached.
    const auto combine = [&](const auto& self, std::size_t first) -> bool {
        if (first == stored.size()) {
            if (is_limited()) return false;
            for (std::size_t subset = 0; subset < std::size_t{1} << flags.size(); ++subset) {
                for (std::size_t i = 0; i < flags.size(); ++i)
                    to.variables[flags[i]].set(words.data(), static_cast<std::int64_t>(subset >> i & 1));
                begin();
            }
            return true;
        }
        const ProcessStates& local = *stored[first];
        for (const ProcessStates::State& state : local.states()) {
            if (ablations.start_initially && state != local.states().front()) continue;
            local.place(state, to, words.data());
            if (!self(self, first + 1)) return false;
        }
        return true;
    };
    if (within_->from_initial) states_.add(timed::packed_initial(states_.network(), to).data());
    for (const Word* const now : within_->starts) {
        coarser.states_.copy(now, to, words.data());
        if (!combine(combine, 0)) return {};
        if (fails) return false;
    }
    if (const std::optional<bool> found = states_.run(limits); !found || !*found) return found;
    for (std::uint32_t state = 0; state < states_.size(); ++state)
        considered_.push_back(last_->contain(states_.words(state)) && !is_goal(states_.words(state)));
    return true;
}

/// True if a refinement considers a move: the run is between the beginning of its last cycle and its last states, or it
/// remains in the last states. A further cycle begins only in the last states.
bool AvoidingRuns::admits(const Word* from, std::uint32_t edge, const Word* to) {
    if (!passed_->contain(to)) return false;
    return !begins_cycle(edge) || (last_->contain(from) && !is_goal(from));
}

/// True if the edge begins a cycle of a PLC: it leaves the location W, before the PLC samples its inputs.
bool AvoidingRuns::begins_cycle(std::uint32_t edge) const {
    const Id<Network::Process> process = states_.machine().process_of(edge);
    const Network& network = states_.network();
    const Network::Template& automaton = network.templates[network.processes[process].automaton];
    return std::ranges::any_of(network.controllers, [&](const Network::Controller& controller) {
        return controller.process == process &&
               automaton.edges[states_.machine().edge_of(edge)].from == controller.waiting;
    });
}

/// Computes the predecessors of all states.
void AvoidingRuns::find_predecessors(const timed::Limits& limits) {
    if (!first_of_.empty()) return;
    const auto each = [&](const auto& visit) {
        for (std::uint32_t state = 0; state < states_.size(); ++state) {
            limits.poll();
            states_.each_move(state, [&](std::uint32_t edge, std::uint32_t next) {
                if (next != timed::Store::none) visit(next, Predecessor{state, begins_cycle(edge)});
            });
        }
    };
    std::vector<std::size_t> first(states_.size() + 1);
    each([&](std::uint32_t to, const Predecessor&) { ++first[to + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    predecessors_.resize(first.back());
    std::vector<std::size_t> next = first;
    each([&](std::uint32_t to, const Predecessor& from) { predecessors_[next[to]++] = from; });
    first_of_ = std::move(first);
}

bool AvoidingRuns::find_starts(Remainder& remainder, const FollowLimits& follow) {
    if (states_.recorded_moves() > most_predecessors) return false;
    const auto found = within_limits(follow, [&](const timed::Limits& limits) -> std::optional<bool> {
        find_predecessors(limits);
        std::vector<bool> seen(states_.size());
        std::set<std::uint32_t> starts, first_starts;  // numbers in states_ and starts_
        std::vector<std::uint32_t> open = remainder.states;
        for (const std::uint32_t state : open) seen[state] = true;
        while (!open.empty()) {
            limits.poll();
            const std::uint32_t state = open.back();
            open.pop_back();
            add_to(remainder.passed, states_.words(state));
            if (state == 0 && (within_ == nullptr || within_->from_initial)) remainder.from_initial = true;
            const auto [begin, end] = starts_of_.equal_range(state);
            for (auto start = begin; start != end; ++start) first_starts.insert(start->second);
            for (std::size_t i = first_of_[state]; i < first_of_[state + 1]; ++i) {
                const Predecessor& before = predecessors_[i];
                if (before.begins) starts.insert(before.state);
                else if (!seen[before.state]) {
                    seen[before.state] = true;
                    open.push_back(before.state);
                }
            }
        }
        for (const std::uint32_t start : starts) remainder.starts.push_back(states_.words(start));
        for (const std::uint32_t start : first_starts) remainder.starts.push_back(starts_.words(start));
        return true;
    });
    return found.has_value();
}

std::uint32_t AvoidingRuns::compiled(Id<Expr> term) {
    return states_.machine().compiler().condition(term, timed::Program::yes, timed::Program::no);
}

bool AvoidingRuns::is_goal(const Word* words) { return states_.machine().holds(q_, words, registers_) == End::Yes; }

/// True if an urgent edge is enabled in the state. The edges that the abstraction adds are not urgent.
bool AvoidingRuns::is_urgent(std::uint32_t state) const {
    bool found = false;
    states_.each_move(state,
                      [&](std::uint32_t edge, std::uint32_t) { found = found || states_.machine().urgent(edge); });
    return found;
}

/// True if the process is stored, and the invariant of its location in the state has a bound.
bool AvoidingRuns::is_bounded(std::uint32_t process, std::uint32_t state) const {
    if (!is_stored_[process]) return false;
    const auto location = states_.machine().layout().locations[process].get(states_.words(state));
    const Network::Template& automaton = loop_.templates[loop_.processes[{process}].automaton];
    return !automaton.locations[{static_cast<std::uint32_t>(location)}].invariant.empty();
}

/// Finds the states in which q is awaited: from a state in which p holds or is undefined, only states without q lead to
/// them.
void AvoidingRuns::find_awaiting(const timed::Limits& limits) {
    considered_.assign(states_.size(), false);
    std::vector<std::uint32_t> open;
    const auto add = [&](std::uint32_t state) {
        if (considered_[state] || is_goal(states_.words(state))) return;
        considered_[state] = true;
        open.push_back(state);
    };
    const auto roots = static_cast<std::uint32_t>(is_inevitable_ ? 1 : states_.size());
    for (std::uint32_t root = 0; root < roots; ++root) {
        limits.poll();
        if (states_.machine().holds(p_, states_.words(root), registers_) == End::No) continue;
        requested_ = true;
        add(root);
        while (!open.empty()) {
            limits.poll();
            const std::uint32_t state = open.back();
            open.pop_back();
            states_.each_move(state, [&](std::uint32_t, std::uint32_t next) { add(next); });
        }
    }
}

AvoidingRuns::PackedSituations::PackedSituations(const AvoidingRuns& runs, const Situations& situations)
    : mask(runs.states_.machine().layout().words), rows(mask.size()), now(mask.size()) {
    for (const std::uint32_t column : situations.columns) {
        const timed::Field& field = runs.field(column);
        mask[field.word] |= field.mask();
    }
    for (const std::vector<std::int64_t>& row : situations.values) {
        for (std::size_t i = 0; i < row.size(); ++i) runs.field(situations.columns[i]).set(now.data(), row[i]);
        rows.add(now.data());
    }
}

bool AvoidingRuns::PackedSituations::contain(const Word* words) {
    for (std::size_t i = 0; i < mask.size(); ++i) now[i] = mask[i] == 0 ? 0 : words[i] & mask[i];
    return rows.contains(now.data());
}

/// Returns the field of a column of situations.
const timed::Field& AvoidingRuns::field(std::uint32_t column) const {
    const timed::Layout& layout = states_.machine().layout();
    return column < loop_.variables.size() ? layout.variables[column]
                                           : layout.locations[column - loop_.variables.size()];
}

void AvoidingRuns::add_to(Situations& situations, const Word* words) const {
    situations.columns = columns_;
    std::vector<std::int64_t> row;
    for (const std::uint32_t column : columns_) row.push_back(field(column).get(words));
    situations.values.insert(std::move(row));
}

std::optional<std::vector<Remainder>> AvoidingRuns::remaining(const Situations* situations,
                                                              const FollowLimits& follow) {
    return within_limits(follow, [&](const timed::Limits& limits) -> std::optional<std::vector<Remainder>> {
        std::vector<bool> considered = considered_;
        std::optional<PackedSituations> packed;
        if (situations != nullptr) packed.emplace(*this, *situations);
        for (std::uint32_t state = 0; state < states_.size() && packed; ++state) {
            limits.poll();
            considered[state] = considered[state] && packed->contain(states_.words(state));
        }
        timed::Components components(states_.size(), limits, [&](std::uint32_t state, const auto& take) {
            states_.each_move(state, [&](std::uint32_t, std::uint32_t next) {
                if (next != timed::Store::none && considered[next]) take(next);
            });
        });
        const auto each_state = [&](const auto& visit) {
            for (std::uint32_t state = 0; state < states_.size(); ++state) {
                limits.poll();
                if (considered[state]) visit(state);
            }
        };
        each_state([&](std::uint32_t state) { components.visit(state); });
        std::unordered_map<std::uint32_t, Component> found;
        each_state([&](std::uint32_t state) {
            const bool stays = may_stay(state);
            if (!stays && !components.has_cycle(state)) return;
            Component& component = found[components.of(state)];
            component.stays = component.stays || stays;
            component.repeats = components.has_cycle(state);
            if (component.repeats) add(state, components, component);
        });
        std::erase_if(found, [&](const auto& entry) { return !entry.second.stays && !may_repeat(entry.second); });
        if (found.empty()) return std::vector<Remainder>();
        const auto each_found = [&](const auto& visit) {
            each_state([&](std::uint32_t state) {
                if (const auto at = found.find(components.of(state)); at != found.end()) visit(state, at->second);
            });
        };
        each_found([&](std::uint32_t state, Component& component) { add_deciding(state, components, component); });
        std::map<std::set<std::size_t>, std::vector<std::uint32_t>> groups;
        each_found(
            [&](std::uint32_t state, const Component& component) { groups[component.deciding].push_back(state); });
        std::vector<Remainder> made;
        for (auto& [deciding, states] : groups) {
            Remainder& remainder = made.emplace_back(Remainder{.states = std::move(states), .deciding = deciding});
            for (const std::uint32_t state : remainder.states) add_to(remainder.last, states_.words(state));
        }
        return made;
    });
}

/// Adds the Chosen processes whose values enable moves from the state out of its component.
template <class Components>
void AvoidingRuns::add_deciding(std::uint32_t state, const Components& components, Component& component) {
    const std::vector<InputChoice>& choices = states_.machine().choices();
    std::vector<std::uint32_t> successors;
    states_.each_move(state, [&](std::uint32_t, std::uint32_t next) { successors.push_back(next); });
    const timed::Moves& moves = states_.expand(state, true);
    for (std::size_t move = 0; move < moves.edges.size() && move < successors.size(); ++move) {
        const std::uint32_t next = successors[move];
        if (next != timed::Store::none && components.of(next) == components.of(state)) continue;
        for (std::size_t i = 0; i < choices.size(); ++i) {
            if (states_.machine().process_of(moves.edges[move]) != choices[i].plc) continue;
            const Word all = ~Word{0} >> (64 - choices[i].valuations.size());
            if ((moves.chosen[move * choices.size() + i] & all) != all) component.deciding.insert(choices[i].instance);
        }
    }
}

/// True if time can pass forever in the state.
bool AvoidingRuns::may_stay(std::uint32_t state) {
    if (is_urgent(state)) return false;
    for (std::uint32_t process = 0; process < loop_.processes.size(); ++process)
        if (is_bounded(process, state)) return false;
    return true;
}

/// Adds the properties of one state to its component.
template <class Components>
void AvoidingRuns::add(std::uint32_t state, const Components& components, Component& component) {
    component.moves.resize(loop_.processes.size());
    component.unbounded.resize(loop_.processes.size());
    component.urgent = component.urgent && is_urgent(state);
    states_.each_move(state, [&](std::uint32_t edge, std::uint32_t next) {
        if (next != timed::Store::none && components.of(next) == components.of(state))
            component.moves[states_.machine().process_of(edge).index] = true;
    });
    for (std::uint32_t process = 0; process < loop_.processes.size(); ++process)
        if (!is_bounded(process, state)) component.unbounded[process] = true;
}

/// True if a run in which time diverges can stay in the component forever.
bool AvoidingRuns::may_repeat(const Component& component) const {
    if (!component.repeats || component.urgent) return false;
    for (std::size_t process = 0; process < loop_.processes.size(); ++process)
        if (!component.unbounded[process] && !component.moves[process]) return false;
    return true;
}

}  // namespace grafverif
