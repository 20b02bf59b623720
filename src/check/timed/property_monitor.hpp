// SPDX-License-Identifier: MIT
// PropertyMonitor: searches for single states that decide properties. One pass over the states performs the searches
// for all properties. The search for a property ends when it has found a state; a decided property causes no further
// cost.
#pragma once

#include <cstdint>
#include <vector>

#include "check/timed/machine.hpp"

namespace grafverif::timed {

class PropertyMonitor {
public:
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    using Registers = std::vector<std::int64_t>;

    /// Adds a search for a state in which `predicate` ends in Yes. Returns the index of the search.
    std::size_t add(std::uint32_t predicate);
    /// Adds a search for a state in which the bit of a Boolean variable is 1. If `quiescent` is not Program::yes, the
    /// predicate `quiescent` must also hold in the state.
    std::size_t add_bit(const Field& bit, std::uint32_t quiescent);

    /// True if the new state may end a search, so that look() must be called. Thread-safe.
    bool needs(const Machine& machine, const Word* words, Registers& registers) const;
    /// Sets `marks` to the searches that the state would end, one bit per search. Returns false if a predicate is
    /// undefined in the state. Thread-safe.
    bool mark(const Machine& machine, const Word* words, Registers& registers, std::vector<Word>& marks) const;
    /// Evaluates a new state for which needs() returned true, and ends the searches that the state decides.
    void look(const Machine& machine, std::uint32_t state, const Word* words, Registers& registers);
    /// True if all searches have ended: each search has found a state, or its predicate was undefined in some state.
    bool is_over() const { return predicates_.empty() && bits_.empty(); }
    /// Returns the state that the search `search` found, or `none`.
    std::uint32_t found(std::size_t search) const { return results_[search].state; }
    /// True if the predicate of the search was undefined in some state.
    bool broken(std::size_t search) const { return results_[search].broken; }

private:
    struct Result {
        std::uint32_t state = none;
        bool broken = false;
    };
    struct Predicate {
        std::uint32_t code = 0;
        std::size_t search = 0;
    };
    struct Bit {
        Word mask = 0;
        std::size_t search = 0;
    };
    struct Bits {  // bits of one word; their searches have the same predicate `quiescent`
        std::uint16_t word = 0;
        std::uint32_t quiescent = 0;
        Word missing = 0;
        std::vector<Bit> each = {};
    };

    std::vector<Predicate> predicates_ = {};
    std::vector<Bits> bits_ = {};
    std::vector<Result> results_ = {};
};

}  // namespace grafverif::timed
