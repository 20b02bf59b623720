// SPDX-License-Identifier: MIT
#include "check/inputs/possible.hpp"

#include <algorithm>
#include <bit>
#include <deque>
#include <functional>
#include <numeric>
#include <queue>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "check/inputs/novelty.hpp"
#include "check/inputs/required_states.hpp"
#include "check/timed/machine.hpp"
#include "check/timed/store/packed_states.hpp"
#include "ir/network_clocks.hpp"
#include "ir/slots.hpp"

namespace grafverif {

/// The information about the clocks of the loop that the proof needs.
struct LoopTiming {
    std::vector<std::vector<EdgeTiming>> edges = {};    // timing of each edge of each process
    std::vector<std::vector<std::size_t>> bounds = {};  // number of bounds of the invariant, per process and location
};

using timed::Word;

/// The network of the loop without clocks. `goal` is the term p of `always possible p`.
struct LoopWithoutClocks {
    Network network = {};
    Id<Expr> goal = {};
};

namespace {

LoopWithoutClocks clockless(const Network& loop, const Property& property) {
    LoopWithoutClocks made{loop, property.operands[0]};
    if (property.at_stable) made.goal = made.network.exprs.conjunction(loop.settled, made.goal);
    for (Network::Template& automaton : made.network.templates) ignore_clocks(automaton);
    return made;
}

LoopTiming timing_of_loop(const Network& loop) {
    LoopTiming made;
    const std::vector<ProcessClocks> clocks = analyse_clocks(loop);
    for (const Id<Network::Process> id : loop.processes.ids()) {
        const Network::Template& automaton = loop.templates[loop.processes[id].automaton];
        made.edges.emplace_back();
        for (const Network::Edge& edge : automaton.edges)
            made.edges.back().push_back(timing_of(loop, clocks[id.index], automaton, edge));
        made.bounds.emplace_back();
        for (const Network::Location& location : automaton.locations)
            made.bounds.back().push_back(location.invariant.size());
    }
    return made;
}

}  // namespace

/// Finds good states, from which p is reachable (definition: possible.hpp). The search begins with the states that must
/// be good and explores only states that are necessary for their proof. Rule 4 of possible.hpp is applied last, in the
/// order of NoveltySearch: the search prefers states with a rare signature, and states that are reached by few moves of
/// the panel after the last change of the signature.
class GoodStates {
public:
    GoodStates(const LoopWithoutClocks& loop, const LoopTiming& timing, const std::vector<bool>& is_panel,
               const InputAblations& ablations)
        : loop_(loop.network),
          timing_(timing),
          is_panel_(is_panel),
          ablations_(ablations),
          machine_(loop.network),
          goal_(machine_.compiler().condition(loop.goal, timed::Program::yes, timed::Program::no)),
          signature_(signature_fields(loop.network, machine_.layout(), is_panel)),
          states_(machine_.layout().stored) {}

    const timed::Layout& layout() const { return machine_.layout(); }
    bool fits() const { return machine_.layout().fits(); }

    /// Requires that the state is good, unless an urgent edge is enabled in the state.
    void require(const Word* words) {
        machine_.expand(words, moves_);
        if (moves_.urgent) return;
        const std::uint32_t state = add(words, {}, false);
        if (nodes_[state].is_required) return;
        nodes_[state].is_required = true;
        if (!nodes_[state].is_good) ++open_;
    }

    /// Returns true if all required states are good, false if the rules do not prove that all of them are good, and
    /// nullopt if a limit is reached.
    std::optional<bool> run(const FollowLimits& limits) {
        for (std::size_t polls = 0; open_ > 0; ++polls) {
            if (states_.size() >= limits.states || bytes() > limits.bytes) return {};
            if (polls % search_poll_interval == 0 && is_over(limits.deadline, limits.stop)) return {};
            if (!forced_.empty()) {
                const std::uint32_t state = forced_.front();
                forced_.pop_front();
                if (!nodes_[state].is_good) expand(state);
            } else if (!resting_.empty()) {
                const std::uint32_t state = resting_.top().second;
                resting_.pop();
                if (!nodes_[state].is_good) move_at_rest(state);
            } else {
                return false;
            }
        }
        return true;
    }

    std::size_t size() const { return states_.size(); }

private:
    struct Node {
        std::uint64_t open = 1;  // bit set of the bounds for which no edge to a good state is known; rules 2 and 4 use
                                 // only bit 0
        std::uint64_t signature = 0;
        std::uint32_t users = none;  // index in users_ of the first entry of the list of this node
        std::uint32_t moves = 0;     // number of moves of the panel since the signature changed
        bool is_good = false, is_required = false;
    };
    struct User {  // entry of a linked list of a node: `state` has an edge for `bound` to the node
        std::uint32_t state = 0, next = none;
        std::uint8_t bound = 0;
    };
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    std::uint64_t bytes() const {
        return states_.bytes() + nodes_.capacity() * sizeof(Node) + users_.capacity() * sizeof(User) +
               forced_.size() * sizeof(std::uint32_t) + resting_.size() * sizeof(resting_.top());
    }

