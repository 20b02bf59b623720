// SPDX-License-Identifier: MIT
#include "check/inputs/follow.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <set>
#include <string>
#include <utility>

#include "check/inputs/found_states.hpp"
#include "check/timed/machine.hpp"
#include "check/timed/property_queries.hpp"
#include "ir/junction.hpp"
#include "ir/slots.hpp"

namespace grafverif {

namespace {

using timed::Word;

using Signature = std::vector<std::int64_t>;

/// A stage of the abstract run, with the requirements for reaching the next stage.
struct Stage {
    Signature signature = {};
    std::vector<Word> goals = {};  // valuations sampled before the next stage, per instance
};

/// One sampling of a PLC, with the valuations of each instance that are possible after its cycle.
struct Sampling {
    std::size_t at = 0;  // index in the path
    Id<Network::Process> plc = {};
    std::vector<Word> possible = {};
};

const Network::Controller* controller_of(const AbstractRun& run, const AbstractState& state) {
    const auto* const fire = std::get_if<Fire>(&state.move);
    if (fire == nullptr) return nullptr;
    const auto found = std::ranges::find(run.network.controllers, fire->process, &Network::Controller::process);
    return found == run.network.controllers.end() ? nullptr : &*found;
}

bool samples(const AbstractRun& run, const AbstractState& state) {
    const Network::Controller* const controller = controller_of(run, state);
    if (controller == nullptr) return false;
    const auto& fire = std::get<Fire>(state.move);
    const Network::Edge& edge = run.network.templates[run.network.processes[fire.process].automaton].edges[fire.edge];
    return std::ranges::any_of(
        edge.calls, [&](Id<Network::Procedure> call) { return call == controller->fire || call == controller->start; });
}

/// Returns all samplings in order. Later edges of a cycle reduce the possible valuations of its sampling.
std::vector<Sampling> samplings(const AbstractRun& run) {
    std::vector<Sampling> found;
    std::vector<std::size_t> last(run.network.processes.size(), 0);  // last sampling of each PLC: its index plus 1
    for (std::size_t at = 0; at < run.path.size(); ++at) {
        const Network::Controller* const controller = controller_of(run, run.path[at]);
        if (controller == nullptr) continue;
        std::size_t& number = last[controller->process.index];
        if (samples(run, run.path[at])) {
            found.push_back({at, controller->process, std::vector<Word>(run.instances.size(), ~Word{0})});
            number = found.size();
        }
        if (number == 0) continue;
        for (std::size_t i = 0; i < run.choices.size(); ++i)
            if (const Word possible = run.path[at].possible[i]; possible != 0)
                found[number - 1].possible[run.choices[i].instance] &= possible;
    }
    for (Sampling& sampling : found)
        for (std::size_t i = 0; i < run.instances.size(); ++i) {
            const std::size_t valuations = run.instances[i].valuations.size();
            if (valuations == 0) continue;  // the instance is not Chosen
            const Word all = ~Word{0} >> (64 - valuations);
            if ((sampling.possible[i] & all) == all) sampling.possible[i] = ~Word{0};
        }
    return found;
}

}  // namespace

std::vector<Id<Network::Variable>> signature_variables(const Network& network) {
    std::vector<Id<Network::Variable>> found;
    for (const Id<Network::Variable> id : network.variables.ids()) {
        const Network::Variable& variable = network.variables[id];
        const bool counts = variable.role == Network::Role::Step || variable.role == Network::Role::Internal;
        if (counts && !variable.scratch) found.push_back(id);
    }
    return found;
}

namespace {

/// Returns the stages. The goals of a stage are the valuations of its last sampling. A stage without sampling has no
/// requirements.
std::vector<Stage> stages_of(const AbstractRun& run, const std::vector<Id<Network::Variable>>& signature) {
    std::vector<Stage> stages;
    const auto begin = [&](const std::vector<std::int64_t>& variables) {
        Signature now;
        for (const Id<Network::Variable> id : signature) now.push_back(variables[id.index]);
        if (!stages.empty() && stages.back().signature == now) return;
        stages.push_back({std::move(now), std::vector<Word>(run.instances.size(), ~Word{0})});
    };
    std::vector<std::int64_t> initial;
    for (const Network::Variable& variable : run.network.variables) initial.push_back(variable.initial);
    begin(initial);
    const std::vector<Sampling> all = samplings(run);
    auto next = all.begin();
    for (std::size_t at = 0; at < run.path.size(); ++at) {
        if (next != all.end() && next->at == at) stages.back().goals = (next++)->possible;
        begin(run.path[at].state.variables);
    }
    return stages;
}

/// A single process of the network with given values of other variables, represented by the set of its possible states.
class SingleProcess {
public:
    /// `known` contains the variables of other processes whose values are given.
    SingleProcess(const Network& complete, const AbstractableProcess& process, InputLevel level, std::int64_t unit,
                  const std::set<Id<Network::Variable>>& known)
        : process_(process), network_(only(complete, process, level, unit, known)), machine_(network_) {
        for (const Id<Network::Variable> variable : Slots(network_, process.process).read())
            if (known.contains(variable)) given_.push_back(variable);
        states_.insert(timed::packed_initial(network_, machine_.layout()));
    }

