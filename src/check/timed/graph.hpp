// SPDX-License-Identifier: MIT
// Graph: the states that a search has found and the transitions between them.
//
// The StateKind of a state and one of its successors, called the target, are stored in one 32-bit word. `links`
// contains, for each state, a list of the successors by edges. The number of a successor is encoded as the difference
// from the previous number in the list; the first number is encoded as the difference from the number of the state. A
// difference is stored in groups of seven bits, because most differences are small. If links use too many bytes per
// state, they are discarded. If the links have been discarded, successors are computed again on demand, which saves
// memory but costs time. The parents of states determine a shortest run to each state.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "check/timed/machine.hpp"
#include "check/timed/macro_steps.hpp"
#include "check/timed/store/column.hpp"
#include "check/timed/store/covering.hpp"
#include "check/timed/store/store.hpp"
#include "check/timed/timed.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif::timed {

/// Classifies a state: whether time can pass in the state, and whether an edge or an urgent edge is enabled.
enum class StateKind : std::uint32_t {
    Unknown,       ///< the state was not expanded
    Passes,        ///< time can pass, and no edge is enabled
    PassesOrActs,  ///< time can pass, and an edge is enabled
    Urgent,        ///< an urgent edge stops time; the target is the successor by this edge
    Stuck,         ///< an invariant stops time, and no edge is enabled
    Acts,          ///< an invariant stops time, and an edge is enabled; the target is a successor by an edge
    Open,          ///< a model error occurs in this state, so that the list of its successors is incomplete
};

/// Compressed lists of target states, one list per state.
class Links {
public:
    /// The lists of a few consecutive states. Several threads build different chunks in parallel.
    struct Chunk {
        static constexpr std::size_t most = 5;  ///< maximum number of bytes of one target in a list
        std::vector<std::uint8_t> bytes = {};
        std::vector<std::uint32_t> begins = {};  ///< start of each list in `bytes`

        /// Begins the list of the next state.
        void begin() { begins.push_back(static_cast<std::uint32_t>(bytes.size())); }
        /// Adds the target `next`. `last` is the previous target of the list, or the state to which the list belongs.
        void add(std::uint32_t last, std::uint32_t next) {
            const auto distance = static_cast<std::int64_t>(next) - static_cast<std::int64_t>(last);
            auto rest = static_cast<std::uint64_t>(distance < 0 ? -2 * distance - 1 : 2 * distance);
            for (; rest >= 128; rest >>= 7U) bytes.push_back(static_cast<std::uint8_t>(rest | 128U));
            bytes.push_back(static_cast<std::uint8_t>(rest));
        }
    };
    /// Appends the lists of the next states.
    void append(const Chunk& part) {
        const auto first = static_cast<std::uint32_t>(bytes_.size());
        bytes_.append(part.bytes.data(), part.bytes.size());
        ends_.free_memory(part.begins.size());
        for (const std::uint32_t begin : part.begins) ends_.push_back(first + begin);
    }

    template <class Visit>
    void each(std::uint32_t state, const Visit& visit) const {
        const std::size_t end = state + 1 < ends_.size() ? ends_[state + 1] : bytes_.size();
        auto now = static_cast<std::int64_t>(state);
        for (std::size_t at = ends_[state]; at != end;) {
            std::uint64_t rest = 0;
            for (unsigned shift = 0;; shift += 7) {
                const std::uint8_t byte = bytes_[at++];
                rest |= static_cast<std::uint64_t>(byte & 127U) << shift;
                if (byte < 128) break;
            }
            const auto half = static_cast<std::int64_t>((rest + 1) / 2);
            now += rest % 2 != 0 ? -half : half;
            visit(static_cast<std::uint32_t>(now));
        }
    }

    std::size_t list_bytes() const { return bytes_.size(); }
    std::size_t bytes() const { return bytes_.bytes() + ends_.bytes(); }
    void clear() {
        bytes_.clear();
        ends_.clear();
    }

private:
    Column<std::uint8_t> bytes_ = {};
    Column<std::uint32_t> ends_ = {};  // start of the list of each state
};

/// A set of states. Several threads may call `add_concurrently` and `has` at the same time.
class StateSet {
public:
    explicit StateSet(std::size_t states) : words_((states + 63) / 64) {}
    bool has(std::uint32_t state) const { return (word(state).load(relaxed) & bit(state)) != 0; }
    void add(std::uint32_t state) { word(state).store(word(state).load(relaxed) | bit(state), relaxed); }
    void add_concurrently(std::uint32_t state) { word(state).fetch_or(bit(state), relaxed); }
    void remove(std::uint32_t state) { word(state).store(word(state).load(relaxed) & ~bit(state), relaxed); }

    /// Returns a word for the states 64 * `index` to 64 * `index` + 63: bit k is 1 if state 64 * `index` + k belongs to
    /// the set.
    std::uint64_t bits(std::size_t index) const { return words_[index].load(relaxed); }

private:
    using Atomic = std::atomic<std::uint64_t>;
    static constexpr std::memory_order relaxed = std::memory_order_relaxed;
    static std::uint64_t bit(std::uint32_t state) { return std::uint64_t{1} << (state & 63U); }
    Atomic& word(std::uint32_t state) { return words_[state >> 6U]; }
    const Atomic& word(std::uint32_t state) const { return words_[state >> 6U]; }

    std::vector<Atomic> words_;
};

struct UncoveredAt {
    std::uint32_t state = 0;
    UncoveredBound bound = {};
};
struct FaultAt {
    std::uint32_t state = 0;
    Fault fault = {};
};

