// SPDX-License-Identifier: MIT
// Breadth-first search by the number of moves. A delay of any length counts as one move, so two consecutive delays are
// also one move. Therefore, if time can pass in a state, the search advances time immediately, unit by unit. The delay
// ends in a state in which time cannot pass, or whose further delay is already known. If the delay begins in a state at
// depth d, all later states of the delay have depth d + 1 or less. If an edge has already reached one of these states
// at depth d + 1, the predecessor by delay becomes the parent of this state. The shortest runs to the following states
// of the delay then pass through this state.
//
// The queue is processed block by block. First, all threads compute the moves of the states of a block, without
// changing the graph. States that the store does not contain are grouped by their hash values. Then one thread assigns
// numbers to the new states in the order of the block, which is the order of a sequential search. Finally, all threads
// insert the new states into the index and store the targets of the edges of the block. Therefore numbers, and all
// results derived from them, do not depend on the number of threads or the size of blocks.
#include "check/timed/explore.hpp"

#include <algorithm>
#include <atomic>
#include <functional>
#include <new>
#include <utility>

#include "check/timed/profile.hpp"
#include "check/timed/successor_batch.hpp"

namespace grafverif::timed {

double Limits::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

bool Limits::stopped() const {
    if (options_.stop && options_.stop->load(std::memory_order_relaxed)) return true;
    return options_.deadline && std::chrono::steady_clock::now() >= *options_.deadline;
}

UnknownReason Limits::stop_reason(const Graph& graph, std::uint32_t state, std::size_t more) {
    if (stopped()) return UnknownReason::Stopped;
    // The evaluation of properties requires additional memory. If the graph keeps its links, the index of the store is
    // freed before the evaluation.
    const std::size_t freed = graph.linked ? graph.store.index_bytes() : 0;
    const std::size_t bytes = graph.bytes() + more + std::max(16 * graph.states(), freed) - freed;
    if (allowed_used_ = bytes > options_.max_memory; allowed_used_) return UnknownReason::Memory;
    if (!options_.progress) return UnknownReason::None;
    const double now = seconds();
    if (now - shown_ < 0.2) return UnknownReason::None;
    shown_ = now;
    options_.progress({graph.states(), graph.transitions, graph.states() - state, bytes, now});
    return UnknownReason::None;
}

void Limits::explain(Graph& graph) {
    if (explained_ || !options_.many || graph.states() < many_states) return;
    explained_ = true;
    options_.many(profile_of(graph, options_.finest ? options_.finest() : std::nullopt));
}

namespace {

constexpr std::uint32_t slices_each = 64;      // number of slices (groups of consecutive states) for each thread in a
                                               // block
constexpr std::size_t many_text = 1U << 21U;   // a block ends when the computed successors have this number of words
constexpr std::size_t kept_bytes = 1U << 21U;  // maximum memory, in bytes, that a slice keeps for reuse

// Work is performed in parallel if it processes at least as many states, or new states, as this number of slices can
// contain.
constexpr std::size_t worth_sharing = 16;
constexpr std::size_t link_bytes = 24;  // maximum number of bytes of links per state; links are dropped if they need
                                        // more
constexpr std::size_t link_grace = 1U << 18U;  // up to this total number of bytes, links are never dropped

class Exploration {
public:
    Exploration(Graph& graph, PropertyMonitor& monitor, const std::vector<Field>& races, Limits& limits)
        : graph_(graph), monitor_(monitor), races_(races), limits_(limits), team_(limits.team()) {}

    UnknownReason run() {
        now_.words = packed_initial(graph_.machine.network(), graph_.machine.layout());
        new_states_.begin(1, 1);
        find_or_discover(0);
        new_states_.index(0, graph_.store.roots());
        while (graph_.explored < graph_.states()) {
            if (const UnknownReason obstacle = limits_.stop_reason(graph_, graph_.explored, held());
                obstacle != UnknownReason::None)
                return obstacle;
            if (limits_.until_decided() && monitor_.is_over()) return UnknownReason::Bound;
            limits_.explain(graph_);
            if (const UnknownReason obstacle = block(); obstacle != UnknownReason::None) return obstacle;
        }
        return UnknownReason::None;
    }

private:
    /// Calls `work(member)` once for each thread of the team. The calls run in parallel, or sequentially if the amount
    /// of work `size` is small.
    void share(std::size_t size, const std::function<void(unsigned)>& work) {
        if (size >= worth_sharing * limits_.slice() && team_.size() > 1) return team_.share(work);
        for (unsigned member = 0; member < team_.size(); ++member) work(member);
    }

