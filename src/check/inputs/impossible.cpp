// SPDX-License-Identifier: MIT
#include "check/inputs/impossible.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "check/timed/machine.hpp"
#include "ir/junction.hpp"
#include "ir/network_run.hpp"
#include "ir/slots.hpp"

namespace grafverif {

using timed::Word;

namespace {

constexpr std::size_t most_members = 4;  // maximum number of processes that are executed jointly

// Maximum number of states of a single process, and of a group.
constexpr std::size_t most_states_alone = std::size_t{1} << 17U, most_states_jointly = std::size_t{1} << 14U;

}  // namespace

std::vector<std::vector<std::size_t>> joint_groups(const std::vector<AbstractableProcess>& instances,
                                                   const std::vector<InputLevel>& levels) {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (levels[i] == InputLevel::Complete) continue;
        std::vector<std::size_t> group{i};
        groups.push_back(group);
        if (levels[i] != InputLevel::Chosen) continue;  // only groups of Chosen instances have several members
        for (std::size_t next = 0; next < group.size(); ++next)
            for (std::size_t writer = 0; writer < instances.size(); ++writer) {
                if (levels[writer] != InputLevel::Chosen || std::ranges::find(group, writer) != group.end()) continue;
                if (std::ranges::find(instances[writer].readers, instances[group[next]].process) !=
                    instances[writer].readers.end())
                    group.push_back(writer);
            }
        std::ranges::sort(group);
        const bool is_new = std::ranges::find(groups, group) == groups.end();
        if (group.size() > 1 && group.size() <= most_members && is_new) groups.push_back(std::move(group));
    }
    return groups;
}

namespace {

/// A group of processes of the network, represented by the set of states that the group can have. The variables that
/// other processes write have fixed values.
class ProcessGroup {
public:
    struct Member {
        const AbstractableProcess& process;
        InputLevel level = {};
    };

    /// `known` contains the variables of other processes whose values are fixed.
    ProcessGroup(const Network& complete, const std::vector<Member>& members, std::int64_t unit,
                 const std::set<Id<Network::Variable>>& known, const FollowLimits& limits)
        : network_(only(complete, members, unit, known)),
          machine_(network_),
          limits_(limits),
          most_states_(members.size() == 1 ? most_states_alone : most_states_jointly) {
        for (const Member& member : members) {
            members_.push_back(&member.process);
            for (const Id<Network::Variable> variable : Slots(network_, member.process.process).read())
                if (known.contains(variable)) given_.insert(variable);
        }
        for (const Member& member : members)
            for (const Id<Network::Variable> variable : Slots(network_, member.process.process).written())
                changes_given_ = changes_given_ || given_.contains(variable);
        states_ = {timed::packed_initial(network_, machine_.layout())};
    }

    /// Replaces the states of this group by the states of `other`. `other` has the same members, but other guards, and
    /// therefore possibly another layout of the states.
    void continue_in(const ProcessGroup& other) {
        const timed::Layout &from = other.machine_.layout(), &to = machine_.layout();
        const std::vector<Word> initial = timed::packed_initial(network_, to);
        const auto copy = [](const timed::Field& source, const Word* words, const timed::Field& target, Word* made) {
            const std::int64_t greatest = target.low + static_cast<std::int64_t>(target.all());
            target.set(made, std::clamp(source.get(words), target.low, greatest));
        };
        states_.clear();
        for (const std::vector<Word>& words : other.states_) {
            std::vector<Word> made = initial;
            for (const AbstractableProcess* const member : members_) {
                const std::size_t process = member->process.index;
                copy(from.locations[process], words.data(), to.locations[process], made.data());
                for (std::size_t clock = 0; clock < to.clocks[process].size(); ++clock)
                    copy(from.clocks[process][clock], words.data(), to.clocks[process][clock], made.data());
                for (const Id<Network::Variable> variable : Slots(network_, member->process).written())
                    if (!network_.variables[variable].scratch)
                        copy(from.variables[variable.index], words.data(), to.variables[variable.index], made.data());
            }
            states_.insert(std::move(made));
        }
        is_incomplete_ = other.is_incomplete_;
        given_values_.clear();
        closed_by_ = Closed::No;
    }

    /// Sets the values of the variables of other processes.
    void give(const std::vector<std::int64_t>& variables) {
        move();
        std::vector<std::int64_t> values;
        for (const Id<Network::Variable> variable : given_) values.push_back(variables[variable.index]);
        if (values == given_values_ && !changes_given_) return;
        given_values_ = std::move(values);
        closed_by_ = Closed::No;
        States given;
        for (std::vector<Word> words : states_) {
            for (const Id<Network::Variable> variable : given_)
                machine_.layout().variables[variable.index].set(words.data(), variables[variable.index]);
            given.insert(std::move(words));
        }
        states_ = std::move(given);
    }

