// SPDX-License-Identifier: MIT
// Writes results of tuning as text and as JSON.
//
// A point is one combination of values of the tuned constants. If the verdict on a property is the same at all points,
// the text contains this verdict. If the verdict differs between points, the text contains a table of intervals (one
// constant), a map with one character per point (two constants), or a table of boxes. Then the text lists the margins.
// A margin is the smallest change of one constant from its current value that changes the verdict, while all other
// constants keep their current values.
//
// JSON: missing values are null.
//
//   {"model", "engine", "mode", "grain", "time_unit", "constants":[{"name", "low", "high", "step", "current"}],
//   "points", "checks", "transferred", "properties":[PROPERTY]}
//   PROPERTY  {"name", "text", "file", "line", "column", "declared", "expected", "current", "boxes":[BOX],
//             "margins":[MARGIN]}
//   BOX       {"constants":{NAME:[low, high]}, "points", "verdict", "reason"}
//   MARGIN    {"constant", "direction":"down|up", "value", "distance", "verdict"}; `value` is the first value with
//             another verdict
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "grafverif/support/source.hpp"
#include "ir/tuning.hpp"

namespace grafverif {

/// Returns a value of the constant as text: `4`, `3s`.
std::string value_text(const TunedConstant& constant, std::int64_t value);
/// Returns the values at a point as text: `N = 3, FILL = 2s`.
std::string point_text(const Tuning& tuning, std::size_t point);

/// Returns the values from `first` to `last`, which are indices, as text: `1s..6s`, `4`.
std::string range_text(const TunedConstant& constant, std::size_t first, std::size_t last);
/// Returns text such as `RAM = 1s..12s in steps of 1s; current value 3s`.
std::string grid_text(const TunedConstant& constant);
/// Returns the verdict as text; for an unknown verdict, with its reason.
std::string verdict_text(const Tuning& tuning, const PointVerdict& verdict);
/// True if the report shows the results for a property. An undeclared `no timelock` is shown only if it is violated at
/// a point, or if a model error makes its verdict at a point unknown.
bool is_shown(const Tuning& tuning, const Tuning::Row& row);
/// True if the verdicts are the same at all points.
bool is_uniform(const Tuning::Row& row);
/// Maximum number of columns and of rows of a map. Larger grids are shown as tables of boxes.
inline constexpr std::size_t widest_map = 40, tallest_map = 60;

/// Returns disjoint boxes (ranges of values for all constants) that cover the grid. Each box has one verdict on the
/// property of `row`. The boxes are in the order of their first points.
std::vector<GridBox> boxes_of(const Tuning& tuning, const Tuning::Row& row);

/// The value of a constant that is nearest to its current value and at which the verdict differs from the verdict for
/// the current values.
struct Margin {
    std::size_t constant = 0;
    bool up = true;
    std::int64_t value = 0, distance = 0;
    PointVerdict verdict = {};
};
/// Returns the margins of a property. A constant has no margins if the current value of another constant is not on the
/// grid.
std::vector<Margin> margins_of(const Tuning& tuning, const Tuning::Row& row);
/// Returns a sentence per margin, such as `violated at RAM = 7s, 4s above the current value 3s`.
std::vector<std::string> margin_sentences(const Tuning& tuning, const Tuning::Row& row);

void print_tuning(const Tuning& tuning, std::ostream& out);
std::string tuning_json(const Tuning& tuning, const Sources& sources);

}  // namespace grafverif
