// SPDX-License-Identifier: MIT
#include "check/inputs/novelty.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>

#include "check/inputs/found_states.hpp"
#include "check/timed/machine.hpp"
#include "check/timed/property_queries.hpp"
#include "ir/slots.hpp"

namespace grafverif {

std::vector<timed::Field> signature_fields(const Network& network, const timed::Layout& layout,
                                           const std::vector<bool>& omitted) {
    std::vector<timed::Field> fields;
    for (const Id<Network::Variable> id : signature_variables(network)) fields.push_back(layout.variables[id.index]);
    for (const Id<Network::Process> id : network.processes.ids()) {
        if (omitted[id.index] || network.processes[id].kind != Network::ProcessKind::Plant) continue;
        fields.push_back(layout.locations[id.index]);
        for (const Id<Network::Variable> variable : Slots(network, id).written())
            if (!network.variables[variable].scratch) fields.push_back(layout.variables[variable.index]);
    }
    return fields;
}

std::uint64_t signature_of(const std::vector<timed::Field>& fields, const timed::Word* words) {
    std::uint64_t hash = 0;
    for (const timed::Field& field : fields)
        hash = (hash ^ static_cast<std::uint64_t>(field.get(words))) * 0x9E3779B97F4A7C15U + (hash >> 29U);
    return hash;
}

class NoveltySearch::States {
public:
    States(const Network& network, std::vector<Property> properties, const std::vector<AbstractableProcess>& instances)
        : machine_(network), properties_(std::move(properties)), queries_(network, machine_, monitor_) {
        for (const Property& property : properties_) queries_.add_query({}, property);
        is_autonomous_.resize(network.processes.size());
        for (const AbstractableProcess& instance : instances)
            is_autonomous_[instance.process.index] = instance.autonomous;
        signature_ = signature_fields(network, machine_.layout(), is_autonomous_);
        if (machine_.layout().fits()) add(timed::packed_initial(network, machine_.layout()).data(), 0, {}, Delay{0});
    }

    bool run(const FollowLimits& limits) {
        for (std::size_t polls = 0; states_.size() < limits.states; ++polls) {
            if (open_.empty() || monitor_.is_over() || bytes() > limits.bytes) return false;
            if (polls % search_poll_interval == 0 && is_over(limits.deadline, limits.stop)) return true;
            const std::size_t state = open_.top().state;
            open_.pop();
            expand(state);
        }
        return true;
    }

    std::size_t size() const { return states_.size(); }

    std::optional<Run> run_of(std::size_t property) const {
        const std::optional<std::size_t> state = queries_.state_found(property);
        return state ? std::optional(states_.run_to(*state)) : std::nullopt;
    }

private:
    struct Open {
        std::size_t cost = 0, state = 0;
        auto operator<=>(const Open&) const = default;
    };
    /// The data of a state that determine its cost. The search expands states with low costs first.
    struct Situation {
        std::uint64_t signature = 0;
        std::size_t moves = 0;  // number of moves of autonomous instances since the signature changed
    };

    void add(const timed::Word* words, std::size_t parent, std::optional<Id<Network::Process>> moved,
             const Move& move) {
        const std::optional<std::size_t> state = states_.add(words, parent, 0, move);
        if (!state) return;
        Situation now{signature_of(signature_, words), 0};
        if (*state > 0 && now.signature == situations_[parent].signature)
            now.moves = situations_[parent].moves + (moved && is_autonomous_[moved->index] ? 1 : 0);
        situations_.push_back(now);
        const std::size_t earlier = visits_[now.signature]++;
        open_.push({std::size_t(std::bit_width(earlier)) + 2 * now.moves, *state});
        if (!monitor_.needs(machine_, words, registers_)) return;
        monitor_.look(machine_, static_cast<std::uint32_t>(*state), words, registers_);
    }

    std::uint64_t bytes() const {
        return states_.bytes() + situations_.capacity() * sizeof(Situation) + open_.size() * sizeof(Open);
    }

    void expand(std::size_t state) {
        states_.load(state, now_);
        machine_.expand(now_.data(), moves_);
        for (std::size_t i = 0; i < moves_.edges.size(); ++i) {
            const Fire fire{machine_.process_of(moves_.edges[i]), machine_.edge_of(moves_.edges[i])};
            add(moves_.words.data() + i * machine_.layout().words, state, fire.process, fire);
        }
        if (!moves_.urgent && machine_.delay(now_.data())) add(now_.data(), state, {}, Delay{1});
    }

    timed::Machine machine_;
    const std::vector<Property> properties_;
    timed::PropertyMonitor monitor_ = {};
    timed::PropertyQueries queries_;
    std::vector<timed::Field> signature_ = {};
    std::vector<bool> is_autonomous_ = {};  // true for the processes of autonomous instances
    FoundStates states_ = FoundStates(machine_.layout());
    std::vector<Situation> situations_ = {};  // data of each state
    std::unordered_map<std::uint64_t, std::size_t> visits_ = {};
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open_ = {};
    std::vector<timed::Word> now_ = {};  // the state whose moves are computed
    timed::Moves moves_ = {};
    timed::PropertyMonitor::Registers registers_ = {};
};

NoveltySearch::NoveltySearch(const Network& network, std::vector<Property> properties,
                             const std::vector<AbstractableProcess>& instances)
    : states_(std::make_unique<States>(network, std::move(properties), instances)) {}

NoveltySearch::~NoveltySearch() = default;

bool NoveltySearch::run(const FollowLimits& limits) { return states_->run(limits); }

std::size_t NoveltySearch::states() const { return states_->size(); }

std::optional<Run> NoveltySearch::run_of(std::size_t property) const { return states_->run_of(property); }

}  // namespace grafverif
