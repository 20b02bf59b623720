// SPDX-License-Identifier: MIT
// Layout: the position of each location, variable and clock of a network in the bits of a packed state.
//
// A state is an array of 64-bit words. A field does not cross a word boundary. Therefore a field is read by a shift and
// a mask, and a conjunction of Booleans in one word is tested by one comparison. A Boolean uses one bit. An integer
// uses as many bits as its range requires. A clock uses as many bits as its largest cap requires; a cap is the value
// above which the clock is not distinguished (ir/network_clocks.hpp). Scratch variables follow the stored words. Each
// scratch variable is written before it is read, so scratch variables are neither cleared nor compared.
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

/// An interval of clock values that constraints admit (ir/network_clocks.hpp).
using Interval = ClockInterval;

/// Returns a text that names the first element for which integer time may be inexact: a strict constraint, or an urgent
/// edge that may become disabled as time passes. Returns nullopt if there is no such element.
std::optional<std::string> inexact_place(const Network& network);

using Word = std::uint64_t;

struct Field {
    std::uint16_t word = 0;
    std::uint8_t shift = 0;
    std::uint8_t width = 0;  ///< number of bits; 0 if the value is always `low`
    std::int64_t low = 0;    ///< value that the field represents if all its bits are 0

    /// Returns a mask of `width` bits at position 0, without the shift to the position of the field.
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
    /// Maximum number of words of a state that fields can address; if a state needs more words, `fits` returns false.
    static constexpr std::size_t most_text = std::size_t{1} << 16U;
    bool fits() const { return words <= most_text; }

    std::vector<Field> locations = {};            ///< one field per process
    std::vector<Field> variables = {};            ///< one field per variable
    std::vector<std::vector<Field>> clocks = {};  ///< one field per process and clock

    /// For each input choice: the field that stores the set of possible valuations. The field has width 0 if the set is
    /// not stored.
    std::vector<Field> choices = {};
    std::size_t stored = 1;  ///< number of words that are stored for a state
    std::size_t words = 1;   ///< number of words including scratch variables
    std::size_t halves = 1;  ///< number of 32-bit units that contain all stored bits

    /// Indices of the 32-bit units at which the fields of a subsystem begin, except for the first subsystem.
    std::vector<std::size_t> seams = {};
};

/// A set of variables of a network: one element per variable, which is true if the set contains the variable.
using VariableSet = std::vector<bool>;

/// Returns the variables of `network`, except steps, that affect neither a guard, nor a property, nor a model error. No
/// process reads such a variable, except the only process that writes it, in assignments to such variables. An example
/// is a counter that only counts. Requires that `network` is expanded.
VariableSet unread_variables(const Network& network);

/// Computes the layout of `network`, which must be expanded. Variables for which `unread` is true are not stored; they
/// follow the stored words like scratch variables.
Layout layout_of(const Network& network, const std::vector<ProcessClocks>& clocks,
                 const std::vector<InputChoice>& choices = {}, const VariableSet& unread = {});

/// Returns the initial state in packed form, with layout.words words.
std::vector<Word> packed_initial(const Network& network, const Layout& layout);

}  // namespace grafverif::timed
