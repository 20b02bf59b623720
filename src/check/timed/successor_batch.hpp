// SPDX-License-Identifier: MIT
// SuccessorBatch (slice): the moves of a few consecutive states. Several threads compute different batches in parallel.
// The graph does not change during the computation. A successor that the store does not contain is a *new state*; it
// receives its number later, when the search reaches it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "check/timed/graph.hpp"
#include "check/timed/property_monitor.hpp"

namespace grafverif::timed {

/// Alignment, in bytes, of data that only one thread writes. The value is the size of two cache lines, because the
/// processor also prefetches the adjacent cache line.
constexpr std::size_t own_lines = 128;

/// A slice of the queue of unexpanded states, with the successors of these states. Different threads fill adjacent
/// slices in parallel; therefore no two slices share a cache line.
struct alignas(own_lines) SuccessorBatch {
    static constexpr std::uint32_t new_state = 1U << 31U, urgent = 1U << 30U, number = urgent - 1;

    struct State {
        /// Index in `targets` of the first target of the state. The targets of a state are the successors by edges and
        /// then, if time can pass, the successor after one time unit.
        std::uint32_t first = 0;
        std::uint32_t edges = 0;
        std::uint32_t computed = 0;  ///< number of computed moves (Graph::expand)
        bool race = false;
        bool urgent = false;
        bool fault = false;
        bool timed = false;   ///< true if `passes` is known
        bool passes = false;  ///< true if time can pass in the state
    };
    struct NewState {
        Word root = 0;            ///< root pair of the state; valid if `folded` is true
        std::uint32_t entry = 0;  ///< index of the entry in NewStates
        std::uint8_t shard = 0;   ///< shard of the root pair
        bool folded = false;
        bool needed = false;  ///< true if a property monitor needs the state
        bool first = false;   ///< true if this is the first of several equal new states in the block of slices
    };

    std::uint32_t begin = 0, end = 0;  ///< range of the states of the slice: `begin` to `end` - 1
    std::vector<State> states = {};
    /// Numbers of states, or indices of new states (flag `new_state`). The flag `urgent` marks a successor by an urgent
    /// edge.
    std::vector<std::uint32_t> targets = {};
    std::vector<NewState> new_states = {};
    /// Indices of the new states whose words are stored in `words`: states that are not folded, or that a property
    /// monitor or the covering needs.
    std::vector<std::uint32_t> kept = {};
    std::vector<Word> words = {};  ///< words of the states in `kept`, Layout::words for each state
    Links::Chunk links = {};       ///< valid after all targets have numbers

    /// The first uncovered bounds in the slice (see Moves::stuck_bound and Moves::locked_bound).
    std::optional<UncoveredAt> stuck_bound = {}, locked_bound = {};
    std::vector<FaultAt> faults = {};
    bool cut = false;  ///< true if some state has too many combinations of inputs (see Moves::cut)

    std::size_t bytes() const;
};

/// Fills slices. Each thread has a separate Slicer, which contains the buffers of the thread.
class alignas(own_lines) Slicer {
public:
    Slicer(const Graph& graph, const PropertyMonitor& monitor, const std::vector<Field>& races)
        : graph_(graph), monitor_(monitor), races_(races) {}

    /// Computes the moves of the states from `begin` to `end` - 1, and stops early if a size limit is reached. Returns
    /// the number of words of the computed successors.
    std::size_t fill(SuccessorBatch& slice, std::uint32_t begin, std::uint32_t end);
    std::size_t bytes() const { return words_.capacity() * sizeof(Word); }

private:
    void look_at(std::uint32_t state);
    void add(const Word* words, std::uint32_t flags);
    void look_up();

    const Graph& graph_;
    const PropertyMonitor& monitor_;
    const std::vector<Field>& races_;
    SuccessorBatch* slice_ = nullptr;
    Moves moves_ = {};
    MacroSteps::Buffers buffers_ = {};
    std::vector<Word> words_ = {};  // words of all successors of the slice
    Unfolded now_ = {}, next_ = {};
    std::vector<Word> later_ = {};
};

/// The distinct new states of several slices, partitioned by the shards of their root pairs. Each thread processes and
/// indexes one part.
class NewStates {
public:
    struct Entry {
        Word root = 0;
        std::uint32_t number = Store::none;  ///< number of the state; `none` until the search has reached the state
    };

    /// Removes all states, sets the number of parts, and reserves memory for `new_states` states.
    void begin(unsigned parts, std::size_t new_states);
    unsigned part_of(unsigned shard) const { return shard % parts(); }
    struct Lookup {
        std::uint32_t entry = 0;
        bool fresh = false;
    };
    /// Returns the entry of the root pair `root` in `part`. If the part does not contain the pair, adds an entry.
    Lookup meet(unsigned part, Word root);
    /// Adds to the index of `roots` those states of a part that the search has reached.
    void index(unsigned part, Pairs& roots) const;
    Entry& operator[](std::uint32_t entry) {
        const auto parts = static_cast<std::uint32_t>(parts_.size());
        return parts_[entry % parts].entries[entry / parts];
    }
    std::uint32_t number(std::uint32_t entry) const { return parts_[entry % parts()].entries[entry / parts()].number; }
    unsigned parts() const { return static_cast<unsigned>(parts_.size()); }
    std::size_t size(unsigned part) const { return parts_[part].entries.size(); }
    std::size_t bytes() const;

private:
    struct alignas(own_lines) Shard {
        std::vector<std::uint32_t> slots = {};  // a slot contains the index of an entry plus 1; a free slot is 0
        std::vector<Entry> entries = {};
    };
    static void widen(Shard& part, std::size_t slots);

    std::vector<Shard> parts_ = {};
};

}  // namespace grafverif::timed