    std::size_t held() const {
        std::size_t bytes = new_states_.bytes();
        for (const Slicer& slicer : slicers_) bytes += slicer.bytes();
        for (const SuccessorBatch& slice : slices_) bytes += slice.bytes();
        return bytes;
    }

    /// Processes the next states of the queue: computes their moves in parallel, then numbers the new states
    /// sequentially.
    UnknownReason block() {
        const auto first = static_cast<std::uint32_t>(graph_.states());
        filled_ = compute();
        gather();
        UnknownReason obstacle = UnknownReason::None;
        try {
            for (std::size_t i = 0; i < filled_ && obstacle == UnknownReason::None; ++i)
                obstacle = slices_[i].cut ? UnknownReason::Bound : number(slices_[i]);
        } catch (const std::bad_alloc&) {
            obstacle = UnknownReason::Memory;
        }
        store_links(graph_.states() - first);
        for (std::size_t i = 0; i < filled_; ++i) {
            note(slices_[i]);
            if (slices_[i].bytes() > kept_bytes) slices_[i] = {};
        }
        return obstacle;
    }

    /// Fills slices with the moves of the next states. Returns the number of usable slices: all slices up to and
    /// including the first slice that does not contain the moves of all its states. Later slices must not be used.
    std::size_t compute() {
        const std::size_t most = std::size_t{slices_each} * team_.size();
        const std::size_t states = graph_.states() - graph_.explored;
        const std::size_t count = std::min(most, (states + limits_.slice() - 1) / limits_.slice());
        if (slices_.size() < count) slices_.resize(count);
        while (slicers_.size() < team_.size()) slicers_.emplace_back(graph_, monitor_, races_);
        std::atomic<std::size_t> next = 0, computed = 0;
        std::atomic<bool> stopped = false;
        share(states, [&](unsigned member) {
            while (!stopped.load(std::memory_order_relaxed) && computed.load(std::memory_order_relaxed) < many_text) {
                const std::size_t at = next.fetch_add(1);
                if (at >= count) return;
                const std::size_t begin = graph_.explored + at * limits_.slice();
                const std::size_t end = std::min<std::size_t>(begin + limits_.slice(), graph_.states());
                const std::size_t words = slicers_[member].fill(slices_[at], static_cast<std::uint32_t>(begin),
                                                                static_cast<std::uint32_t>(end));
                computed.fetch_add(words, std::memory_order_relaxed);
                if (limits_.stopped()) stopped = true;
            }
        });
        const std::size_t begun = std::min(next.load(), count);
        for (std::size_t i = 0; i < begun; ++i)
            if (slices_[i].states.size() < limits_.slice()) return i + 1;
        return begun;
    }

    /// Stores the new states of all slices in `new_states_`, where equal states share one entry, and reserves memory
    /// for the new states.
    void gather() {
        std::size_t count = 0;
        for (std::size_t i = 0; i < filled_; ++i) {
            SuccessorBatch& slice = slices_[i];
            count += slice.new_states.size();
            for (const std::uint32_t k : slice.kept) {
                SuccessorBatch::NewState& new_state = slice.new_states[k];
                if (new_state.folded) continue;
                new_state.root = graph_.store.fold(words_of(slice, k), {}, next_);
                new_state.shard = graph_.store.roots().shard_of(new_state.root);
            }
        }
        const unsigned parts = count >= worth_sharing * limits_.slice() ? team_.size() : 1;
        new_states_.begin(parts, count);
        share(count, [&](unsigned member) {
            if (member >= parts) return;
            for (std::size_t i = 0; i < filled_; ++i) meet(slices_[i], member);
            graph_.store.roots().free_memory(new_states_.size(member) * parts, {member, parts});
        });
    }