    /// Sets the values of the variables of other processes.
    void give(const std::vector<std::int64_t>& variables) {
        move();
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
            States later;
            for (std::vector<Word> words : states_)
                if (delay(words)) later.insert(std::move(words));
            if (later == states_) return;
            states_ = std::move(later);
        }
    }

    /// Adds the states that are reached by any delay.
    void wait() {
        for (std::size_t size = 0; size != states_.size();) {
            move();
            size = states_.size();
            const States now = states_;
            for (std::vector<Word> words : now)
                if (delay(words)) states_.insert(std::move(words));
        }
    }

    /// Keeps only states that have one of the valuations, possibly after moves.
    void show(Word possible) {
        move();
        keep(possible);
    }

    /// Keeps only states that have one of the valuations.
    void keep(Word possible) {
        std::erase_if(states_, [&](const std::vector<Word>& words) {
            std::vector<std::int64_t> values;
            for (const Id<Network::Variable> output : process_.outputs)
                values.push_back(machine_.layout().variables[output.index].get(words.data()));
            const auto row = std::ranges::find(process_.valuations, values) - process_.valuations.begin();
            return (possible >> row & 1U) == 0;
        });
    }

    /// Keeps only states with the location and the outputs of the abstract state.
    void match(const NetworkState& state) {
        move();
        std::erase_if(states_, [&](const std::vector<Word>& words) {
            const auto differs = [&](Id<Network::Variable> output) {
                return machine_.layout().variables[output.index].get(words.data()) != state.variables[output.index];
            };
            const std::int64_t location = machine_.layout().locations[process_.process.index].get(words.data());
            return location != state.locations[process_.process.index].index ||
                   std::ranges::any_of(process_.outputs, differs);
        });
    }

    bool is_nowhere() const { return states_.empty(); }

private:
    using States = std::set<std::vector<Word>>;

    static Network only(const Network& complete, const AbstractableProcess& made, InputLevel level, std::int64_t unit,
                        const std::set<Id<Network::Variable>>& known) {
        Network network = complete;
        network.properties = {};
        std::set<Id<Network::Variable>> of_observers;
        for (const Id<Network::Process> id : network.processes.ids()) {
            if (id == made.process) continue;
            if (network.processes[id].kind == Network::ProcessKind::Observer)
                for (const Id<Network::Variable> variable : Slots(complete, id).written())
                    of_observers.insert(variable);
            Network::Template& automaton = network.templates[network.processes[id].automaton];
            automaton.edges = {};
            for (Network::Location& location : automaton.locations) location.invariant.clear();
        }
        const Network::Process& process = complete.processes[made.process];
        Network::Template& automaton = network.templates[process.automaton];
        for (Network::Edge& edge : automaton.edges) {
            std::erase_if(edge.assignments, [&](const Network::Assignment& assignment) {
                const Id<Network::Variable> target{static_cast<std::uint32_t>(network.exprs[assignment.target].value)};
                return std::ranges::find(made.outputs, target) == made.outputs.end();
            });
            keep_known_conjuncts(network, made, edge, known, of_observers);
        }
        if (level == InputLevel::Untimed) ignore_clocks(automaton);
        if (level == InputLevel::Paced) pace(complete, process, automaton, unit, network.exprs);
        return network;
    }

