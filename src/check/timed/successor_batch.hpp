// SPDX-License-Identifier: MIT
// Batch of successors: the moves of a few consecutive states, computed by one thread in parallel with others, while
// nothing is written to the graph. States that the store does not contain yet are new: they are numbered when the
// search reaches them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "check/timed/graph.hpp"
#include "check/timed/property_monitor.hpp"

namespace grafverif::timed {

constexpr std::size_t own_lines = 128;  // bytes that no other thread writes, including the prefetched adjacent line

/// Threads fill adjacent slices in parallel: each has separate cache lines.
struct alignas(own_lines) SuccessorBatch {
    static constexpr std::uint32_t new_state = 1U << 31U, urgent = 1U << 30U, number = urgent - 1;

    struct State {
        std::uint32_t first = 0;  ///< in `targets`: the targets of its edges, then that of time, if it passes
        std::uint32_t edges = 0;
        bool race = false;
        bool urgent = false;
        bool fault = false;
        bool timed = false;   ///< true if it is known whether time passes
        bool passes = false;  ///< time passes
    };
    struct NewState {
        Word root = 0;            ///< if it is `folded`
        std::uint32_t entry = 0;  ///< index in the set of new states
        std::uint8_t shard = 0;   ///< of the root
        bool folded = false;
        bool wanted = false;  ///< by the watch
        bool first = false;   ///< true if no earlier entry in the block has the same state
    };

    std::uint32_t begin = 0, end = 0;  ///< the expanded states
    std::vector<State> states = {};
    std::vector<std::uint32_t> targets =
        {};  ///< with flags: the number of a state or of a new state; reached by an urgent edge
    std::vector<NewState> new_states = {};
    std::vector<std::uint32_t> kept = {};                            ///< entries that are not folded, or wanted
    std::vector<Word> words = {};                                    ///< their states, at intervals of Layout::words
    Links::Chunk links = {};                                         ///< valid after all targets have their numbers
    std::optional<UncoveredAt> stuck_bound = {}, locked_bound = {};  ///< the first
    std::vector<FaultAt> faults = {};
    bool cut = false;  ///< a state has too many combinations of inputs: see Moves

    std::size_t bytes() const;
};

/// Working data of one thread that fills slices.
class alignas(own_lines) Slicer {
public:
    Slicer(const Graph& graph, const PropertyMonitor& watch, const std::vector<Field>& races)
        : graph_(graph), watch_(watch), races_(races) {}

    /// Computes the moves of the states from `begin` on, up to `end` or a limit of size. Returns the number of computed
    /// words.
    std::size_t fill(SuccessorBatch& slice, std::uint32_t begin, std::uint32_t end);
    std::size_t bytes() const { return words_.capacity() * sizeof(Word); }

private:
    void look_at(std::uint32_t state);
    void add(const Word* words, std::uint32_t flags);
    void look_up();

    const Graph& graph_;
    const PropertyMonitor& watch_;
    const std::vector<Field>& races_;
    SuccessorBatch* slice_ = nullptr;
    Moves moves_ = {};
    std::vector<Word> words_ = {};  // of all states that the slice leads to
    Unfolded now_ = {}, next_ = {};
    std::vector<Word> later_ = {};
};

/// The new states of several slices, each once. They are partitioned by the shards of their roots, so that each thread
/// can process and index one part.
class NewStates {
public:
    struct Entry {
        Word root = 0;
        std::uint32_t number = Store::none;  ///< valid after the search has reached it
    };

    /// Clears all parts and reserves memory for this number of states.
    void begin(unsigned parts, std::size_t new_states);
    unsigned part_of(unsigned shard) const { return shard % parts(); }
    struct Lookup {
        std::uint32_t entry = 0;
        bool fresh = false;
    };
    /// The entry of `root` in its part, a new one at its first occurrence.
    Lookup meet(unsigned part, Word root);
    /// Indexes the states of a part that the search has reached in `roots`.
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
        std::vector<std::uint32_t> slots = {};  // entry + 1; 0: free
        std::vector<Entry> entries = {};
    };
    static void widen(Shard& part, std::size_t slots);

    std::vector<Shard> parts_ = {};
};

}  // namespace grafverif::timed
