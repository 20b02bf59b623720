// SPDX-License-Identifier: MIT
// Monitors: searches for single states that decide properties, all properties together. A monitor ends when it has
// found its state, so that decided properties cause no further cost.
#pragma once

#include <cstdint>
#include <vector>

#include "check/timed/machine.hpp"

namespace grafverif::timed {

class PropertyMonitor {
public:
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    using Registers = std::vector<std::int64_t>;

    /// Adds a search for a state where `predicate` ends in Yes. Returns the number of the watch.
    std::size_t add(std::uint32_t predicate);
    /// Adds a search for a state where the bit of a variable is set, and `settled` holds if it is not Program::yes.
    std::size_t add_bit(const Field& bit, std::uint32_t settled);

    /// True if a new state would be the first for some watch. Thread-safe.
    bool wants(const Machine& machine, const Word* words, Registers& registers) const;
    /// Evaluates a new state for which wants() is true.
    void look(const Machine& machine, std::uint32_t state, const Word* words, Registers& registers);
    /// True if each watch has found its state, or met an undefined predicate.
    bool is_over() const { return predicates_.empty() && bits_.empty(); }
    /// The first state found, or none.
    std::uint32_t found(std::size_t watch) const { return results_[watch].state; }
    /// True if the predicate was undefined in some state.
    bool broken(std::size_t watch) const { return results_[watch].broken; }

private:
    struct Result {
        std::uint32_t state = none;
        bool broken = false;
    };
    struct Predicate {
        std::uint32_t code = 0;
        std::size_t watch = 0;
    };
    struct Bit {
        Word mask = 0;
        std::size_t watch = 0;
    };
    struct Bits {  // of one word, under one condition
        std::uint16_t word = 0;
        std::uint32_t settled = 0;
        Word missing = 0;
        std::vector<Bit> each = {};
    };

    std::vector<Predicate> predicates_ = {};
    std::vector<Bits> bits_ = {};
    std::vector<Result> results_ = {};
};

}  // namespace grafverif::timed