    /// Reduces the guard to the conjuncts over outputs and known variables. The other conjuncts are assumed to be true.
    /// Because the edge must be taken only if they are true, it is no longer urgent, unless observers write all
    /// variables that they read: these conjuncts are true whenever time passes.
    static void keep_known_conjuncts(Network& network, const AbstractableProcess& made, Network::Edge& edge,
                                     const std::set<Id<Network::Variable>>& known,
                                     const std::set<Id<Network::Variable>>& of_observers) {
        std::vector<Id<Expr>> kept;
        const Exprs from = network.exprs;
        for (const Id<Expr> operand : operands_of(from, edge.guard, Op::And)) {
            const auto reads_only = [&](const auto& accepts) {
                return std::ranges::all_of(leaves(from, operand), [&](Id<Expr> leaf) {
                    return from[leaf].op != Op::Variable || accepts({static_cast<std::uint32_t>(from[leaf].value)});
                });
            };
            const auto is_known = [&](Id<Network::Variable> variable) {
                return known.contains(variable) || std::ranges::find(made.outputs, variable) != made.outputs.end();
            };
            if (reads_only(is_known)) kept.push_back(operand);
            else if (!reads_only([&](Id<Network::Variable> variable) { return of_observers.contains(variable); }))
                edge.urgent = false;
        }
        edge.guard = network.exprs.conjunction(kept);
    }

    bool delay(std::vector<Word>& words) {
        machine_.expand(words.data(), moves_);
        return !moves_.urgent && machine_.delay(words.data());
    }

    /// Adds all states that are reachable by edges, without the passing of time.
    void move() {
        std::vector<std::vector<Word>> open(states_.begin(), states_.end());
        while (!open.empty()) {
            const std::vector<Word> now = std::move(open.back());
            open.pop_back();
            machine_.expand(now.data(), moves_);
            for (std::size_t i = 0; i < moves_.edges.size(); ++i) {
                const Word* const next = moves_.words.data() + i * machine_.layout().words;
                std::vector<Word> words(next, next + machine_.layout().words);
                if (states_.insert(words).second) open.push_back(std::move(words));
            }
        }
    }

    const AbstractableProcess& process_;
    const Network network_;
    timed::Machine machine_;
    std::vector<Id<Network::Variable>> given_ = {};
    timed::Moves moves_ = {};
    States states_ = {};
};

class Follower {
public:
    Follower(const Network& network, const Property& property, const AbstractRun& run, const FollowLimits& limits)
        : network_(network),
          machine_(network),
          layout_(machine_.layout()),
          run_(run),
          limits_(limits),
          questions_(network, machine_, watch_),
          signature_(signature_variables(run.network)),
          stages_(stages_of(run, signature_)),
          instance_of_(network.processes.size(), none) {
        questions_.add_query({}, property);
        for (std::size_t i = 0; i < run.instances.size(); ++i) instance_of_[run.instances[i].process.index] = i;
    }

