// SPDX-License-Identifier: MIT
// Writing: how wide texts are, how they are broken into lines, and how terms of a chart are written on a drawing.
//
// A character counts as wide as in the wider of DejaVu Sans and Liberation Sans (Arial has the same widths); those that
// neither is sure to have count as an em and a bit.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/drawing.hpp"

namespace grafverif::draw {

inline constexpr std::string_view font_family = "'DejaVu Sans', 'Liberation Sans', Arial, Helvetica, sans-serif";

/// Characters of a name that are drawn; its element's title has more of it.
inline constexpr std::size_t longest_name = 40;

using Runs = std::vector<Drawing::Run>;

/// Pixels, at most, of one line in a font of `size` pixels.
int width_of(std::string_view text, int size);
int width_of(const Runs& runs, int size);

/// `runs` in lines of at most `width` where blanks allow it; a longer word stands alone. What does not fit into
/// `most_lines` is an ellipsis.
std::vector<Runs> wrapped(const Runs& runs, int size, int width);
inline constexpr std::size_t most_lines = 24;

/// The text without its lines above: `!a` for a negated `a`.
std::string plain_text(const Runs& runs);

/// `text` with at most so many characters, the last of those then being an ellipsis.
std::string shortened(std::string_view text, std::size_t characters);

/// How the terms of a chart are written on its drawing. Steps whose name no other partial chart uses need none of its
/// own: `XW1` for `watchdog.XW1`.
class Writing {
public:
    Writing(const Chart& chart, Notation notation);

    Notation notation() const { return notation_; }
    /// A term in one line. Iec (IEC 60848, 4.3 and 4.4): `·`, `+`, a line above what is negated, `↑`, `↓`, predicates in
    /// square brackets; within a negated term `¬`.
    Runs runs(Id<Expr> term) const;
    /// `X2`, `G1.X2`.
    const std::string& step(Id<Chart::Step> step) const { return steps_[step.index]; }

private:
    std::string marked(Id<Expr> term) const;
    void print_leaf(std::ostream& out, const Expr& node) const;

    const Chart& chart_;
    Notation notation_;
    std::vector<std::string> steps_ = {};
};

}  // namespace grafverif::draw