    std::uint32_t add(const Word* words, std::optional<std::uint32_t> parent, bool by_panel) {
        const auto [state, is_new] = states_.add(words);
        if (!is_new) return state;
        Node node{.signature = signature_of(signature_, words)};
        if (parent && nodes_[*parent].signature == node.signature)
            node.moves = nodes_[*parent].moves + (by_panel ? 1 : 0);
        nodes_.push_back(node);
        if (machine_.holds(goal_, words, registers_) == timed::End::Yes) nodes_.back().is_good = true;
        else forced_.push_back(state);
        return state;
    }

    /// Records that move number `move` of the state `from` is an edge for the invariant bound number `bound`.
    void link(std::uint32_t from, std::uint8_t bound, std::size_t move) {
        const bool by_panel = is_panel_[machine_.process_of(moves_.edges[move]).index];
        const std::uint32_t to = add(moves_.words.data() + move * machine_.layout().words, from, by_panel);
        if (nodes_[to].is_good) return satisfy(from, bound);
        users_.push_back({from, nodes_[to].users, bound});
        nodes_[to].users = static_cast<std::uint32_t>(users_.size() - 1);
    }

    void satisfy(std::uint32_t state, std::uint8_t bound) {
        std::vector<std::pair<std::uint32_t, std::uint8_t>> met{{state, bound}};
        while (!met.empty()) {
            Node& node = nodes_[met.back().first];
            node.open &= ~(std::uint64_t{1} << met.back().second);
            met.pop_back();
            if (node.open != 0 || node.is_good) continue;
            node.is_good = true;
            if (node.is_required) --open_;
            for (std::uint32_t user = node.users; user != none; user = users_[user].next)
                met.emplace_back(users_[user].state, users_[user].bound);
        }
    }

    void load(std::uint32_t state) {
        now_.assign(machine_.layout().words, 0);
        std::copy_n(states_.words(state), machine_.layout().stored, now_.begin());
        machine_.expand(now_.data(), moves_);
    }

    std::size_t bounds_of(std::size_t process) const {
        const auto location = machine_.layout().locations[process].get(now_.data());
        return timing_.bounds[process][static_cast<std::size_t>(location)];
    }

    const EdgeTiming& timing(std::size_t move) const {
        return timing_.edges[machine_.process_of(moves_.edges[move]).index][machine_.edge_of(moves_.edges[move]).index];
    }

    /// Applies rules 2 and 3 of possible.hpp (urgent edges, bounds of invariants) to a state.
    void expand(std::uint32_t state) {
        load(state);
        if (moves_.urgent) {
            for (std::size_t move = 0; move < moves_.edges.size(); ++move)
                if (machine_.urgent(moves_.edges[move])) return link(state, 0, move);
            return;
        }
        std::vector<std::size_t> first(loop_.processes.size() + 1, 0);  // number of the first invariant bound of each
                                                                        // process
        for (std::size_t process = 0; process < loop_.processes.size(); ++process)
            first[process + 1] = first[process] + bounds_of(process);
        const std::size_t bounds = first.back();
        if (bounds > 64) return;
        if (bounds == 0) return rest(state);
        nodes_[state].open = ablations_.one_bound ? 1 : ~std::uint64_t{0} >> (64 - bounds);
        for (std::size_t move = 0; move < moves_.edges.size(); ++move) {
            const std::size_t process = machine_.process_of(moves_.edges[move]).index;
            for (std::size_t bound = first[process]; bound < first[process + 1]; ++bound)
                if (ablations_.any_edge || (timing(move).covers >> (bound - first[process]) & 1) != 0)
                    link(state, static_cast<std::uint8_t>(bound), move);
        }
    }

    void rest(std::uint32_t state) {
        const std::size_t earlier = visits_[nodes_[state].signature]++;
        resting_.emplace(std::size_t(std::bit_width(earlier)) + 2 * nodes_[state].moves, state);
    }

    /// Applies rule 4 of possible.hpp (no bound) to a state.
    void move_at_rest(std::uint32_t state) {
        load(state);
        for (std::size_t move = 0; move < moves_.edges.size() && !nodes_[state].is_good; ++move)
            if (ablations_.any_edge || timing(move).at_last) link(state, 0, move);
    }

    using Resting = std::pair<std::size_t, std::uint32_t>;  // cost and number of a state

