// SPDX-License-Identifier: MIT
// Breadth-first search by the number of moves, a delay of any length counting one: a state met by a delay carries on
// the same delay at no cost. So when time passes in a state, it passes on at once, unit by unit, until it is stopped or
// reaches a state whose own delay is known; all states on the way are one level below. A state of that level that was
// first met by an edge is then as near by the delay: its parent becomes the state before it in time, so that what
// follows it in time has its shortest run through it.
//
// Looking up a state costs a cache miss or two; so the moves of a few states ahead are computed before the moves of the
// state at hand are looked up, and their places in the index fetched meanwhile. The order of discovery is the same.
#include "check/timed/explore.hpp"

#include <algorithm>
#include <array>
#include <new>

#include "check/timed/profile.hpp"

namespace grafverif::timed {

double Limits::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

bool Limits::stopped() const {
    if (options_.stop && options_.stop->load(std::memory_order_relaxed)) return true;
    return options_.deadline && std::chrono::steady_clock::now() >= *options_.deadline;
}

Obstacle Limits::judge(const Graph& graph, std::uint32_t state, std::size_t more) {
    if (stopped()) return Obstacle::Stopped;
    // Judging properties comes on top; where there are links, the index has gone by then.
    const std::size_t freed = graph.linked ? graph.store.index_bytes() : 0;
    const std::size_t bytes = graph.bytes() + more + std::max(16 * graph.states(), freed) - freed;
    if (allowed_used_ = bytes > options_.max_memory; allowed_used_) return Obstacle::Memory;
    if (!options_.progress) return Obstacle::None;
    const double now = seconds();
    if (now - shown_ < 0.2) return Obstacle::None;
    shown_ = now;
    options_.progress({graph.states(), graph.transitions, graph.states() - state, bytes, now});
    return Obstacle::None;
}

void Limits::explain(Graph& graph) {
    if (explained_ || !options_.many || graph.states() < many_states) return;
    explained_ = true;
    options_.many(profile_of(graph));
}

namespace {

constexpr std::uint32_t ahead = 16;             // states whose moves are computed before they are looked up
constexpr std::uint32_t judge_every = 1024;     // states between two looks at the limits
constexpr std::size_t judge_after = 1U << 21U;  // words of states computed between them, at most
constexpr std::size_t ahead_words = 1U << 22U;  // in the moves computed ahead, beyond which one state ahead must do
constexpr std::size_t kept_words = 1U << 20U;   // of the moves of one state, for those of another
constexpr std::size_t link_bytes = 24;          // per state; above it links are dropped
constexpr std::size_t link_grace = 1U << 18U;   // but not before they take so many in all

class Search {
public:
    Search(Graph& graph, Watch& watch, const std::vector<Field>& races) : graph_(graph), watch_(watch), races_(races) {}

    Obstacle run(Limits& limits) {
        const std::vector<Word> initial = packed_initial(graph_.machine.network(), graph_.machine.layout());
        discover(initial.data(), graph_.store.fold(initial.data(), {}, next_), 0);
        for (std::uint32_t state = 0; state < graph_.states(); ++state) {
            if (limits.too_many(graph_.states())) return Obstacle::Bound;
            if (state % judge_every == 0 || computed_words_ > judge_after) {
                computed_words_ = 0;
                if (const Obstacle obstacle = limits.judge(graph_, state, held()); obstacle != Obstacle::None)
                    return obstacle;
                limits.explain(graph_);
            }
            if (state == level_end_ || state == 0) {
                graph_.levels.push_back(state);
                level_end_ = static_cast<std::uint32_t>(graph_.states());
            }
            look_ahead(state);
            visit(state);
            graph_.looked_at = state + 1;
            if (Moves& done = ring_[state % ahead].moves; done.words.size() > kept_words) done.words = {};
            drop_links_if_many();
        }
        return Obstacle::None;
    }

private:
    bool races(const Word* words) const {
        return std::ranges::any_of(races_, [&](const Field& race) { return race.raw(words) != 0; });
    }

    /// Bytes of the moves ahead.
    std::size_t held() const {
        std::size_t words = 0;
        for (const auto& [moves, roots] : ring_) words += moves.words.capacity() + roots.capacity();
        return words * sizeof(Word);
    }

    /// The number of the state; a new one is watched and gets its parent: all of it, or nothing where memory ends.
    std::uint32_t discover(const Word* words, Word root, std::uint32_t parent) {
        graph_.parent.make_room(1);
        graph_.kinds.make_room(1);
        const Pairs::Interned interned = graph_.store.intern(root);
        if (!interned.fresh) return interned.number;
        graph_.parent.push_back(parent);
        graph_.kinds.push_back(0);
        watch_.look(graph_.machine, interned.number, words);
        return interned.number;
    }

    void look_ahead(std::uint32_t state) {
        const auto end = static_cast<std::uint32_t>(std::min<std::size_t>(graph_.states(), state + depth_));
        for (; computed_ < end; ++computed_) {
            auto& [moves, roots] = ring_[computed_ % ahead];
            graph_.store.load(computed_, now_);
            const std::size_t words = graph_.machine.layout().words;
            moves.edges.clear();
            roots.clear();
            if (races(now_.words.data())) continue;
            graph_.machine.expand(now_.words.data(), moves);
            const std::size_t computed = moves.edges.size() * words;
            computed_words_ += computed;
            if (depth_ > 1 && computed > ahead_words / ahead) depth_ = 1;
            for (std::size_t i = 0; i < moves.edges.size(); ++i) {
                roots.push_back(graph_.store.fold(moves.words.data() + i * words, now_, next_));
                graph_.store.prefetch(roots.back());
            }
        }
    }

