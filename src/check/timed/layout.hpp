// SPDX-License-Identifier: MIT
// Layout: position of each location, variable and clock of a network in the bits of a state.
//
// A state is an array of 64-bit words. A field does not cross a word boundary. Therefore a field is read by a shift and
// a mask, and a conjunction of Booleans in one word is tested by one comparison. A Boolean uses one bit; an integer
// uses the bits of its range, and a clock the bits of its cap (ir/network_clocks.hpp). Scratch variables follow the
// stored words. They are written before they are read, and therefore need not be cleared or compared.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "ir/network_clocks.hpp"
#include "ir/network_inputs.hpp"

namespace grafverif::timed {

/// The admitted values of a clock (ir/network_clocks.hpp).
using Interval = ClockInterval;

/// Returns the first element for which integer time is inexact: a strict constraint, or an urgent edge that the passing
/// of time may disable. Returns nullopt if integer time is exact.
std::optional<std::string> inexact_place(const Network& network);

using Word = std::uint64_t;

struct Field {
    std::uint16_t word = 0;
    std::uint8_t shift = 0;
    std::uint8_t width = 0;  ///< number of bits; 0 if the value is always `low`
    std::int64_t low = 0;    ///< value that is represented by raw bits that are all 0

    /// Returns a mask of all bits of the field, without shift.
    Word all() const { return width == 0 ? 0 : ~Word{0} >> (64U - width); }
    Word mask() const { return width == 0 ? 0 : all() << shift; }
    Word raw(const Word* words) const { return width == 0 ? 0 : (words[word] & mask()) >> shift; }
    std::int64_t get(const Word* words) const { return low + static_cast<std::int64_t>(raw(words)); }
    /// Returns a word with `value` at the position of the field and all other bits 0.
    Word placed(std::int64_t value) const { return static_cast<Word>(value - low) << shift; }
    void set(Word* words, std::int64_t value) const {
        words[word] = (words[word] & ~mask()) | (width == 0 ? 0 : placed(value));
    }
};

struct Layout {
    /// Maximum number of words that a field can address; with more words, `fits` is false.
    static constexpr std::size_t most_text = std::size_t{1} << 16U;
    bool fits() const { return words <= most_text; }

    std::vector<Field> locations = {};            ///< one field per process
    std::vector<Field> variables = {};            ///< one field per variable
    std::vector<std::vector<Field>> clocks = {};  ///< one field per process and clock
    /// For each choice: set of possible valuations; width 0 if the set is not stored.
    std::vector<Field> choices = {};
    std::size_t stored = 1;               ///< number of words of a state
    std::size_t words = 1;                ///< number of words including scratch variables
    std::size_t halves = 1;               ///< number of 32-bit units that contain all stored bits
    std::vector<std::size_t> seams = {};  ///< units at which a subsystem begins, except the first subsystem
};

/// Computes the layout of `network`, which must be expanded.
Layout layout_of(const Network& network, const std::vector<ProcessClocks>& clocks,
                 const std::vector<InputChoice>& choices = {});

/// Returns the initial state in packed form, with layout.words words.
std::vector<Word> packed_initial(const Network& network, const Layout& layout);

}  // namespace grafverif::timed