    void pass_time(std::int64_t units) {
        for (; units > 0 && !states_.empty(); --units) {
            move();
            if (is_incomplete_) return;
            States later;
            for (std::vector<Word> words : states_)
                if (delay(words)) later.insert(std::move(words));
            if (later == states_) return;
            states_ = std::move(later);
            closed_by_ = Closed::No;
        }
    }

    /// Adds all states that are reachable by delays and edges.
    void wait() { close(true); }

    /// Adds all states that are reachable by edges, and then keeps only states in which the member
    /// has one of the valuations in `possible`.
    void show(std::size_t member, Word possible) {
        move();
        keep(member, possible);
    }

    /// Keeps only states in which the member has one of the valuations in `possible`.
    void keep(std::size_t member, Word possible) {
        const AbstractableProcess& process = *members_[member];
        erase_if([&](const std::vector<Word>& words) {
            std::vector<std::int64_t> values;
            for (const Id<Network::Variable> output : process.read_outputs)
                values.push_back(machine_.layout().variables[output.index].get(words.data()));
            const auto row = std::ranges::find(process.valuations, values) - process.valuations.begin();
            return (possible >> row & 1U) == 0;
        });
    }

    /// Keeps only states in which the member has the location and the outputs of the abstract state.
    void match(std::size_t member, const NetworkState& state) {
        move();
        const AbstractableProcess& process = *members_[member];
        erase_if([&](const std::vector<Word>& words) {
            const auto differs = [&](Id<Network::Variable> output) {
                return machine_.layout().variables[output.index].get(words.data()) != state.variables[output.index];
            };
            const std::int64_t location = machine_.layout().locations[process.process.index].get(words.data());
            return location != state.locations[process.process.index].index ||
                   std::ranges::any_of(process.outputs, differs);
        });
    }

    bool is_nowhere() const { return states_.empty(); }
    /// True if a limit has ended the computation of the states.
    bool is_incomplete() const { return is_incomplete_; }

private:
    using States = std::set<std::vector<Word>>;
    /// The moves under which the set of states is closed.
    enum class Closed : std::uint8_t { No, Edges, EdgesAndDelays };

    template <class Predicate>
    void erase_if(const Predicate& predicate) {
        if (std::erase_if(states_, predicate) != 0) closed_by_ = Closed::No;
    }

    static Network only(const Network& complete, const std::vector<Member>& members, std::int64_t unit,
                        const std::set<Id<Network::Variable>>& known) {
        Network network = complete;
        network.properties = {};
        std::set<Id<Network::Variable>> of_observers, is_known = known;
        for (const Member& member : members)
            is_known.insert(member.process.outputs.begin(), member.process.outputs.end());
        for (const Id<Network::Process> id : network.processes.ids()) {
            if (std::ranges::any_of(members, [&](const Member& member) { return member.process.process == id; }))
                continue;
            if (network.processes[id].kind == Network::ProcessKind::Observer)
                for (const Id<Network::Variable> variable : Slots(complete, id).written())
                    of_observers.insert(variable);
            Network::Template& automaton = network.templates[network.processes[id].automaton];
            automaton.edges = {};
            for (Network::Location& location : automaton.locations) location.invariant.clear();
        }
        for (const auto& [made, level] : members) {
            const Network::Process& process = complete.processes[made.process];
            Network::Template& automaton = network.templates[process.automaton];
            for (Network::Edge& edge : automaton.edges) {
                std::erase_if(edge.assignments, [&](const Network::Assignment& assignment) {
                    const Id<Network::Variable> target{
                        static_cast<std::uint32_t>(network.exprs[assignment.target].value)};
                    return std::ranges::find(made.outputs, target) == made.outputs.end();
                });
                keep_known_conjuncts(network, edge, is_known, of_observers);
            }
            if (level == InputLevel::Untimed) ignore_clocks(automaton);
            if (level == InputLevel::Paced) pace(complete, process, automaton, unit, network.exprs);
        }
        return network;
    }

    /// Reduces the guard to the conjuncts over known variables. The removed conjuncts are assumed
    /// to be true. An urgent edge must be taken only if the removed conjuncts are true; therefore,
    /// the edge is no longer urgent. A conjunct that reads only variables of observers does not
    /// change the urgency, because the conjunct is true whenever time passes.
    static void keep_known_conjuncts(Network& network, Network::Edge& edge,
                                     const std::set<Id<Network::Variable>>& known,
                                     const std::set<Id<Network::Variable>>& of_observers) {
        std::vector<Id<Expr>> kept;
        for (const Id<Expr> operand : operands_of(network.exprs, edge.guard, Op::And)) {
            const auto reads_only = [&](const std::set<Id<Network::Variable>>& variables) {
                return std::ranges::all_of(leaves(network.exprs, operand), [&](Id<Expr> leaf) {
                    return network.exprs[leaf].op != Op::Variable ||
                           variables.contains({static_cast<std::uint32_t>(network.exprs[leaf].value)});
                });
            };
            if (reads_only(known)) kept.push_back(operand);
            else if (!reads_only(of_observers)) edge.urgent = false;
        }
        edge.guard = network.exprs.conjunction(kept);
    }