    /// Adds to `new_states_` those new states of a slice that belong to part `part` of the hash table, in the order of
    /// the slice.
    void meet(SuccessorBatch& slice, unsigned part) {
        for (SuccessorBatch::NewState& new_state : slice.new_states) {
            if (new_states_.part_of(new_state.shard) != part) continue;
            const NewStates::Lookup met = new_states_.meet(part, new_state.root);
            new_state.entry = met.entry;
            new_state.first = met.fresh;
        }
    }

    /// Returns new state number `new_state` of the slice in packed form. Requires that SuccessorBatch::kept contains
    /// this number.
    const Word* words_of(const SuccessorBatch& slice, std::uint32_t new_state) const {
        const auto at = std::ranges::lower_bound(slice.kept, new_state) - slice.kept.begin();
        return slice.words.data() + static_cast<std::size_t>(at) * graph_.machine.layout().words;
    }

    /// Assigns numbers, in order, to the new states to which edges and delays lead from the states of a slice.
    UnknownReason number(const SuccessorBatch& slice) {
        for (std::uint32_t state = slice.begin; state != slice.end; ++state) {
            if (limits_.too_many(graph_)) return UnknownReason::Bound;
            if (state == level_end_ || state == 0) {
                graph_.levels.push_back(state);
                level_end_ = static_cast<std::uint32_t>(graph_.states());
            }
            visit(slice, state, slice.states[state - slice.begin]);
            graph_.explored = state + 1;
        }
        return UnknownReason::None;
    }

    void visit(const SuccessorBatch& slice, std::uint32_t state, const SuccessorBatch::State& at) {
        if (at.race) {
            if (!graph_.race) graph_.race = state;
            graph_.set_kind(state, StateKind::Open, state);
            return;
        }
        for (std::uint32_t i = at.first; i != at.first + at.edges; ++i) {
            const std::uint32_t target = slice.targets[i];
            if ((target & SuccessorBatch::new_state) == 0) continue;
            // If several new states of a block are equal, the first of them sets the number for all. In a covered
            // graph, a new state has no number if another state simulates it; therefore each of the equal states is
            // resolved.
            if (graph_.covered || slice.new_states[target & SuccessorBatch::number].first)
                resolve(slice, target, state, By::Edge);
        }
        graph_.transitions += at.computed;
        const bool acts = at.edges != 0;
        // Here, the target of a state in which time cannot pass is the state itself. The function `lead` later replaces
        // this target by the successor by an edge, unless the graph is covered (states may have been omitted).
        if (at.urgent) graph_.set_kind(state, StateKind::Urgent, state);
        else if (graph_.kind(state) == StateKind::Unknown) pass_time(state);
        if (acts && graph_.kind(state) == StateKind::Passes)
            graph_.set_kind(state, StateKind::PassesOrActs, graph_.target(state));
        if (acts && graph_.kind(state) == StateKind::Stuck) graph_.set_kind(state, StateKind::Acts, state);
        if (at.fault) graph_.set_kind(state, StateKind::Open, state);
    }

    /// Inserts the new states into the index of the store, and stores the targets of the edges of the expanded states.
    void store_links(std::size_t found) {
        next_slice_ = 0;
        share(std::max<std::size_t>(found, graph_.explored - slices_[0].begin), [&](unsigned member) {
            if (member < new_states_.parts()) new_states_.index(member, graph_.store.roots());
            if (graph_.covered) return;
            for (std::size_t i = 0; (i = next_slice_.fetch_add(1)) < filled_;) lead(slices_[i]);
        });
        try {
            for (std::size_t i = 0; i < filled_ && graph_.linked; ++i) {
                graph_.links.append(slices_[i].links);
                drop_links_if_many();
            }
        } catch (const std::bad_alloc&) {
            drop_links();
        }
    }

