// SPDX-License-Identifier: MIT
#include "check/inputs/follow.hpp"

#include <algorithm>
#include <functional>
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

/// A stage of the abstract run: a section with constant values of the steps and internal variables (the signature).
struct Stage {
    Signature signature = {};
    /// Per instance: for each sampling of the stage, the set of output valuations that the sampling
    /// permits. A set that contains all valuations is omitted.
    std::vector<std::vector<Word>> goals = {};
    std::vector<bool> moves = {};  // per instance: true if the run contains a move of the instance in the stage
};

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

/// Returns the stages. A sampling that changes the signature (the steps and internal variables) belongs to the stage
/// before the change.
std::vector<Stage> stages_of(const AbstractRun& run, const std::vector<Id<Network::Variable>>& signature) {
    std::vector<Stage> stages;
    const auto begin = [&](const std::vector<std::int64_t>& variables) {
        Signature now;
        for (const Id<Network::Variable> id : signature) now.push_back(variables[id.index]);
        if (!stages.empty() && stages.back().signature == now) return;
        stages.push_back({std::move(now), std::vector<std::vector<Word>>(run.instances.size()),
                          std::vector<bool>(run.instances.size())});
    };
    std::vector<std::int64_t> initial;
    for (const Network::Variable& variable : run.network.variables) initial.push_back(variable.initial);
    begin(initial);
    const auto require = [&](const Sampling& sampling) {
        for (std::size_t i = 0; i < run.instances.size(); ++i) {
            std::vector<Word>& goals = stages.back().goals[i];
            const Word possible = sampling.possible[i];
            if (possible != ~Word{0} && std::ranges::find(goals, possible) == goals.end()) goals.push_back(possible);
        }
    };
    const std::vector<Sampling> all = samplings(run);
    auto next = all.begin();
    for (std::size_t at = 0; at < run.path.size(); ++at) {
        if (next != all.end() && next->at == at) require(*next++);
        if (const auto* const fire = std::get_if<Fire>(&run.path[at].move))
            for (std::size_t i = 0; i < run.instances.size(); ++i)
                if (run.instances[i].process == fire->process) stages.back().moves[i] = true;
        begin(run.path[at].state.variables);
    }
    return stages;
}

class Follower {
public:
    Follower(const Network& network, const Property& property, const AbstractRun& run, PanelMoves moves,
             const FollowLimits& limits)
        : network_(network),
          machine_(network),
          layout_(machine_.layout()),
          run_(run),
          panel_moves_(moves),
          limits_(limits),
          questions_(network, machine_, watch_),
          signature_(signature_variables(run.network)),
          stages_(stages_of(run, signature_)),
          instance_of_(network.processes.size(), none),
          open_(stages_.size()) {
        questions_.add_query({}, property);
        for (std::size_t i = 0; i < run.instances.size(); ++i) instance_of_[run.instances[i].process.index] = i;
    }