    void visit(std::uint32_t state) {
        const auto& [moves, roots] = ring_[state % ahead];
        const std::size_t words = graph_.machine.layout().words;
        if (graph_.linked) graph_.links.begin(state);
        if (!races_.empty() && races(graph_.load(state))) {
            if (!graph_.race) graph_.race = state;
            graph_.set_kind(state, StateKind::Open, state);
            return;
        }
        std::uint32_t onward = 0;  // where an urgent edge leads; a late state, since those lead on
        for (std::size_t i = 0; i < roots.size(); ++i) {
            const std::uint32_t next = discover(moves.words.data() + i * words, roots[i], state);
            if (graph_.linked) graph_.links.add(next);
            if (moves.urgent && graph_.machine.urgent(moves.edges[i])) onward = std::max(onward, next);
        }
        graph_.transitions += roots.size();
        note(state, moves);
        const bool acts = !roots.empty();
        if (moves.urgent) graph_.set_kind(state, StateKind::Urgent, onward);
        else if (graph_.kind(state) == StateKind::Unknown) pass_time(state);
        if (acts && graph_.kind(state) == StateKind::Passes)
            graph_.set_kind(state, StateKind::PassesOrActs, graph_.target(state));
        if (acts && graph_.kind(state) == StateKind::Stuck) graph_.set_kind(state, StateKind::Acts, state);
        if (moves.fault) graph_.set_kind(state, StateKind::Open, state);
    }

    /// See the essay.
    void pass_time(std::uint32_t state) {
        Machine& machine = graph_.machine;
        graph_.store.load(state, now_);
        for (std::uint32_t now = state; graph_.kind(now) == StateKind::Unknown;) {
            next_.words = now_.words;
            if (!machine.delay(next_.words.data())) {
                graph_.set_kind(now, StateKind::Stuck, now);
                return;
            }
            const Word root = graph_.store.fold(next_.words.data(), now_, next_);
            const std::uint32_t next = discover(next_.words.data(), root, now);
            std::swap(now_, next_);
            graph_.set_kind(now, StateKind::Passes, next);
            ++graph_.transitions;
            graph_.time_passes = true;
            if (graph_.kind(next) == StateKind::Unknown && next >= level_end_) graph_.parent[next] = now;
            now = next;
        }
    }

    void drop_links_if_many() {
        const std::size_t bytes = graph_.links.list_bytes();
        if (!graph_.linked || bytes < link_grace) return;
        if (bytes < link_bytes * graph_.states() && bytes < 0xFFFF0000U) return;
        graph_.linked = false;
        graph_.links.clear();
    }

    void note(std::uint32_t state, const Moves& moves) {
        if (moves.stuck_bound && !graph_.stuck_bound) graph_.stuck_bound = UncoveredAt{state, *moves.stuck_bound};
        if (moves.locked_bound && !graph_.locked_bound) graph_.locked_bound = UncoveredAt{state, *moves.locked_bound};
        if (!moves.fault) return;
        const Fault& fault = *moves.fault;
        const bool known = std::ranges::any_of(graph_.faults, [&](const FaultAt& other) {
            return other.fault.edge == fault.edge && other.fault.kind == fault.kind &&
                   other.fault.variable == fault.variable;
        });
        if (!known) graph_.faults.push_back({state, fault});
    }

    Graph& graph_;
    Watch& watch_;
    const std::vector<Field>& races_;
    struct Ahead {
        Moves moves = {};
        std::vector<Word> roots = {};
    };
    std::array<Ahead, ahead> ring_ = {};
    std::uint32_t depth_ = ahead;     // of the look ahead
    std::size_t computed_words_ = 0;  // since the last look at the limits
    std::uint32_t computed_ = 0;      // the states below have their moves in the ring, or are done
    std::uint32_t level_end_ = 0;
    Unfolded now_ = {}, next_ = {};
};

}  // namespace

Obstacle explore(Graph& graph, Watch& watch, const std::vector<Field>& races, Limits& limits) {
    try {
        return Search(graph, watch, races).run(limits);
    } catch (const std::bad_alloc&) {
        return Obstacle::Memory;  // the states found are whole, those looked at have their links
    }
}

std::size_t Watch::add(std::uint32_t predicate) {
    predicates_.push_back({predicate, results_.size()});
    results_.emplace_back();
    return results_.size() - 1;
}

std::size_t Watch::add_bit(const Field& bit, std::uint32_t settled) {
    const auto same = [&](const Bits& bits) { return bits.word == bit.word && bits.settled == settled; };
    auto bits = std::ranges::find_if(bits_, same);
    if (bits == bits_.end()) bits = bits_.insert(bits, Bits{.word = bit.word, .settled = settled});
    bits->missing |= bit.mask();
    bits->each.push_back({bit.mask(), results_.size()});
    results_.emplace_back();
    return results_.size() - 1;
}

void Watch::look_closely(Machine& machine, std::uint32_t state, const Word* words) {
    for (std::size_t i = 0; i < predicates_.size();) {
        const End end = machine.holds(predicates_[i].code, words);
        if (end == End::No) {
            ++i;
            continue;
        }
        Result& result = results_[predicates_[i].watch];
        if (end == End::Yes) result.state = state;
        else result.broken = true;
        predicates_[i] = predicates_.back();
        predicates_.pop_back();
    }
    for (Bits& bits : bits_) {
        const Word met = words[bits.word] & bits.missing;
        if (met == 0) continue;
        if (bits.settled != Program::yes && machine.holds(bits.settled, words) != End::Yes) continue;
        for (const Bit& bit : bits.each)
            if ((met & bit.mask) != 0) results_[bit.watch].state = state;
        bits.missing &= ~met;
    }
    std::erase_if(bits_, [](const Bits& bits) { return bits.missing == 0; });
}

}  // namespace grafverif::timed