    bool delay(std::vector<Word>& words) {
        machine_.expand(words.data(), moves_);
        return !moves_.urgent && machine_.delay(words.data());
    }

    /// Adds all states that are reachable by edges, without delays.
    void move() { close(false); }

    /// Adds all states that are reachable by edges and, if `waits` is true, by delays.
    void close(bool waits) {
        const Closed wanted = waits ? Closed::EdgesAndDelays : Closed::Edges;
        if (closed_by_ >= wanted) return;
        closed_by_ = Closed::No;
        std::vector<std::vector<Word>> open(states_.begin(), states_.end());
        const auto add = [&](std::vector<Word> words) {
            if (states_.insert(words).second) open.push_back(std::move(words));
        };
        while (!open.empty()) {
            if (polls_++ % search_poll_interval == 0 && is_over(limits_.deadline, limits_.stop)) is_incomplete_ = true;
            if (states_.size() > most_states_) is_incomplete_ = true;
            if (is_incomplete_) return;
            std::vector<Word> now = std::move(open.back());
            open.pop_back();
            machine_.expand(now.data(), moves_);
            for (std::size_t i = 0; i < moves_.edges.size(); ++i) {
                const Word* const next = moves_.words.data() + i * machine_.layout().words;
                add({next, next + machine_.layout().words});
            }
            if (waits && !moves_.urgent && machine_.delay(now.data())) add(std::move(now));
        }
        closed_by_ = wanted;
    }

    const Network network_;
    timed::Machine machine_;
    std::vector<const AbstractableProcess*> members_ = {};
    std::set<Id<Network::Variable>> given_ = {};
    timed::Moves moves_ = {};
    const FollowLimits& limits_;
    const std::size_t most_states_;
    States states_ = {};
    Closed closed_by_ = Closed::No;
    std::vector<std::int64_t> given_values_ = {};  // last values of the variables `given_`; empty if unknown
    bool changes_given_ = false;                   // true if a member can change some of these variables
    bool is_incomplete_ = false;
    std::size_t polls_ = 1;
};

/// Returns the variables of the loop whose values the abstract run contains.
std::set<Id<Network::Variable>> known_variables(const AbstractRun& run) {
    std::set<Id<Network::Variable>> known;
    for (const Id<Network::Process> id : run.network.processes.ids()) {
        if (run.network.processes[id].kind == Network::ProcessKind::Observer) continue;
        for (const Id<Network::Variable> variable : Slots(run.network, id).written())
            if (run.network.variables[variable].role != Network::Role::Flag && !run.network.variables[variable].scratch)
                known.insert(variable);
    }
    return known;  // an instance of the level Chosen has no edges in this network and therefore writes no variable
}

/// True if every PLC is in its waiting location W and in a stable situation.
bool is_stable(const AbstractRun& run, const NetworkState& state) {
    return std::ranges::all_of(run.network.controllers, [&](const Network::Controller& controller) {
        return state.locations[controller.process.index] == controller.waiting &&
               state.variables[controller.stable.index] != 0;
    });
}

/// True if every PLC is in a stable situation and no other process has an enabled urgent edge. Edges of PLCs do not
/// count, because the change of an input that begins a cycle may also occur later.
bool may_wait(const AbstractRun& run, const NetworkState& state) {
    return is_stable(run, state) && std::ranges::none_of(enabled(run.network, state), [&](const Fire& fire) {
               return run.network.processes[fire.process].kind != Network::ProcessKind::Controller &&
                      taken_edge(run.network, fire).urgent;
           });
}

/// Executes processes along an abstract run (see `impossible`).
class GroupReplay {
public:
    GroupReplay(const Network& complete, const AbstractRun& abstract, bool waits, const FollowLimits& limits)
        : complete_(complete),
          abstract_(abstract),
          waits_(waits),
          limits_(limits),
          units_(std::max<std::int64_t>(abstract.network.time_unit_ms / complete.time_unit_ms, 1)),
          samplings_(samplings(abstract)),
          known_(known_variables(abstract)) {
        for (const AbstractState& each : abstract.path) may_wait_.push_back(waits && may_wait(abstract, each.state));
    }