    ConcreteRun search() {
        if (!layout_.fits()) return {};
        add(timed::packed_initial(network_, layout_).data(), 0, 0, Delay{0});
        for (std::size_t polls = 0; !shown_ && states_.size() < limits_.states; ++polls) {
            if (polls % search_poll_interval == 0 && is_over(limits_.deadline, limits_.stop)) break;
            const std::optional<std::size_t> node = next();
            if (!node) break;
            expand(*node);
        }
        ConcreteRun result;
        if (shown_) result.run = states_.run_to(*shown_);
        else result.blamed = blamed();
        return result;
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    struct Open {
        std::size_t distance = 0, node = 0;
        auto operator<=>(const Open&) const = default;
    };

    /// Removes the next state to expand; returns nullopt if there is none. Every second returned state belongs to the
    /// last stage with open states, and all other returned states belong to the stages in turn. Without this
    /// alternation, the search could reach the state limit with states of the last stage. However,
    /// a run to a violation may reach the last stage from other states of an earlier stage.
    std::optional<std::size_t> next() {
        std::size_t stage = is_turn_of_last_ ? stages_.size() - 1 : turn_;
        is_turn_of_last_ = !is_turn_of_last_;
        for (std::size_t tried = 0; tried < stages_.size(); ++tried) {
            if (!open_[stage].empty()) {
                const std::size_t node = open_[stage].top().node;
                open_[stage].pop();
                if (is_turn_of_last_) turn_ = stage == 0 ? stages_.size() - 1 : stage - 1;
                return node;
            }
            stage = stage == 0 ? stages_.size() - 1 : stage - 1;
        }
        return {};
    }

    /// Returns the number of variables of the signature that differ from those of a stage.
    std::size_t distance(const Word* words, std::size_t stage) const {
        std::size_t differing = 0;
        for (std::size_t i = 0; i < signature_.size(); ++i)
            if (layout_.variables[signature_[i].index].get(words) != stages_[stage].signature[i]) ++differing;
        return differing;
    }

    /// Returns the last stage after `stage` whose signature is equal to that of the state; returns `stage` if there is
    /// no such stage. `stage` is the stage of the predecessor state.
    std::size_t stage_of(const Word* words, std::size_t stage) const {
        for (std::size_t later = stages_.size(); later-- > stage + 1;)
            if (distance(words, later) == 0) return later;
        return stage;
    }

    void add(const Word* at, std::size_t parent, std::size_t from_stage, const Move& move) {
        const std::size_t stage = stage_of(at, from_stage);
        const std::optional<std::size_t> node = states_.add(at, parent, stage, move);
        if (!node) return;
        const std::size_t later = std::min(stage + 1, stages_.size() - 1);
        open_[stage].push({distance(at, later), *node});
        last_stage_ = std::max(last_stage_, stage);
        if (!shown_ && watch_.needs(machine_, at, registers_)) {
            watch_.look(machine_, static_cast<std::uint32_t>(*node), at, registers_);
            shown_ = questions_.state_found(0);
        }
    }

    /// True if the process may move. An autonomous instance of the level Chosen moves only if some sampling of the
    /// stage does not permit its current outputs. Other autonomous instances move only if they move
    /// in the same stage of the abstract run, unless PanelMoves::Any permits all moves. All other
    /// processes move freely.
    bool may_move(const Word* at, std::size_t stage, Id<Network::Process> process) const {
        const std::size_t i = instance_of_[process.index];
        if (i == none || !run_.instances[i].autonomous) return true;
        if (run_.levels[i] != InputLevel::Chosen) return panel_moves_ == PanelMoves::Any || stages_[stage].moves[i];
        const AbstractableProcess& instance = run_.instances[i];
        std::vector<std::int64_t> values;
        for (const Id<Network::Variable> output : instance.read_outputs)
            values.push_back(layout_.variables[output.index].get(at));
        const auto row = std::ranges::find(instance.valuations, values) - instance.valuations.begin();
        return std::ranges::any_of(stages_[stage].goals[i], [&](Word goal) { return (goal >> row & 1U) == 0; });
    }

    void expand(std::size_t node) {
        const std::size_t stage = states_.mark(node);
        states_.load(node, now_);
        if (machine_.has_race(now_.data())) return;
        machine_.expand(now_.data(), moves_);
        const bool urgent = moves_.urgent;
        for (std::size_t i = 0; i < moves_.edges.size() && !shown_; ++i) {
            const Fire fire{machine_.process_of(moves_.edges[i]), machine_.edge_of(moves_.edges[i])};
            if (may_move(now_.data(), stage, fire.process))
                add(moves_.words.data() + i * layout_.words, node, stage, fire);
        }
        if (!urgent && !shown_ && machine_.delay(now_.data())) add(now_.data(), node, stage, Delay{1});
    }

    /// Returns the instances that the last reached stage constrains. If the last reached stage
    /// constrains no instance, returns the instances of the previous stage, or else the instances
    /// of the first stage with a constraint.
    std::vector<std::size_t> blamed() const {
        const auto constrained = [&](const Stage& stage) {
            std::vector<std::size_t> found;
            for (std::size_t i = 0; i < stage.goals.size(); ++i)
                if (!stage.goals[i].empty()) found.push_back(i);
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
    const PanelMoves panel_moves_;
    const FollowLimits& limits_;
    timed::PropertyMonitor watch_ = {};
    timed::PropertyQueries questions_;
    std::vector<Id<Network::Variable>> signature_;
    std::vector<Stage> stages_;
    std::vector<std::size_t> instance_of_;  // index of the instance of each process; `none` for other processes
    FoundStates states_ = FoundStates(layout_);
    // Per stage: the states that are not expanded yet.
    std::vector<std::priority_queue<Open, std::vector<Open>, std::greater<>>> open_;
    std::size_t turn_ = 0;  // the stage that the search uses next; the stages are used in turn
    bool is_turn_of_last_ = true;
    std::size_t last_stage_ = 0;
    std::optional<std::size_t> shown_ = {};
    std::vector<Word> now_ = {};  // the state whose moves are computed
    timed::Moves moves_ = {};
    timed::PropertyMonitor::Registers registers_ = {};
};

}  // namespace

ConcreteRun follow(const Network& network, const Property& property, const AbstractRun& abstract, PanelMoves moves,
                   const FollowLimits& limits) {
    return Follower(network, property, abstract, moves, limits).search();
}

}  // namespace grafverif
