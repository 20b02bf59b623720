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
#include "ir/patterns.hpp"
#include "ir/slots.hpp"

namespace grafverif {

using timed::End;

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
        for (std::size_t k = 0; k < properties_.size(); ++k) {
            if (is_liveness(properties_[k].pattern)) {
                add_response(k);
                continue;
            }
            queries_.add_query({}, properties_[k]);
            of_queries_.push_back(k);
        }
        is_autonomous_.resize(network.processes.size());
        for (const AbstractableProcess& instance : instances)
            is_autonomous_[instance.process.index] = instance.autonomous;
        signature_ = signature_fields(network, machine_.layout(), is_autonomous_);
        for (const Network::Process& process : network.processes) {
            std::vector<bool>& bounded = is_bounded_.emplace_back();
            for (const Network::Location& location : network.templates[process.automaton].locations)
                bounded.push_back(!location.invariant.empty());
        }
        if (machine_.layout().fits()) add(timed::packed_initial(network, machine_.layout()).data(), 0, false, Delay{0});
    }

    bool run(const FollowLimits& limits) {
        for (std::size_t polls = 0; states_.size() < limits.states; ++polls) {
            if (open_.empty() || is_decided() || bytes() > limits.bytes) return false;
            if (polls % search_poll_interval == 0 && is_over(limits.deadline, limits.stop)) return true;
            const std::size_t state = open_.top().state;
            open_.pop();
            expand(state);
        }
        return true;
    }

    std::size_t size() const { return states_.size(); }

    std::optional<Run> run_of(std::size_t property) const {
        const auto response = std::ranges::find(responses_, property, &Response::property);
        const auto query = std::ranges::find(of_queries_, property);
        std::optional<std::size_t> state;
        if (response != responses_.end()) state = response->rests_in;
        if (query != of_queries_.end())
            state = queries_.state_found(static_cast<std::size_t>(query - of_queries_.begin()));
        if (!state) return {};
        Run run = states_.run_to(*state);
        if (response == responses_.end()) return run;
        run.loop = run.moves.size();
        run.moves.emplace_back(Delay{1});
        return run;
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

    /// A property `p leads to q`, or `inevitable q`: p is then true only in the initial state. In a state whose mark
    /// contains bit `k` of response k, q is awaited: p has been true, and q has not been true since.
    struct Response {
        std::size_t property = 0;  // index of the property
        std::uint32_t p = timed::Program::no, q = timed::Program::no;
        std::optional<std::size_t> rests_in = {};  // a state in which q is awaited and time can pass forever
    };
    static constexpr std::size_t most_responses = 32;  // number of responses for which the search finds runs

    void add_response(std::size_t k) {
        if (responses_.size() == most_responses) return;
        const Property& property = properties_[k];
        const auto compiled = [&](Id<Expr> term) {
            return machine_.compiler().condition(term, timed::Program::yes, timed::Program::no);
        };
        Response made{.property = k, .q = compiled(property.operands.back())};
        if (property.pattern == Pattern::LeadsTo) made.p = compiled(property.operands.front());
        responses_.push_back(made);
    }

    bool is_decided() const {
        return (of_queries_.empty() || monitor_.is_over()) &&
               std::ranges::all_of(responses_, [](const Response& each) { return each.rests_in.has_value(); });
    }

    /// Returns the mark of a state: the set of responses whose q is awaited. `before` is the mark of its predecessor.
    std::size_t awaited(const timed::Word* words, std::optional<std::size_t> before) {
        std::size_t mark = 0;
        for (std::size_t k = 0; k < responses_.size(); ++k) {
            const Response& response = responses_[k];
            if (response.rests_in) continue;
            const bool is_inevitable = properties_[response.property].pattern == Pattern::Inevitable;
            const bool begins = is_inevitable ? !before : machine_.holds(response.p, words, registers_) == End::Yes;
            if (!begins && (!before || (*before >> k & 1U) == 0)) continue;
            if (machine_.holds(response.q, words, registers_) == End::No) mark |= std::size_t{1} << k;
        }
        return mark;
    }

    /// True if no urgent edge is enabled in the state `now_`, whose moves are `moves_`, and no process is in a location
    /// with an invariant. Then time can pass forever: urgent edges have no clock constraints.
    bool may_rest() const {
        if (moves_.urgent || moves_.fault) return false;
        for (std::size_t process = 0; process < is_bounded_.size(); ++process) {
            const auto location = machine_.layout().locations[process].get(now_.data());
            if (is_bounded_[process][static_cast<std::size_t>(location)]) return false;
        }
        return true;
    }

    /// Adds a state. `by_panel` is true if an autonomous instance has moved.
    void add(const timed::Word* words, std::size_t parent, bool by_panel, const Move& move) {
        const bool is_initial = states_.size() == 0;
        const std::size_t mark = awaited(words, is_initial ? std::nullopt : std::optional(states_.mark(parent)));
        const std::optional<std::size_t> state = states_.add(words, parent, mark, move);
        if (!state) return;
        Situation now{signature_of(signature_, words), 0};
        if (*state > 0 && now.signature == situations_[parent].signature)
            now.moves = situations_[parent].moves + (by_panel ? 1 : 0);
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
        if (machine_.has_race(now_.data())) return;
        machine_.expand(now_.data(), moves_);
        for (std::size_t i = 0; i < moves_.edges.size(); ++i) {
            const Fire fire{machine_.process_of(moves_.edges[i]), machine_.edge_of(moves_.edges[i])};
            add(moves_.words.data() + i * machine_.layout().words, state, is_autonomous_[fire.process.index], fire);
        }
        if (const std::size_t mark = states_.mark(state); mark != 0 && may_rest())
            for (std::size_t k = 0; k < responses_.size(); ++k)
                if ((mark >> k & 1U) != 0 && !responses_[k].rests_in) responses_[k].rests_in = state;
        if (!moves_.urgent && machine_.delay(now_.data())) add(now_.data(), state, false, Delay{1});
    }

    timed::Machine machine_;
    const std::vector<Property> properties_;
    timed::PropertyMonitor monitor_ = {};
    timed::PropertyQueries queries_;
    std::vector<std::size_t> of_queries_ = {};  // indices of the properties of `queries_`
    std::vector<Response> responses_ = {};
    std::vector<std::vector<bool>> is_bounded_ = {};  // per process and location: true if the location has an invariant
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