    /// Stores the targets of the edges of the expanded states of a slice. Does not allocate memory.
    void lead(SuccessorBatch& slice) {
        for (std::uint32_t state = slice.begin; state < std::min(slice.end, graph_.explored); ++state) {
            const SuccessorBatch::State& at = slice.states[state - slice.begin];
            if (graph_.linked) slice.links.begin();
            std::uint32_t last = state;
            // Greatest target of an edge. A state with a greater number usually leads to states with greater numbers.
            std::uint32_t onward = 0;
            std::uint32_t urgently = 0;  // greatest target of an urgent edge
            for (std::uint32_t i = at.first; i != at.first + at.edges; ++i) {
                const std::uint32_t next = number_of(slice, slice.targets[i]);
                if (graph_.linked) slice.links.add(std::exchange(last, next), next);
                onward = std::max(onward, next);
                if ((slice.targets[i] & SuccessorBatch::urgent) != 0) urgently = std::max(urgently, next);
            }
            const StateKind kind = graph_.kind(state);
            if (kind == StateKind::Urgent) graph_.set_kind(state, kind, urgently);
            if (kind == StateKind::Acts) graph_.set_kind(state, kind, onward);
        }
    }

    /// Returns the number of the state to which `target` refers. Requires that this state has a number.
    std::uint32_t number_of(const SuccessorBatch& slice, std::uint32_t target) const {
        const std::uint32_t number = target & SuccessorBatch::number;
        return (target & SuccessorBatch::new_state) == 0 ? number : new_states_.number(slice.new_states[number].entry);
    }

    /// The kind of move by which the search has reached a state.
    enum class By : std::uint8_t { Edge, Delay };

    /// Returns a state that simulates the new state in `words`, or Store::none if no state is suitable. If a delay has
    /// reached the new state, the result must have at most the current depth, or its delay must be known. Reason: two
    /// consecutive delays count as one move. This restriction does not apply if the search ignores depths.
    std::uint32_t simulating(const Word* words, By by) {
        if (graph_.covering && !graph_.covering->is_useful()) graph_.covering.reset();
        if (!graph_.covering) return Store::none;
        const std::uint32_t state = graph_.covering->find(words, [&](std::uint32_t other) {
            return by == By::Edge || limits_.ignores_depth() || other < level_end_ ||
                   graph_.kind(other) != StateKind::Unknown;
        });
        simulated_ = state != Store::none;
        return state;
    }

    /// Returns the number of the state to which `target` refers, or of a state that simulates this state. A new state
    /// that no other state simulates gets the next number when the search first reaches the new state.
    std::uint32_t resolve(const SuccessorBatch& slice, std::uint32_t target, std::uint32_t parent, By by) {
        const std::uint32_t index = target & SuccessorBatch::number;
        if ((target & SuccessorBatch::new_state) == 0) return index;
        const SuccessorBatch::NewState& new_state = slice.new_states[index];
        NewStates::Entry& entry = new_states_[new_state.entry];
        if (entry.number != Store::none) return entry.number;
        if (graph_.covering)
            if (const std::uint32_t other = simulating(words_of(slice, index), by); other != Store::none) return other;
        discover(entry, parent);
        if (new_state.needed) monitor_.look(graph_.machine, entry.number, words_of(slice, index), registers_);
        return entry.number;
    }

    /// Adds the new state of the entry to the graph, with its parent. If memory is exhausted, no part of the state is
    /// added. Tests the maximum number of states, because one expanded state can have very many new successors.
    void discover(NewStates::Entry& entry, std::uint32_t parent) {
        if (graph_.states() >= Store::most) throw std::bad_alloc();
        graph_.parent.free_memory(1);
        graph_.kinds.free_memory(1);
        entry.number = graph_.store.roots().append(entry.root);
        graph_.parent.push_back(parent);
        graph_.kinds.push_back(0);
        if (graph_.covering) graph_.covering->add(entry.number);
    }

    /// Returns the number of the state in `now_.words`, or of a state that simulates this state. If the state is new
    /// and no other state simulates it, the function adds the state to the graph.
    std::uint32_t find_or_discover(std::uint32_t parent) {
        const Word root = graph_.store.fold(now_.words.data(), {}, next_);
        if (const std::uint32_t known = graph_.store.roots().find(root); known != Store::none) return known;
        NewStates::Entry& entry =
            new_states_[new_states_.meet(new_states_.part_of(graph_.store.roots().shard_of(root)), root).entry];
        if (entry.number != Store::none) return entry.number;
        if (const std::uint32_t other = simulating(now_.words.data(), By::Delay); other != Store::none) return other;
        discover(entry, parent);
        if (monitor_.needs(graph_.machine, now_.words.data(), registers_))
            monitor_.look(graph_.machine, entry.number, now_.words.data(), registers_);
        return entry.number;
    }

