// SPDX-License-Identifier: MIT
// Slice: where the moves of a few states in a row lead, computed by one thread beside others while nobody writes to the
// graph. States that the store does not hold yet are strangers: they are numbered when the search comes to them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "check/timed/graph.hpp"
#include "check/timed/watch.hpp"

namespace grafverif::timed {

constexpr std::size_t own_lines = 128;  // bytes that no other thread writes to, with the line fetched beside

/// Threads fill neighbours side by side: each has lines of the cache of its own.
struct alignas(own_lines) Slice {
    static constexpr std::uint32_t stranger = 1U << 31U, urgent = 1U << 30U, number = urgent - 1;

    struct State {
        std::uint32_t first = 0;  ///< in `targets`: where its edges lead, then time, where it passes
        std::uint32_t edges = 0;
        bool race = false;
        bool urgent = false;
        bool fault = false;
        bool timed = false;   ///< it was found out whether time passes
        bool passes = false;  ///< it does
    };
    struct Stranger {
        Word root = 0;            ///< where it is `folded`
        std::uint32_t entry = 0;  ///< in Strangers
        std::uint8_t shard = 0;   ///< of the root
        bool folded = false;
        bool wanted = false;  ///< by the watch
        bool first = false;   ///< no other of the same state stands before it in the block
    };

    std::uint32_t begin = 0, end = 0;  ///< the states looked at
    std::vector<State> states = {};
    std::vector<std::uint32_t> targets =
        {};  ///< with flags: a state's number or that of a stranger; reached by an urgent edge
    std::vector<Stranger> strangers = {};
    std::vector<std::uint32_t> kept = {};                            ///< those not folded, or wanted
    std::vector<Word> words = {};                                    ///< theirs, Layout::words apart
    Links::Part links = {};                                          ///< once all have their numbers
    std::optional<UncoveredAt> stuck_bound = {}, locked_bound = {};  ///< the first
    std::vector<FaultAt> faults = {};
    bool cut = false;  ///< a state has too many ways to choose inputs: see Moves

    std::size_t bytes() const;
};

/// What one thread needs to fill slices.
class alignas(own_lines) Slicer {
public:
    Slicer(const Graph& graph, const Watch& watch, const std::vector<Field>& races)
        : graph_(graph), watch_(watch), races_(races) {}

    /// The moves of the states from `begin` on, up to `end` or until they are many. Returns how many words were computed.
    std::size_t fill(Slice& slice, std::uint32_t begin, std::uint32_t end);
    std::size_t bytes() const { return words_.capacity() * sizeof(Word); }

private:
    void look_at(std::uint32_t state);
    void add(const Word* words, std::uint32_t flags);
    void look_up();

    const Graph& graph_;
    const Watch& watch_;
    const std::vector<Field>& races_;
    Slice* slice_ = nullptr;
    Moves moves_ = {};
    std::vector<Word> words_ = {};  // of all states that the slice leads to
    Unfolded now_ = {}, next_ = {};
    std::vector<Word> later_ = {};
};

/// The strangers of several slices, each once; in parts by the shards of their roots, so that threads can take a part
/// each, and index it.
class Strangers {
public:
    struct Entry {
        Word root = 0;
        std::uint32_t number = Store::none;  ///< once the search has come to it
    };

    /// Empties all, for so many parts and about so many strangers.
    void begin(unsigned parts, std::size_t strangers);
    unsigned part_of(unsigned shard) const { return shard % parts(); }
    struct Met {
        std::uint32_t entry = 0;
        bool fresh = false;
    };
    /// The entry of `root` in its part, a new one where it is met for the first time.
    Met meet(unsigned part, Word root);
    /// Those of a part that the search has come to are found in `roots` from here on.
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
    struct alignas(own_lines) Part {
        std::vector<std::uint32_t> slots = {};  // entry + 1; 0: free
        std::vector<Entry> entries = {};
    };
    static void widen(Part& part, std::size_t slots);

    std::vector<Part> parts_ = {};
};

}  // namespace grafverif::timed
