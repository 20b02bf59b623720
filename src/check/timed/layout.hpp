// SPDX-License-Identifier: MIT
// Layout: the position of each location, variable and clock of a network in the bits of a state.
//
// A state is an array of 64-bit words. No field crosses a word, so that reading one is a shift and a mask, and a
// conjunction of Booleans in one word is one comparison. A Boolean uses one bit, an integer the bits of its range, a
// clock those of its cap (see clocks). Scratch variables follow the stored words: they are written before they are
// read, so they need not be cleared or compared.
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

// The clocks of a network (ir/network_clocks) as the timed engine uses them, and inexact places of integer time.

using Interval = ClockInterval;

/// The first place that integer time does not decide exactly: a strict constraint, or an urgent edge that time may
/// disable. Empty if there is none.
std::optional<std::string> inexact_place(const Network& network);

using Word = std::uint64_t;

struct Field {
    std::uint16_t word = 0;
    std::uint8_t shift = 0;
    std::uint8_t width = 0;  ///< 0: always `low`
    std::int64_t low = 0;    ///< the value of the raw bits 0

    /// All bits of the field.
    Word all() const { return width == 0 ? 0 : ~Word{0} >> (64U - width); }
    Word mask() const { return width == 0 ? 0 : all() << shift; }
    Word raw(const Word* words) const { return width == 0 ? 0 : (words[word] & mask()) >> shift; }
    std::int64_t get(const Word* words) const { return low + static_cast<std::int64_t>(raw(words)); }
    /// `value` at the position of the field, every other bit 0.
    Word placed(std::int64_t value) const { return static_cast<Word>(value - low) << shift; }
    void set(Word* words, std::int64_t value) const {
        words[word] = (words[word] & ~mask()) | (width == 0 ? 0 : placed(value));
    }
};

struct Layout {
    static constexpr std::size_t most_text = std::size_t{1}
                                             << 16U;  ///< that a field can address; for more, `fits` is false
    bool fits() const { return words <= most_text; }

    std::vector<Field> locations = {};            ///< per process
    std::vector<Field> variables = {};            ///< per variable
    std::vector<std::vector<Field>> clocks = {};  ///< per process and clock
    std::vector<Field> choices = {};              ///< per choice, the possible valuations; width 0: not kept
    std::size_t stored = 1;                       ///< words of a state
    std::size_t words = 1;                        ///< including scratch variables
    std::size_t halves = 1;                       ///< 32-bit units that hold every stored bit
    std::vector<std::size_t> seams = {};          ///< those at which a subsystem begins, except the first
};

/// `network` is expanded.
Layout layout_of(const Network& network, const std::vector<ProcessClocks>& clocks,
                 const std::vector<InputChoice>& choices = {});

/// The initial state in packed form: layout.words words.
std::vector<Word> packed_initial(const Network& network, const Layout& layout);

}  // namespace grafverif::timed