    /// Returns the successor of the state after one unit of time, or a state that simulates this successor. Returns
    /// Store::none if time cannot pass. If the state belongs to the current block, the successor is read from its
    /// slice; otherwise, the successor is computed.
    std::uint32_t later(std::uint32_t state) {
        simulated_ = false;
        const std::size_t index = (state - slices_[0].begin) / limits_.slice();
        if (state >= slices_[0].begin && index < filled_) {
            const SuccessorBatch& slice = slices_[index];
            if (state < slice.end && slice.states[state - slice.begin].timed) {
                const SuccessorBatch::State& at = slice.states[state - slice.begin];
                return at.passes ? resolve(slice, slice.targets[at.first + at.edges], state, By::Delay) : Store::none;
            }
        }
        graph_.store.load(state, now_);
        return graph_.machine.delay(now_.words.data()) ? find_or_discover(state) : Store::none;
    }

    /// Advances time from the state, until time cannot pass or a state is reached whose delay is already known (see the
    /// comment at the beginning of this file).
    void pass_time(std::uint32_t state) {
        for (std::uint32_t now = state; graph_.kind(now) == StateKind::Unknown;) {
            const std::uint32_t next = later(now);
            if (next == Store::none) {
                graph_.set_kind(now, StateKind::Stuck, now);
                return;
            }
            graph_.set_kind(now, StateKind::Passes, next);
            ++graph_.transitions;
            graph_.time_passes = true;
            if (graph_.kind(next) == StateKind::Unknown && next >= level_end_ && !simulated_) graph_.parent[next] = now;
            now = next;
        }
    }

    void drop_links_if_many() {
        const std::size_t bytes = graph_.links.list_bytes();
        if (!graph_.linked || bytes < link_grace) return;
        if (bytes < link_bytes * graph_.states() && bytes < 0xF0000000U) return;
        drop_links();
    }

    void drop_links() {
        graph_.linked = false;
        graph_.links.clear();
    }

    /// Records the model errors and the uncovered invariant bounds (UncoveredBound) of the expanded states of a slice.
    void note(const SuccessorBatch& slice) {
        const auto first = [&](std::optional<UncoveredAt>& of, const std::optional<UncoveredAt>& at) {
            if (!of && at && at->state < graph_.explored) of = at;
        };
        first(graph_.stuck_bound, slice.stuck_bound);
        first(graph_.locked_bound, slice.locked_bound);
        for (const FaultAt& at : slice.faults) {
            if (at.state >= graph_.explored) return;
            const bool known = std::ranges::any_of(graph_.faults, [&](const FaultAt& other) {
                return other.fault.edge == at.fault.edge && other.fault.kind == at.fault.kind &&
                       other.fault.variable == at.fault.variable;
            });
            if (!known) graph_.faults.push_back(at);
        }
    }

    Graph& graph_;
    PropertyMonitor& monitor_;
    const std::vector<Field>& races_;
    Limits& limits_;
    ThreadPool& team_;
    std::vector<SuccessorBatch> slices_ = {};
    std::vector<Slicer> slicers_ = {};  // one slicer per thread
    NewStates new_states_ = {};
    std::size_t filled_ = 0;  // number of usable slices of the current block
    std::atomic<std::size_t> next_slice_ = 0;
    std::uint32_t level_end_ = 0;
    bool simulated_ = false;  // true if the last result of `later` is a state that simulates the successor
    Unfolded now_ = {}, next_ = {};
    PropertyMonitor::Registers registers_ = {};
};

}  // namespace

UnknownReason explore(Graph& graph, PropertyMonitor& monitor, const std::vector<Field>& races, Limits& limits) {
    try {
        return Exploration(graph, monitor, races, limits).run();
    } catch (const std::bad_alloc&) {
        // Even after an exception, all stored states are complete and in the index, and all expanded states have their
        // links.
        return UnknownReason::Memory;
    }
}

}  // namespace grafverif::timed