    const Network& loop_;
    const LoopTiming& timing_;
    const std::vector<bool>& is_panel_;  // per process: true if it belongs to the panel
    const InputAblations& ablations_;
    timed::Machine machine_;
    const std::uint32_t goal_;
    const std::vector<timed::Field> signature_;
    PackedStates states_;
    std::vector<Node> nodes_ = {};
    std::vector<User> users_ = {};
    std::size_t open_ = 0;                   // number of required states that are not yet known to be good
    std::deque<std::uint32_t> forced_ = {};  // states to which rules 2 and 3 are not yet applied
    std::priority_queue<Resting, std::vector<Resting>, std::greater<>> resting_ = {};
    std::unordered_map<std::uint64_t, std::size_t> visits_ = {};
    timed::Moves moves_ = {};
    std::vector<Word> now_ = {};
    std::vector<std::int64_t> registers_ = {};
};

/// One proof per property, whose required states are computed with or without a homing sequence.
class Attempt {
public:
    Attempt(const Network& loop, const std::vector<AbstractableProcess>& instances,
            const std::vector<InputLevel>& panel_levels, const LoopTiming& timing, bool with_sequence,
            const InputAblations& ablations)
        : loop_(loop),
          timing_(timing),
          ablations_(ablations),
          required_(loop, instances, panel_levels, with_sequence, ablations),
          is_panel_(loop.processes.size(), false) {
        for (std::size_t i = 0; i < instances.size(); ++i)
            is_panel_[instances[i].process.index] = panel_levels[i] == InputLevel::Chosen;
    }

    std::optional<bool> proves(const Property& property, const FollowLimits& limits) {
        if (failed_.contains(property.name)) return false;
        if (const std::optional<bool> found = required_.find(limits); !found || !*found) return found;
        if (!proof_ || proof_->property != property.name) {
            proof_.reset();  // an unfinished proof of another property, whose memory this proof may need
            proof_ = std::make_unique<Proof>(*this, property);
        }
        GoodStates& good = proof_->good;
        const std::size_t before = good.size();
        std::optional<bool> proved = good.fits();
        if (*proved && !proof_->is_complete) {
            proof_->is_complete =
                required_.each(good.layout(), limits, [&](const Word* words) { good.require(words); });
            if (!proof_->is_complete) proved.reset();
        }
        // Time diverges, so a run reaches some required state. Without a required state, a premise would be violated.
        if (proved && good.size() == 0) proved = false;
        if (proved && *proved) proved = good.run(limits);
        states_ += good.size() - before;
        if (proved) proof_.reset();
        if (proved && !*proved) failed_.insert(property.name);
        return proved;
    }

    std::size_t states() const { return states_ + required_.size(); }
    const std::vector<std::string>& sequence() const { return required_.sequence(); }

private:
    /// The search for the good states of one property.
    struct Proof {
        Proof(const Attempt& of, const Property& about)
            : property(about.name),
              loop(clockless(of.loop_, about)),
              good(loop, of.timing_, of.is_panel_, of.ablations_) {}

        const std::string property;
        const LoopWithoutClocks loop;
        GoodStates good;
        bool is_complete = false;  // true if `good` contains all required states
    };

    const Network& loop_;
    const LoopTiming& timing_;
    const InputAblations& ablations_;
    RequiredStates required_;
    std::vector<bool> is_panel_;         // per process: true if it belongs to the panel
    std::unique_ptr<Proof> proof_ = {};  // an unfinished search, which ended at a limit
    std::set<std::string> failed_ = {};  // properties that the rules do not prove
    std::size_t states_ = 0;
};

class PossibleProof::States {
public:
    States(const Network& loop, const std::vector<AbstractableProcess>& instances, const InputAblations& ablations)
        : ablations_(ablations),
          timing_(timing_of_loop(loop)),
          levels_(panel_levels(loop, instances, {}, ablations.need_not_return)) {
        const bool can_use_sequence = loop.controllers.size() == 1 && !ablations.without_homing;
        for (const bool with_sequence : {true, false})
            if (can_use_sequence || !with_sequence)
                attempts_.emplace_back(loop, instances, levels_, timing_, with_sequence, ablations_);
    }

    std::optional<bool> proves(const Property& property, FollowLimits limits) {
        limits.bytes /= attempts_.size();
        std::optional<bool> result = false;
        for (Attempt& attempt : attempts_) {
            const std::optional<bool> proved = attempt.proves(property, limits);
            if (proved == true) {
                sequence_ = attempt.sequence();
                return true;
            }
            if (!proved) result.reset();
        }
        return result;
    }

    const std::vector<InputLevel>& levels() const { return levels_; }
    const std::vector<std::string>& sequence() const { return sequence_; }
    std::size_t states() const {
        return std::accumulate(attempts_.begin(), attempts_.end(), std::size_t{0},
                               [](std::size_t sum, const Attempt& attempt) { return sum + attempt.states(); });
    }

private:
    const InputAblations ablations_;
    const LoopTiming timing_;
    const std::vector<InputLevel> levels_;
    std::deque<Attempt> attempts_ = {};
    std::vector<std::string> sequence_ = {};
};

PossibleProof::PossibleProof(const Network& loop, const std::vector<AbstractableProcess>& instances,
                             const InputAblations& ablations)
    : states_(std::make_unique<States>(loop, instances, ablations)) {}

PossibleProof::~PossibleProof() = default;

const std::vector<InputLevel>& PossibleProof::levels() const { return states_->levels(); }

std::optional<bool> PossibleProof::proves(const Property& property, const FollowLimits& limits) {
    return states_->proves(property, limits);
}

const std::vector<std::string>& PossibleProof::sequence() const { return states_->sequence(); }

std::size_t PossibleProof::states() const { return states_->states(); }

}  // namespace grafverif
