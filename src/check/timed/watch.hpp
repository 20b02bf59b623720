// SPDX-License-Identifier: MIT
// Watch: what the search looks for in single states, all properties at once. A watch is over when it has found its
// state, so that what is decided costs no more.
#pragma once

#include <cstdint>
#include <vector>

#include "check/timed/machine.hpp"

namespace grafverif::timed {

class Watch {
public:
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    using Registers = std::vector<std::int64_t>;

    /// Looks for a state where `predicate` ends in Yes. Returns the number of the watch.
    std::size_t add(std::uint32_t predicate);
    /// Looks for a state where the bit of a variable is set, and `settled` holds if it is not Program::yes.
    std::size_t add_bit(const Field& bit, std::uint32_t settled);

    /// Whether a new state would be the first for some watch. Threads may ask side by side.
    bool wants(const Machine& machine, const Word* words, Registers& registers) const;
    /// A new state that is wanted.
    void look(const Machine& machine, std::uint32_t state, const Word* words, Registers& registers);
    /// True if each watch has found its state, or met a predicate without value.
    bool is_over() const { return predicates_.empty() && bits_.empty(); }
    /// The first state found, or none.
    std::uint32_t found(std::size_t watch) const { return results_[watch].state; }
    /// The predicate had no value in some state.
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