    std::optional<SpuriousMoves> impossible(const std::vector<std::size_t>& group) {
        group_ = group;
        std::optional<SpuriousMoves> found;
        std::vector<InputLevel> levels;
        for (const std::size_t i : group_) levels.push_back(abstract_.levels[i]);
        while (std::ranges::any_of(levels, [](InputLevel level) { return level != InputLevel::Complete; })) {
            for (std::size_t m = 0; m < group_.size(); ++m)
                if (levels[m] != InputLevel::Complete)
                    levels[m] = next_level(abstract_.instances[group_[m]], levels[m]);
            ProcessGroup processes = processes_at(levels, known_);
            const std::optional<std::size_t> at = first_impossible(processes, 0);
            if (!at) continue;
            const std::size_t from = since(processes, levels);
            if (!found || from > found->since) found = {*at, levels, from};
            if (from + 1 >= abstract_.path.size()) break;
        }
        return found;
    }

private:
    ProcessGroup processes_at(const std::vector<InputLevel>& levels,
                              const std::set<Id<Network::Variable>>& known) const {
        std::vector<ProcessGroup::Member> members;
        for (std::size_t m = 0; m < group_.size(); ++m) members.push_back({abstract_.instances[group_[m]], levels[m]});
        return {complete_, members, units_, known, limits_};
    }

    bool is_chosen(std::size_t member) const { return abstract_.levels[group_[member]] == InputLevel::Chosen; }

    void match(ProcessGroup& processes, const NetworkState& state) const {
        for (std::size_t m = 0; m < group_.size(); ++m)
            if (!is_chosen(m)) processes.match(m, state);
    }

    /// Executes the processes along the path from position `begin` on, starting in the current states of `processes`.
    /// Returns the first position that the processes cannot perform.
    std::optional<std::size_t> first_impossible(ProcessGroup& processes, std::size_t begin) const {
        if (waits_) processes.wait();
        auto next = samplings_.begin();
        std::map<Id<Network::Process>, const Sampling*> sampled;  // per PLC, its last sampling

        // A PLC samples each change of an input without delay. Therefore, while time passes in a stable situation, an
        // instance is assumed to have the valuation that was sampled last. (The abstract run may omit samplings without
        // effect.)
        const auto keep_sampled = [&](const NetworkState& state) {
            if (!is_stable(abstract_, state)) return;
            for (const auto& [plc, sampling] : sampled)
                for (std::size_t m = 0; m < group_.size(); ++m)
                    if (is_chosen(m)) processes.keep(m, sampling->possible[group_[m]]);
        };
        for (std::size_t at = 0; at < abstract_.path.size(); ++at) {
            const NetworkState& state = abstract_.path[at].state;
            const bool samples = next != samplings_.end() && next->at == at;
            if (samples) sampled[next->plc] = &*next;
            if (at >= begin) {
                if (const Delay* const delay = std::get_if<Delay>(&abstract_.path[at].move)) {
                    processes.pass_time(delay->units * units_);
                    keep_sampled(state);
                }
                match(processes, state);
                for (std::size_t m = 0; samples && m < group_.size(); ++m)
                    if (is_chosen(m)) processes.show(m, next->possible[group_[m]]);
                processes.give(state.variables);
                if (may_wait_[at]) {
                    processes.wait();
                    keep_sampled(state);
                }
                if (processes.is_incomplete()) return {};
                if (processes.is_nowhere()) return at;
            }
            if (samples) ++next;
        }
        return {};
    }

    /// Returns the greatest position such that the processes cannot perform the path from this position on, from any of
    /// their states. If the path cannot be performed from one position on, it cannot be performed
    /// from any earlier position on.
    std::size_t since(ProcessGroup& processes, const std::vector<InputLevel>& levels) const {
        ProcessGroup free = processes_at(levels, {});  // other variables may have any values
        free.wait();
        std::size_t low = 0, high = abstract_.path.size();
        while (high - low > 1) {
            const std::size_t middle = low + (high - low) / 2;
            processes.continue_in(free);
            match(processes, abstract_.path[middle - 1].state);
            processes.give(abstract_.path[middle - 1].state.variables);
            (first_impossible(processes, middle) ? low : high) = middle;
        }
        return low;
    }

    const Network& complete_;
    const AbstractRun& abstract_;
    const bool waits_;
    const FollowLimits& limits_;
    const std::int64_t units_;
    const std::vector<Sampling> samplings_;
    const std::set<Id<Network::Variable>> known_;
    std::vector<bool> may_wait_ = {};  // per position of the path: true if a delay may follow
    std::vector<std::size_t> group_ = {};
};

}  // namespace

std::vector<std::optional<SpuriousMoves>> impossible(const Network& complete, const AbstractRun& abstract,
                                                     const std::vector<std::vector<std::size_t>>& groups, bool waits,
                                                     const FollowLimits& limits) {
    GroupReplay replay(complete, abstract, waits, limits);
    std::vector<std::optional<SpuriousMoves>> found;
    for (const std::vector<std::size_t>& group : groups) found.push_back(replay.impossible(group));
    return found;
}

}  // namespace grafverif
