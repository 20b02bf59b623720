// SPDX-License-Identifier: MIT
// Batch of successors (slice): the moves of a few consecutive states. One thread computes a batch while other threads
// compute other batches. While batches are computed, the graph is not changed. States that are not yet in the store are
// new: a new state receives its number when the search reaches it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "check/timed/graph.hpp"
#include "check/timed/property_monitor.hpp"

namespace grafverif::timed {

/// Alignment, in bytes, of data that only one thread writes. The alignment is two cache lines, because the processor
/// also prefetches the adjacent cache line.
constexpr std::size_t own_lines = 128;

/// A slice of the queue of unexpanded states, with the successors of these states. Threads fill adjacent slices in
/// parallel; therefore each slice has separate cache lines.
struct alignas(own_lines) SuccessorBatch {
    static constexpr std::uint32_t new_state = 1U << 31U, urgent = 1U << 30U, number = urgent - 1;

    struct State {
        /// Index of the first target in `targets`: first the successors by edges and then, if time can pass, the
        /// successor after one time unit.
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
        Word root = 0;            ///< valid if `folded`
        std::uint32_t entry = 0;  ///< index of the entry in the set of new states
        std::uint8_t shard = 0;   ///< shard of the root
        bool folded = false;
        bool needed = false;  ///< true if a property monitor needs the state
        bool first = false;   ///< true if the state differs from all earlier new states in the block of slices
    };

    std::uint32_t begin = 0, end = 0;  ///< range of the expanded states
    std::vector<State> states = {};
    /// Numbers of states or of new states, with flags; the flag `urgent` marks a successor by an urgent edge.
    std::vector<std::uint32_t> targets = {};
    std::vector<NewState> new_states = {};
    /// Indices of the new states that are not folded or that a property monitor or the covering needs.
    std::vector<std::uint32_t> kept = {};
    std::vector<Word> words = {};  ///< words of the states in `kept`, Layout::words for each state
    Links::Chunk links = {};       ///< valid after all targets have numbers
    /// The first uncovered bounds of the slice: see Moves::stuck_bound and Moves::locked_bound.
    std::optional<UncoveredAt> stuck_bound = {}, locked_bound = {};
    std::vector<FaultAt> faults = {};
    bool cut = false;  ///< true if a state has too many combinations of inputs: see Moves::cut

    std::size_t bytes() const;
};

/// Fills slices in one thread, and contains the buffers of this thread.
class alignas(own_lines) Slicer {
public:
    Slicer(const Graph& graph, const PropertyMonitor& monitor, const std::vector<Field>& races)
        : graph_(graph), monitor_(monitor), races_(races) {}

    /// Computes the moves of the states from `begin` to `end` - 1, and stops early if a size limit is reached. Returns
    /// the number of computed words.
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

/// The distinct new states of several slices, partitioned by the shards of their roots. Each thread processes and
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
    /// Returns the entry of `root` in `part`. If the part does not contain `root`, an entry is added.
    Lookup meet(unsigned part, Word root);
    /// Adds the states of a part that the search has reached to the index of `roots`.
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
        std::vector<std::uint32_t> slots = {};  // a slot contains the index of an entry plus 1; 0 for a free slot
        std::vector<Entry> entries = {};
    };
    static void widen(Shard& part, std::size_t slots);

    std::vector<Shard> parts_ = {};
};

}  // namespace grafverif::timed