/// The states and transitions of a search. Several threads may call const functions at the same time.
class Graph {
public:
    explicit Graph(Machine& compiled) : machine(compiled), macro_steps(compiled), store(compiled.layout()) {}

    static constexpr std::uint32_t kind_shift = 29, target_mask = (1U << kind_shift) - 1;

    Machine& machine;
    MacroSteps macro_steps;  ///< computes the edges of the graph
    Store store;
    Column<std::uint32_t> parent = {};
    Column<std::uint32_t> kinds = {};  // kind and target (one successor) of each state
    Links links = {};                  // lists of the successors of the expanded states
    bool linked = true;
    /// Finds states that other states simulate, so that the search can omit them. Null if no states are omitted, or if
    /// the search no longer omits states because too few states could be omitted.
    std::unique_ptr<Covering> covering = {};
    /// True if states may have been omitted. If true, successors may be missing, so that only properties about single
    /// states are decided.
    bool covered = false;
    std::uint32_t explored = 0;              // number of expanded states; only expanded states have a kind and links
    std::vector<std::uint32_t> levels = {};  // number of the first state at each depth
    std::uint64_t transitions = 0;           // number of computed transitions, including transitions inside macro-steps
    bool time_passes = false;
    std::optional<UncoveredAt> stuck_bound = {}, locked_bound = {};
    std::vector<FaultAt> faults = {};        // model errors; at most one for each edge and variable
    std::optional<std::uint32_t> race = {};  // the first state with a race

    std::size_t states() const { return store.size(); }
    StateKind kind(std::uint32_t state) const { return static_cast<StateKind>(kinds[state] >> kind_shift); }
    /// Returns the stored successor of the state: the successor after one unit of time if time can pass, otherwise a
    /// successor by an edge.
    std::uint32_t target(std::uint32_t state) const { return kinds[state] & target_mask; }
    bool passes(std::uint32_t state) const {
        return kind(state) == StateKind::Passes || kind(state) == StateKind::PassesOrActs;
    }
    bool open(std::uint32_t state) const { return state >= explored || kind(state) == StateKind::Open; }
    void set_kind(std::uint32_t state, StateKind kind, std::uint32_t target) {
        kinds[state] = (static_cast<std::uint32_t>(kind) << kind_shift) | (target & target_mask);
    }
    std::size_t bytes() const {
        return store.bytes() + parent.bytes() + kinds.bytes() + links.bytes() + (covering ? covering->bytes() : 0);
    }

    /// Calls `visit(state)` for each successor of `state` by an edge.
    template <class Visit>
    void each_action(std::uint32_t state, const Visit& visit) {
        if (linked) {
            links.each(state, visit);
            return;
        }
        expand(state);
        for (std::size_t i = 0; i < moves_.edges.size(); ++i)
            visit(store.find(moves_.words.data() + i * machine.layout().words, found_));
    }
    /// Calls `visit` for each successor of `state` by an edge, and for the successor after one unit of time if time can
    /// pass.
    template <class Visit>
    void each(std::uint32_t state, const Visit& visit) {
        each_action(state, visit);
        if (passes(state)) visit(target(state));
    }
    /// Stores the successors of `state` by urgent edges in `found`.
    void urgent_successors(std::uint32_t state, std::vector<std::uint32_t>& found);

    /// Computes the edges of the graph that begin in the state `words`. Returns the number of computed moves, including
    /// moves inside macro-steps.
    std::size_t expand(const Word* words, Moves& moves, MacroSteps::Buffers& buffers) const {
        if (macro_steps.applies()) return macro_steps.expand(words, moves, buffers);
        machine.expand(words, moves);
        return moves.edges.size();
    }
    /// Returns the moves that lead from the state `words` to its successor `to`: a delay, an edge, or the edges of a
    /// macro-step. Changes `words` to `to`, with the values of variables that are not stored.
    std::vector<AbstractState> moves_between(std::vector<Word>& words, std::uint32_t to);
    /// Returns the moves along a path of states. Consecutive delays are joined to one move, except for two delays
    /// between which the loop begins (at index `loop`).
    Run run_along(const std::vector<std::uint32_t>& path, std::optional<std::size_t> loop = {});
    /// Stores state number `number` in `state`. Variables that are not stored (scratch variables) get their initial
    /// values.
    void read(std::uint32_t number, NetworkState& state);
    /// Returns the states of a path, except the first, in the form of TimedResult::paths.
    std::vector<AbstractState> states_along(const std::vector<std::uint32_t>& path);
    /// Returns the path from the initial state to `state`.
    std::vector<std::uint32_t> path_to(std::uint32_t state) const;
    Run run_to(std::uint32_t state) { return run_along(path_to(state)); }

    End holds(std::uint32_t predicate, std::uint32_t state) {
        return machine.holds(predicate, load(state), moves_.registers);
    }
    const Word* load(std::uint32_t state) {
        store.load(state, now_);
        return now_.words.data();
    }

private:
    void expand(std::uint32_t state) { expand(load(state), moves_, buffers_); }
    NetworkState state_of(const Word* words) const;
    void unpack(const Word* words, NetworkState& state) const;
    std::vector<Word> first_words(const std::vector<std::uint32_t>& path);

    Moves moves_ = {};
    MacroSteps::Buffers buffers_ = {};
    Unfolded now_ = {}, found_ = {};
};

}  // namespace grafverif::timed