    ConcreteRun search() {
        if (!layout_.fits()) return {};
        add(timed::packed_initial(network_, layout_).data(), 0, 0, Delay{0});
        for (std::size_t polls = 0; !shown_ && !open_.empty() && states_.size() < limits_.states; ++polls) {
            if (polls % search_poll_interval == 0 && is_over(limits_.deadline, limits_.stop)) break;
            const std::size_t node = open_.top().node;
            open_.pop();
            expand(node);
        }
        ConcreteRun result;
        if (shown_) result.run = states_.run_to(*shown_);
        else result.blamed = blamed();
        return result;
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    struct Open {
        std::size_t stages_left = 0, distance = 0, node = 0;
        auto operator<=>(const Open&) const = default;
    };
    /// Returns the number of variables of the signature that differ from those of a stage.
    std::size_t distance(const Word* words, std::size_t stage) const {
        std::size_t differing = 0;
        for (std::size_t i = 0; i < signature_.size(); ++i)
            if (layout_.variables[signature_[i].index].get(words) != stages_[stage].signature[i]) ++differing;
        return differing;
    }

    /// Returns the last stage after `stage`, the stage of the predecessor, whose signature the state has. If there is
    /// no such stage, returns `stage`.
    std::size_t stage_of(const Word* words, std::size_t stage) const {
        for (std::size_t later = stages_.size(); later-- > stage + 1;)
            if (distance(words, later) == 0) return later;
        return stage;
    }

    void add(const Word* at, std::size_t parent, std::size_t from_stage, const Move& move) {
        const std::size_t stage = stage_of(at, from_stage);
        const std::optional<std::size_t> node = states_.add(at, parent, stage, move);
        if (!node) return;
        const std::size_t next = std::min(stage + 1, stages_.size() - 1);
        open_.push({stages_.size() - stage, distance(at, next), *node});
        last_stage_ = std::max(last_stage_, stage);
        if (!shown_ && watch_.needs(machine_, at, registers_)) {
            watch_.look(machine_, static_cast<std::uint32_t>(*node), at, registers_);
            shown_ = questions_.state_found(0);
        }
    }

    /// True if the process may move. An autonomous Chosen instance moves only if its outputs are not among the goals of
    /// the stage; all other processes move freely.
    bool may_move(const Word* at, std::size_t stage, Id<Network::Process> process) const {
        const std::size_t i = instance_of_[process.index];
        if (i == none || run_.levels[i] != InputLevel::Chosen) return true;
        const AbstractableProcess& instance = run_.instances[i];
        if (!instance.autonomous) return true;
        std::vector<std::int64_t> values;
        for (const Id<Network::Variable> output : instance.outputs)
            values.push_back(layout_.variables[output.index].get(at));
        const auto row = std::ranges::find(instance.valuations, values) - instance.valuations.begin();
        return (stages_[stage].goals[i] >> row & 1U) == 0;
    }

    void expand(std::size_t node) {
        const std::size_t stage = states_.mark(node);
        states_.load(node, now_);
        machine_.expand(now_.data(), moves_);
        const bool urgent = moves_.urgent;
        for (std::size_t i = 0; i < moves_.edges.size() && !shown_; ++i) {
            const Fire fire{machine_.process_of(moves_.edges[i]), machine_.edge_of(moves_.edges[i])};
            if (may_move(now_.data(), stage, fire.process))
                add(moves_.words.data() + i * layout_.words, node, stage, fire);
        }
        if (!urgent && !shown_ && machine_.delay(now_.data())) add(now_.data(), node, stage, Delay{1});
    }

    /// Returns the instances that the last reached stage constrains. If there are none, returns the instances that the
    /// stage before it constrains, or else those of the first stage with a constraint.
    std::vector<std::size_t> blamed() const {
        const auto constrained = [&](const Stage& stage) {
            std::vector<std::size_t> found;
            for (std::size_t i = 0; i < stage.goals.size(); ++i)
                if (stage.goals[i] != ~Word{0}) found.push_back(i);
            return found;
        };
        std::vector<std::size_t> found = constrained(stages_[last_stage_]);
        if (found.empty() && last_stage_ > 0) found = constrained(stages_[last_stage_ - 1]);
        for (std::size_t i = 0; found.empty() && i < stages_.size(); ++i) found = constrained(stages_[i]);
        return found;
    }

    const Network& network_;
    timed::Machine machine_;
    const timed::Layout& layout_;
    const AbstractRun& run_;
    const FollowLimits& limits_;
    timed::PropertyMonitor watch_ = {};
    timed::PropertyQueries questions_;
    std::vector<Id<Network::Variable>> signature_;
    std::vector<Stage> stages_;
    std::vector<std::size_t> instance_of_;  // instance of each process, or none
    FoundStates states_ = FoundStates(layout_);
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open_ = {};
    std::size_t last_stage_ = 0;
    std::optional<std::size_t> shown_ = {};
    std::vector<Word> now_ = {};  // the state that is expanded
    timed::Moves moves_ = {};
    timed::PropertyMonitor::Registers registers_ = {};
};

}  // namespace

namespace {

/// Returns the variables of the loop whose values the abstract run contains.
std::set<Id<Network::Variable>> known_variables(const AbstractRun& run) {
    std::set<Id<Network::Variable>> known;
    for (const Id<Network::Process> id : run.network.processes.ids()) {
        if (run.network.processes[id].kind == Network::ProcessKind::Observer) continue;
        for (const Id<Network::Variable> variable : Slots(run.network, id).written())
            if (run.network.variables[variable].role != Network::Role::Flag && !run.network.variables[variable].scratch)
                known.insert(variable);
    }
    return known;  // a Chosen instance has no edges in this network and therefore writes nothing
}

/// True if every PLC is in W and stable.
bool is_stable(const AbstractRun& run, const NetworkState& state) {
    return std::ranges::all_of(run.network.controllers, [&](const Network::Controller& controller) {
        return state.locations[controller.process.index] == controller.waiting &&
               state.variables[controller.stable.index] != 0;
    });
}

}  // namespace

std::optional<SpuriousMove> impossible(const Network& complete, const AbstractRun& abstract, std::size_t instance,
                                       bool waits) {
    const InputLevel now = abstract.levels[instance];
    const std::int64_t units = std::max<std::int64_t>(abstract.network.time_unit_ms / complete.time_unit_ms, 1);
    const std::vector<Sampling> all = samplings(abstract);
    const std::set<Id<Network::Variable>> known = known_variables(abstract);
    const auto first = [&](InputLevel level) -> std::optional<SpuriousMove> {
        SingleProcess alone(complete, abstract.instances[instance], level, units, known);
        if (waits) alone.wait();
        auto next = all.begin();
        std::map<Id<Network::Process>, Word> sampled;  // per PLC, the valuations of its last sampling
        // A PLC samples each change at once. Therefore, an instance is assumed to have the sampled valuation while time
        // passes in a stable situation. (The abstract run may omit samplings without effect.)
        const auto keep_sampled = [&](const NetworkState& state) {
            if (now != InputLevel::Chosen || !is_stable(abstract, state)) return;
            for (const auto& [plc, possible] : sampled) alone.keep(possible);
        };
        for (std::size_t at = 0; at < abstract.path.size(); ++at) {
            const NetworkState& state = abstract.path[at].state;
            if (const Delay* const delay = std::get_if<Delay>(&abstract.path[at].move)) {
                alone.pass_time(delay->units * units);
                keep_sampled(state);
            }
            if (now != InputLevel::Chosen) alone.match(state);
            if (next != all.end() && next->at == at) {
                if (now == InputLevel::Chosen) alone.show(next->possible[instance]);
                sampled[next->plc] = next->possible[instance];
                ++next;
            }
            if (alone.is_nowhere()) return SpuriousMove{at, level};
            alone.give(state.variables);
            if (!waits || !is_stable(abstract, state)) continue;
            alone.wait();
            keep_sampled(state);
            if (alone.is_nowhere()) return SpuriousMove{at, level};
        }
        return {};
    };
    for (InputLevel level = now; level != InputLevel::Complete;) {
        level = next_level(abstract.instances[instance], level);
        if (const std::optional<SpuriousMove> found = first(level)) return found;
    }
    return {};
}

ConcreteRun follow(const Network& network, const Property& property, const AbstractRun& abstract,
                   const FollowLimits& limits) {
    return Follower(network, property, abstract, limits).search();
}

}  // namespace grafverif
