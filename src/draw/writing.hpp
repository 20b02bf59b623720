// SPDX-License-Identifier: MIT
// Computes widths of texts, breaks lines, and writes the terms of a chart in the notation of drawings.
//
// The width of a character is the maximum of its widths in DejaVu Sans and Liberation Sans (Arial has the same widths).
// A character that may be missing in both fonts is assumed to be slightly wider than the font size (em).
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/drawing.hpp"

namespace grafverif::draw {

inline constexpr std::string_view font_family = "'DejaVu Sans', 'Liberation Sans', Arial, Helvetica, sans-serif";

/// Maximum number of characters of a name in a drawing. The title of the element may be longer.
inline constexpr std::size_t longest_name = 40;

using Runs = std::vector<Drawing::Run>;

/// Returns an upper bound for the width, in pixels, of one line in a font of `size` pixels.
int width_of(std::string_view text, int size);
int width_of(const Runs& runs, int size);

/// Returns `runs` as lines of at most `width` pixels, broken at spaces. A word that is wider than `width` has a
/// separate line. Text beyond `most_lines` lines is replaced by an ellipsis.
std::vector<Runs> wrapped(const Runs& runs, int size, int width);
inline constexpr std::size_t most_lines = 24;

/// Returns the text without overlines: `!a` for a negated `a`.
std::string plain_text(const Runs& runs);

/// Returns `text`, truncated after `characters` characters. An ellipsis follows truncated text.
std::string shortened(std::string_view text, std::size_t characters);

/// Writes the terms of a chart in the notation of its drawing. A step whose name is unique among all partial charts is
/// not qualified: `XW1` instead of `watchdog.XW1`.
class Writing {
public:
    Writing(const Chart& chart, Notation notation);

    Notation notation() const { return notation_; }
    /// Returns a term on one line. In the notation Iec (IEC 60848) it uses `·`, `+`, an overline for negation, `↑`,
    /// `↓`, and predicates in square brackets; within a negated term it uses `¬`.
    Runs runs(Id<Expr> term) const;
    /// Returns the step variable: `X2`, `G1.X2`.
    const std::string& step(Id<Chart::Step> step) const { return steps_[step.index]; }

private:
    std::string marked(Id<Expr> term) const;
    void print_leaf(std::ostream& out, const Expr& node) const;

    const Chart& chart_;
    Notation notation_;
    std::vector<std::string> steps_ = {};
};

}  // namespace grafverif::draw
